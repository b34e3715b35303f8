#pragma once

#include "io/recording.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <span>

namespace zonegrid {

/// How well pairs of frames agree when points of one are carried into the other: with the poses as
/// the recording states them, and with their inverses. Poses that are given inside out (camera from
/// world) agree far better inverted.
struct PoseDirection {
    std::size_t pairs = 0;
    std::size_t points = 0; ///< compared with the stated poses
    double stated_m = 0.0;  ///< median difference in depth, or to the nearest point of a scan
    double inverse_m = 0.0; ///< infinite if no point falls into the other frame
    [[nodiscard]] bool inside_out() const { return inverse_m < 0.5 * stated_m; }
};

/// Compares a few pairs between which the sensor moved. `world_from_sensor` has an entry a frame,
/// empty where there is no pose; `depth_m` is a typical distance in the recording.
/// Nothing if the sensor never moves enough or frames cannot be read. Reads up to six frames.
[[nodiscard]] std::optional<PoseDirection> check_pose_direction(
    const Recording& recording, std::span<const std::optional<Eigen::Isometry3d>> world_from_sensor,
    double depth_m);

} // namespace zonegrid
