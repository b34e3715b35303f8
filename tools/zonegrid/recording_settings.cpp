#include "recording_settings.h"

#include <algorithm>
#include <array>

namespace zonegrid {
namespace {

/// The words that description.toml uses too.
struct NamedAxes {
    const char* name;
    WorldAxes axes;
};

constexpr std::array<NamedAxes, 5> named_world_axes{
    {{"layout_default", WorldAxes::layout_default},
     {"north_east_down", WorldAxes::north_east_down},
     {"east_north_up", WorldAxes::east_north_up},
     {"z_up", WorldAxes::z_up},
     {"y_down", WorldAxes::y_down}}};

std::vector<std::string> axes_names() {
    std::vector<std::string> names;
    std::ranges::transform(named_world_axes, std::back_inserter(names), &NamedAxes::name);
    return names;
}

bool any_text(const std::string& text) {
    return !text.empty();
}

bool is_positive(double value) {
    return value > 0.0;
}

bool any_four(const std::array<double, 4>& /*values*/) {
    return true; // open_recording() knows what makes a camera
}

} // namespace

void add_recording_settings(SettingTable& table, RecordingSettings& settings) {
    table.start_group("Recording");
    Setting recording = bind_setting("recording", "RECORDING",
                                     "folder with depth images or laser scans and navigation",
                                     settings.recording, {any_text, "the name of a folder"});
    recording.positional = true;
    table.add(std::move(recording));
    table.add(bind_setting(
        "layout", "NAME", "how the recording is laid out: auto, tum, poses, kitti, clouds, plain",
        settings.layout, one_of({"auto", "tum", "poses", "kitti", "clouds", "plain"})));
    table.add(bind_setting("world-axes", "NAME",
                           "axes of the recording's world: layout_default, north_east_down, "
                           "east_north_up, z_up, y_down",
                           settings.world_axes, one_of(axes_names())));
    Setting intrinsics =
        bind_setting("intrinsics", "FX FY CX CY", "camera in pixels, in place of the recording's",
                     settings.intrinsics, {any_four, "four numbers: fx fy cx cy in pixels"});
    intrinsics.arguments = 4;
    table.add(std::move(intrinsics));
    table.add(bind_setting("depth-scale", "UNITS",
                           "value of a 16-bit depth pixel at 1 m, such as 1000 or 5000",
                           settings.depth_scale,
                           finite_where([](double value) { return value >= 1e-3 && value <= 1e6; },
                                        "units a metre, from 0.001 to 1e6")));
    table.add(bind_setting("baseline", "M", "distance between the cameras of a stereo pair, metres",
                           settings.baseline,
                           finite_where(is_positive, "a length above 0 in metres")));
    table.add(bind_setting("disparity-sigma", "PX",
                           "standard deviation of a stereo disparity, pixels; spreads obstacles in "
                           "the span model",
                           settings.disparity_sigma,
                           finite_where(is_positive, "a number of pixels above 0")));
}

std::unique_ptr<Recording> open_recording(const RecordingSettings& settings) {
    if (!settings.recording) {
        throw UsageError("RECORDING is missing: name the folder that holds the recording");
    }
    if (settings.baseline.has_value() != settings.disparity_sigma.has_value()) {
        throw UsageError("--baseline and --disparity-sigma belong together: give both or neither");
    }
    RecordingOptions options;
    options.layout = settings.layout;
    options.world_axes = std::ranges::find_if(named_world_axes, [&](const auto& named) {
                             return settings.world_axes == named.name;
                         })->axes;
    options.intrinsics = settings.intrinsics;
    options.depth_units_per_m = settings.depth_scale;
    if (settings.baseline) {
        options.stereo = StereoNoise{*settings.baseline, *settings.disparity_sigma};
    }
    return open_recording(std::filesystem::path(*settings.recording), options);
}

} // namespace zonegrid
