#include "io/plain_writer.h"

#include "io/output_file.h"
#include "io/readable_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

namespace zonegrid {
namespace {

constexpr double deg_per_rad = 180.0 / std::numbers::pi;

void write_text(const std::filesystem::path& file, const std::string& text) {
    OutputFile output(file);
    output.write(text);
    output.close();
}

/// The shortest decimal number that is read back as the same double.
std::string number_text(double value) {
    const std::string text = fmt::format("{}", value);
    // TOML takes a number without a point for a whole one, of at most 64 bits.
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string list_text(const Eigen::Vector3d& values) {
    return fmt::format("{}, {}, {}", number_text(values.x()), number_text(values.y()),
                       number_text(values.z()));
}

std::string csv_text(const Eigen::Vector3d& values) {
    return fmt::format(",{},{},{}", values.x(), values.y(), values.z());
}

std::string camera_text(const Camera& camera, const std::string& table) {
    std::string text =
        fmt::format("[camera]\nwidth_px = {}\nheight_px = {}\n", camera.width_px, camera.height_px);
    if (table.empty()) {
        text += fmt::format("model = \"pinhole\"\nfx_px = {}\nfy_px = {}\ncx_px = {}\ncy_px = {}\n",
                            number_text(camera.fx_px), number_text(camera.fy_px),
                            number_text(camera.cx_px), number_text(camera.cy_px));
    } else {
        text += fmt::format("model = \"table\"\ntable = \"{}\"\n", table);
    }
    if (camera.stereo) {
        text += fmt::format("\n[stereo]\nbaseline_m = {}\ndisparity_sigma_px = {}\n",
                            number_text(camera.stereo->baseline_m),
                            number_text(camera.stereo->disparity_sigma_px));
    }
    return text;
}

std::string coding_text(const DepthCoding& coding) {
    return fmt::format(
        "\n[depth]\nunits_per_m = {}\nkind = \"{}\"\nmissing = [{}]\ninfinite = [{}]\n",
        number_text(coding.units_per_m), coding.kind == DepthKind::axis ? "axis" : "ray",
        fmt::join(coding.missing, ", "), fmt::join(coding.infinite, ", "));
}

} // namespace

SensorMounting mounting_of(const Eigen::Isometry3d& body_from_camera) {
    // Where the sensor looks straight up or down, roll and yaw turn about the same line: yaw alone.
    constexpr double vertical = 1e-9;
    const Eigen::Matrix3d turn = body_from_camera.linear() * body_from_forward_camera().transpose();
    const double level = std::hypot(turn(2, 1), turn(2, 2));
    const bool turns_once = level < vertical;
    const double roll_rad = turns_once ? 0.0 : std::atan2(turn(2, 1), turn(2, 2));
    const double pitch_rad = std::atan2(-turn(2, 0), level);
    const double yaw_rad =
        turns_once ? std::atan2(-turn(0, 1), turn(1, 1)) : std::atan2(turn(1, 0), turn(0, 0));
    // 0 added: -0 reads oddly.
    return {body_from_camera.translation(),
            deg_per_rad * Eigen::Vector3d(roll_rad + 0.0, pitch_rad + 0.0, yaw_rad + 0.0)};
}

void write_plain_description(const std::filesystem::path& file, const PlainSensor& sensor) {
    std::string text;
    for (const std::string& comment : sensor.comments) {
        text += fmt::format("# {}\n", readable_text(comment));
    }
    text += sensor.camera ? camera_text(*sensor.camera, sensor.table) : std::string("[scanner]\n");
    if (sensor.coding) {
        text += coding_text(*sensor.coding);
    }
    const Eigen::Vector3d& angles_deg = sensor.mounting.roll_pitch_yaw_deg;
    text += fmt::format(
        "\n[mounting]\nposition_m = [{}]\nroll_deg = {}\npitch_deg = {}\nyaw_deg = {}\n",
        list_text(sensor.mounting.position_m), number_text(angles_deg.x()),
        number_text(angles_deg.y()), number_text(angles_deg.z()));
    if (sensor.truth_digest) {
        text += fmt::format("\n[truth]\ndigest = \"{}\"\n", *sensor.truth_digest);
    }
    write_text(file, text);
}

void write_navigation_csv(const std::filesystem::path& file, std::span<const EulerSample> samples) {
    std::string text =
        "time_s,north_m,east_m,down_m,roll_rad,pitch_rad,yaw_rad,north_mps,east_mps,down_mps,"
        "north_mps2,east_mps2,down_mps2,roll_radps,pitch_radps,yaw_radps\n";
    for (const EulerSample& state : samples) {
        const NavigationSample& sample = state.sample;
        text += fmt::format("{}", sample.time_s);
        for (const Eigen::Vector3d& values :
             {sample.position_m, state.roll_pitch_yaw_rad, sample.velocity_mps,
              sample.acceleration_mps2, sample.body_rate_radps}) {
            text += csv_text(values);
        }
        text += "\n";
    }
    write_text(file, text);
}

void write_frames_csv(const std::filesystem::path& file, std::span<const FrameEntry> frames) {
    std::string text = "time_s,file\n";
    for (const FrameEntry& frame : frames) {
        text += fmt::format("{},{}\n", frame.time_s, frame.file.string());
    }
    write_text(file, text);
}

} // namespace zonegrid
