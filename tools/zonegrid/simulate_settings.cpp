#include "simulate_settings.h"

#include "io/depth_png.h"
#include "truth/truth_folder.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace zonegrid {
namespace {

constexpr double ms_per_s = 1000.0;
constexpr double highest_rate_hz = 1000.0;
constexpr double longest_s = 86400.0;

/// The strengths of --all-faults, in the order of --help.
SensorFaults usual_sensor_faults(const Camera& camera) {
    SensorFaults faults;
    faults.disparity_sigma_px = camera.stereo ? camera.stereo->disparity_sigma_px : 0.0;
    faults.disparity_step_px = 0.0625;
    faults.missing = 1.0;
    faults.bleeding_px = 2;
    faults.outlier_share = 0.0005;
    faults.vibration_deg = 0.1;
    return faults;
}

std::optional<ImageSize> parse_size(std::string_view text) {
    ImageSize size;
    const char* const end = text.data() + text.size();
    const auto [cross, first_error] = std::from_chars(text.data(), end, size.width_px);
    if (first_error != std::errc{} || cross == end || *cross != 'x') {
        return std::nullopt;
    }
    const auto [stop, second_error] = std::from_chars(cross + 1, end, size.height_px);
    const auto fits = [](int edge_px) { return edge_px >= 1 && edge_px <= largest_image_px; };
    if (second_error != std::errc{} || stop != end || !fits(size.width_px) ||
        !fits(size.height_px)) {
        return std::nullopt;
    }
    return size;
}

std::optional<std::uint64_t> parse_seed(std::string_view text) {
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seed);
    return error == std::errc{} && stop == end ? std::optional(seed) : std::nullopt;
}

Rule<double> from_to(double low, double high, const char* words) {
    return finite_where([=](double value) { return value >= low && value <= high; }, words);
}

Rule<double> above(double low, double high, const char* words) {
    return finite_where([=](double value) { return value > low && value <= high; }, words);
}

Rule<double> share() {
    return from_to(0.0, 1.0, "a share from 0 to 1");
}

Rule<std::string> not_empty(const char* words) {
    return {[](const std::string& text) { return !text.empty(); }, words};
}

void add_scene_settings(SettingTable& table, SimulateSettings& settings) {
    table.start_group("Flight");
    Setting scene =
        bind_setting("scene", "SCENE", "file of a scene, or its name in the folder scenes",
                     settings.scene, not_empty("the name of a scene"));
    scene.positional = true;
    table.add(std::move(scene));
    table.add(bind_setting("seed", "N", "whole number that everything random comes from, 0 or more",
                           settings.seed,
                           {[](const std::string& text) { return parse_seed(text).has_value(); },
                            "a whole number, 0 or more"}));
    table.add(bind_setting("seconds", "S", "length of the flight, in place of the scene's",
                           settings.seconds,
                           above(0.0, longest_s, "a time above 0, up to 86400 seconds")));
    table.add(bind_setting("rate", "HZ", "images a second, in place of the scene's",
                           settings.rate_hz,
                           above(0.0, highest_rate_hz, "a rate above 0, up to 1000 Hz")));
    table.add(bind_setting("size", "WxH",
                           "size of the images in pixels, such as 320x240; the field of view stays",
                           settings.size,
                           {[](const std::string& text) { return parse_size(text).has_value(); },
                            "width x height in pixels, such as 640x480, each 1 to 16384"}));
}

void add_sensor_settings(SettingTable& table, SimulateSettings& settings) {
    SensorFaults& faults = settings.sensor;
    table.start_group("Faults of the sensor (0: none)");
    table.add(bind_setting("stereo-noise", "PX", "standard deviation of disparities, pixels",
                           faults.disparity_sigma_px, from_to(0.0, 10.0, "0 to 10 pixels")));
    table.add(bind_setting("quantise", "PX", "disparities are whole multiples of this, pixels",
                           faults.disparity_step_px, from_to(0.0, 10.0, "0 to 10 pixels")));
    table.add(bind_setting("missing", "STRENGTH",
                           "no match where the second camera sees nothing, and where texture is "
                           "weak: by 1 less the texture, times this",
                           faults.missing, share()));
    table.add(bind_setting(
        "bleeding", "PX", "near surfaces spread over far ones by this many pixels",
        faults.bleeding_px,
        {[](int value) { return value >= 0 && value <= 16; }, "a whole number from 0 to 16"}));
    table.add(bind_setting("outliers", "SHARE", "share of pixels with a wrong match",
                           faults.outlier_share, share()));
    table.add(
        switch_setting("missing-sky", "sky is missing in place of infinite", faults.missing_sky));
    table.add(bind_setting("vibration", "DEG",
                           "the rotor shakes the camera by this much about each axis",
                           faults.vibration_deg, from_to(0.0, 10.0, "0 to 10 degrees")));
    table.add(bind_setting("screen", "PX",
                           "the camera films a screen: two exposures are mixed, and disparities "
                           "in moire stripes are off by this, pixels",
                           faults.screen_px, from_to(0.0, 10.0, "0 to 10 pixels")));
}

