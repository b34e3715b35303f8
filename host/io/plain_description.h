#pragma once

#include "io/depth_decoder.h"
#include "io/recording.h"

#include <filesystem>
#include <optional>
#include <string>

namespace zonegrid {

/// What description.toml says of a recording of the plain layout.
struct PlainDescription {
    std::optional<Camera> camera; ///< absent: a laser scanner
    Eigen::Isometry3d body_from_sensor = Eigen::Isometry3d::Identity();
    DepthCoding coding;
    bool depth_scale_given = false; ///< PNG depth needs it
    WorldAxes world_axes = WorldAxes::north_east_down;
    std::optional<GeoOrigin> origin;
    std::optional<std::string> truth_digest; ///< 64 lower-case hexadecimal digits
};

/// Reads and checks a description; docs/formats.md lists its keys.
/// Throws InputError naming file, line and key, also for a key that is unknown.
[[nodiscard]] PlainDescription read_plain_description(const std::filesystem::path& file);

/// The sensor's axes in the body's: turned from looking forward by yaw, then pitch, then roll.
[[nodiscard]] Eigen::Matrix3d mounted_rotation(double roll_deg, double pitch_deg, double yaw_deg,
                                               const Eigen::Matrix3d& body_from_forward);

} // namespace zonegrid
