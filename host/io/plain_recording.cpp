#include "io/csv_table.h"
#include "io/frame_list.h"
#include "io/image_recording.h"
#include "io/navigation_csv.h"
#include "io/plain_description.h"
#include "io/pose_conversion.h"
#include "io/recording_layouts.h"
#include "io/scan_recording.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <utility>

namespace zonegrid {
namespace {

std::vector<FrameEntry> read_frames(const std::filesystem::path& folder,
                                    std::vector<RecordingWarning>& warnings) {
    CsvTable table(folder / "frames.csv");
    const std::size_t time_column = table.need("time_s");
    const std::size_t file_column = table.need("file");
    table.require_all_read();
    FrameList frames(folder / "frames.csv");
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        frames.add(table.number(row, time_column), folder / table.text(row, file_column),
                   table.place(row));
    }
    return frames.take(warnings);
}

void apply_options(const RecordingOptions& options, PlainDescription& description) {
    Camera& camera = *description.camera;
    if (options.intrinsics) {
        if (!camera.directions.empty()) {
            throw UsageError(
                "the recording's camera is no ideal pinhole and its directions follow "
                "from description.toml; leave out the intrinsics");
        }
        camera.fx_px = (*options.intrinsics)[0];
        camera.fy_px = (*options.intrinsics)[1];
        camera.cx_px = (*options.intrinsics)[2];
        camera.cy_px = (*options.intrinsics)[3];
    }
    if (options.stereo) {
        camera.stereo = options.stereo;
    }
    if (options.depth_units_per_m) {
        description.coding.units_per_m = *options.depth_units_per_m;
        description.depth_scale_given = true;
    }
}

void require_depth_scale(const PlainDescription& description, const std::vector<FrameEntry>& frames,
                         const std::filesystem::path& description_file) {
    const bool any_png = std::ranges::any_of(
        frames, [](const FrameEntry& frame) { return frame.file.extension() == ".png"; });
    if (any_png && !description.depth_scale_given) {
        throw InputError(description_file.string(), "depth.units_per_m is missing",
                         "PNG depth needs the pixel value that stands for 1 m, such as 1000");
    }
}

} // namespace

bool is_plain_recording(const std::filesystem::path& folder) {
    std::error_code error;
    return std::filesystem::is_regular_file(folder / "description.toml", error);
}

std::unique_ptr<Recording> open_plain_recording(const std::filesystem::path& folder,
                                                const RecordingOptions& options) {
    const std::filesystem::path description_file = folder / "description.toml";
    PlainDescription description = read_plain_description(description_file);
    if (description.camera) {
        apply_options(options, description);
    } else {
        require_no_camera_options(options, "plain with a [scanner]");
    }
    const WorldAxes axes = options.world_axes == WorldAxes::layout_default ? description.world_axes
                                                                           : options.world_axes;
    RecordingContents contents;
    contents.layout = "plain";
    contents.path = folder;
    contents.camera = std::move(description.camera);
    contents.body_from_sensor = description.body_from_sensor;
    contents.origin = description.origin;
    contents.truth_digest = std::move(description.truth_digest);
    contents.navigation = read_navigation_csv(folder / "navigation.csv", axes);
    contents.frames = read_frames(folder, contents.warnings);
    contents.notes.push_back(fmt::format("World: {}.", name_of(axes)));
    if (!contents.camera) {
        return std::make_unique<ScanRecording>(std::move(contents), PointFields::xyz);
    }
    require_depth_scale(description, contents.frames, description_file);
    contents.notes.push_back(
        fmt::format("Depth: {} units per metre along the {}.", description.coding.units_per_m,
                    description.coding.kind == DepthKind::axis ? "optical axis" : "ray"));
    return std::make_unique<ImageRecording>(std::move(contents), std::move(description.coding));
}

} // namespace zonegrid
