#include "io/image_recording.h"

#include "zonegrid/errors.h"

#include <optional>
#include <utility>

namespace zonegrid {

ImageRecording::ImageRecording(RecordingContents contents, DepthCoding coding)
    : Recording(std::move(contents)), decoder_(std::move(coding), camera().value()) {}

FrameData ImageRecording::read_frame(std::size_t index) const {
    require_frame(index);
    FrameData data;
    data.depth_m = decoder_.decode(frames()[index].file);
    return data;
}

Camera forward_pinhole(ImageSize size, const std::array<double, 4>& intrinsics,
                       const RecordingOptions& options) {
    Camera camera;
    camera.width_px = size.width_px;
    camera.height_px = size.height_px;
    camera.fx_px = intrinsics[0];
    camera.fy_px = intrinsics[1];
    camera.cx_px = intrinsics[2];
    camera.cy_px = intrinsics[3];
    camera.stereo = options.stereo;
    camera.body_from_camera.linear() = body_from_forward_camera();
    return camera;
}

ImageSize size_of_first_image(std::span<const FrameEntry> frames) {
    std::optional<InputError> first_error;
    for (const FrameEntry& frame : frames) {
        try {
            return read_depth_png_size(frame.file);
        } catch (const InputError& error) {
            if (!first_error) {
                first_error = error;
            }
        }
    }
    throw first_error.value();
}

} // namespace zonegrid
