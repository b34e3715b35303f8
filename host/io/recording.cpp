#include "io/recording.h"

#include "io/depth_decoder.h"
#include "io/recording_layouts.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <system_error>

namespace zonegrid {
namespace {

struct Layout {
    std::string_view name;
    std::string_view files; ///< what it is recognised by
    bool (*recognise)(const std::filesystem::path&);
    std::unique_ptr<Recording> (*open)(const std::filesystem::path&, const RecordingOptions&);
};

/// In the order in which they are tried.
constexpr std::array<Layout, 5> layouts{{
    {"plain", "description.toml", is_plain_recording, open_plain_recording},
    {"kitti", "oxts/ and velodyne_points/", is_kitti_recording, open_kitti_recording},
    {"clouds", "graph.txt", is_clouds_recording, open_clouds_recording},
    {"tum", "depth.txt or *association*.txt", is_tum_recording, open_tum_recording},
    {"poses", "frame-*.depth.png", is_poses_recording, open_poses_recording},
}};

bool is_positive(double value) {
    return std::isfinite(value) && value > 0.0;
}

void check_options(const RecordingOptions& options) {
    if (options.intrinsics) {
        const auto& [fx, fy, cx, cy] = *options.intrinsics;
        if (!is_positive(fx) || !is_positive(fy) || !std::isfinite(cx) || !std::isfinite(cy)) {
            throw UsageError(
                fmt::format("intrinsics {} {} {} {}: fx and fy must be above 0 and all "
                            "four finite; give fx fy cx cy in pixels",
                            fx, fy, cx, cy));
        }
    }
    if (options.depth_units_per_m && !is_depth_scale(*options.depth_units_per_m)) {
        throw UsageError(
            fmt::format("depth scale: {} units per metre is outside 0.001 ... 1e6; "
                        "give the pixel value that stands for 1 m, such as 1000",
                        *options.depth_units_per_m));
    }
    if (options.stereo && !(is_positive(options.stereo->baseline_m) &&
                            is_positive(options.stereo->disparity_sigma_px))) {
        throw UsageError(
            fmt::format("stereo noise: baseline {} m and disparity deviation {} px "
                        "must both be above 0",
                        options.stereo->baseline_m, options.stereo->disparity_sigma_px));
    }
}

const Layout& layout_named(const std::string& name) {
    const auto found = std::ranges::find(layouts, name, &Layout::name);
    if (found == layouts.end()) {
        throw UsageError(
            fmt::format("layout '{}' is unknown; give auto, tum, poses, kitti, clouds "
                        "or plain",
                        name));
    }
    return *found;
}

const Layout& recognise(const std::filesystem::path& folder) {
    std::string tried;
    for (const Layout& layout : layouts) {
        if (layout.recognise(folder)) {
            return layout;
        }
        tried += fmt::format("{}{} ({})", tried.empty() ? "" : ", ", layout.files, layout.name);
    }
    throw InputError(
        folder.string(),
        fmt::format("the folder is no recording of a known layout: it holds none of {}", tried),
        "name the folder that holds one of these");
}

} // namespace

void Recording::require_frame(std::size_t index) const {
    if (index >= frames().size()) {
        throw UsageError(fmt::format("frame {} does not exist; the recording has {} frames", index,
                                     frames().size()));
    }
}

std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                          const RecordingOptions& options) {
    check_options(options);
    const Layout* layout = options.layout == "auto" ? nullptr : &layout_named(options.layout);
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::canonical(path, error);
    if (error || !std::filesystem::is_directory(folder, error)) {
        throw InputError(path.string(), "there is no such folder",
                         "name the folder that holds the recording");
    }
    if (layout == nullptr) {
        layout = &recognise(folder);
    }
    return layout->open(folder, options);
}

} // namespace zonegrid
