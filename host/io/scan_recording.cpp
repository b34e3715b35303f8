#include "io/scan_recording.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <utility>

namespace zonegrid {

ScanRecording::ScanRecording(RecordingContents contents, PointFields fields)
    : Recording(std::move(contents)), fields_(fields) {}

FrameData ScanRecording::read_frame(std::size_t index) const {
    require_frame(index);
    FrameData data;
    data.ends_m = read_points(frames()[index].file, fields_);
    return data;
}

void require_no_camera_options(const RecordingOptions& options, const std::string& layout) {
    if (options.intrinsics || options.depth_units_per_m || options.stereo) {
        throw UsageError(
            fmt::format("a recording of layout {} is of a laser scanner; leave out "
                        "intrinsics, depth scale and stereo noise",
                        layout));
    }
}

} // namespace zonegrid
