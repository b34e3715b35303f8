#pragma once

#include "io/depth_decoder.h"
#include "io/recording.h"
#include "zonegrid/sensors.h"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zonegrid {

/// A navigation sample whose attitude is the one that these angles give.
struct EulerSample {
    NavigationSample sample;
    Eigen::Vector3d roll_pitch_yaw_rad = Eigen::Vector3d::Zero();
};

/// How a sensor sits in the body: position in metres, then roll, pitch and yaw in degrees from
/// looking forward, as description.toml gives them.
struct SensorMounting {
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d roll_pitch_yaw_deg = Eigen::Vector3d::Zero();
};

/// The mounting of a camera as description.toml gives it.
[[nodiscard]] SensorMounting mounting_of(const Eigen::Isometry3d& body_from_camera);

/// What a description.toml says.
struct PlainSensor {
    std::optional<Camera> camera; ///< absent: a laser scanner
    SensorMounting mounting;
    std::optional<DepthCoding> coding; ///< absent: the defaults
    std::string table;                 ///< file of the camera's directions, if it has them
    std::vector<std::string> comments; ///< lines at the top
    /// Of a simulated flight.
    std::optional<std::string> truth_digest{};
};

// The files of a plain recording (docs/formats.md); what is read back is the same, bit for bit.
// All throw OutputError.

void write_plain_description(const std::filesystem::path& file, const PlainSensor& sensor);
void write_navigation_csv(const std::filesystem::path& file, std::span<const EulerSample> samples);
void write_frames_csv(const std::filesystem::path& file, std::span<const FrameEntry> frames);

} // namespace zonegrid