void add_navigation_settings(SettingTable& table, SimulateSettings& settings) {
    table.start_group("Faults of navigation and times (0: none)");
    table.add(bind_setting("navigation-errors", "SCALE",
                           "position and attitude are off, at 1 by north 0.20 m, east 0.20 m, "
                           "height 0.50 m, yaw 3.0, pitch 4.0, roll 0.7 degrees",
                           settings.navigation.scale, from_to(0.0, 100.0, "a scale, 0 to 100")));
    table.add(bind_setting(
        "navigation-constant", "S", "time constant of these slowly varying errors, seconds",
        settings.navigation.time_constant_s, from_to(1e-3, 1e6, "0.001 to 1e6 seconds")));
    table.add(bind_setting("late-images", "SHARE", "share of images whose time stamp is late",
                           settings.transfer.late_images, share()));
    table.add(bind_setting("late-by", "MS", "most that a time stamp is late, milliseconds",
                           settings.late_by_ms,
                           from_to(0.0, ms_per_s * most_lateness_s, "0 to 10000 ms")));
    table.add(bind_setting("lost-images", "SHARE", "share of images that are lost",
                           settings.transfer.lost_images, share()));
    table.add(bind_setting("lost-navigation", "SHARE", "share of navigation samples that are lost",
                           settings.transfer.lost_navigation, share()));
    table.add(switch_setting("all-faults",
                             "a real camera and navigation: --stereo-noise as the scene's camera "
                             "has it, --quantise 0.0625 --missing 1 --bleeding 2 --outliers 0.0005 "
                             "--vibration 0.1 --navigation-errors 1, but for those given",
                             settings.all_faults));
}

} // namespace

void add_simulate_settings(SettingTable& table, SimulateSettings& settings) {
    add_scene_settings(table, settings);
    add_sensor_settings(table, settings);
    add_navigation_settings(table, settings);
    table.start_group("Output");
    Setting output = bind_setting("output", "RECORDING", "folder to make for the recording",
                                  settings.output, not_empty("the name of the folder to make"));
    output.short_name = "o";
    table.add(std::move(output));
    table.add(
        switch_setting("overwrite", "replace RECORDING if it was simulated", settings.overwrite));
    table.add(switch_setting("quiet", "print neither summary nor progress", settings.quiet));
}

std::uint64_t seed_of(const SimulateSettings& settings) {
    return *parse_seed(settings.seed);
}

SimulationOptions simulation_options(const SimulateSettings& settings,
                                     const std::vector<std::string>& given, const Camera& camera) {
    SimulationOptions options;
    options.seed = seed_of(settings);
    options.duration_s = settings.seconds;
    options.sensor = settings.sensor;
    options.navigation = settings.navigation;
    options.transfer = settings.transfer;
    options.transfer.late_by_s = settings.late_by_ms / ms_per_s;
    if (settings.all_faults) {
        const SensorFaults usual = usual_sensor_faults(camera);
        const auto unless_given = [&given](const char* name, auto& value, auto usual_value) {
            if (std::ranges::find(given, name) == given.end()) {
                value = usual_value;
            }
        };
        SensorFaults& sensor = options.sensor;
        unless_given("stereo-noise", sensor.disparity_sigma_px, usual.disparity_sigma_px);
        unless_given("quantise", sensor.disparity_step_px, usual.disparity_step_px);
        unless_given("missing", sensor.missing, usual.missing);
        unless_given("bleeding", sensor.bleeding_px, usual.bleeding_px);
        unless_given("outliers", sensor.outlier_share, usual.outlier_share);
        unless_given("vibration", sensor.vibration_deg, usual.vibration_deg);
        unless_given("navigation-errors", options.navigation.scale, 1.0);
    }
    return options;
}

std::filesystem::path scene_file(const std::string& name) {
    std::error_code error;
    std::filesystem::path file = name;
    std::filesystem::path named = std::filesystem::path("scenes") / (name + ".toml");
    if (std::filesystem::is_regular_file(file, error)) {
        return file;
    }
    if (!file.has_parent_path() && std::filesystem::is_regular_file(named, error)) {
        return named;
    }
    throw UsageError(
        fmt::format("SCENE is {}: there is no such file, and no {}; name a scene's "
                    "TOML file",
                    name, named.string()));
}

void apply_camera_settings(const SimulateSettings& settings, Scene& scene) {
    scene.image_rate_hz = settings.rate_hz.value_or(scene.image_rate_hz);
    if (!settings.size) {
        return;
    }
    const ImageSize size = *parse_size(*settings.size);
    Camera& camera = scene.camera;
    const double wider = static_cast<double>(size.width_px) / camera.width_px;
    const double higher = static_cast<double>(size.height_px) / camera.height_px;
    camera.fx_px *= wider;
    camera.fy_px *= higher;
    camera.cx_px = (camera.cx_px + 0.5) * wider - 0.5; // pixels' middles are whole numbers
    camera.cy_px = (camera.cy_px + 0.5) * higher - 0.5;
    camera.width_px = size.width_px;
    camera.height_px = size.height_px;
}

} // namespace zonegrid
