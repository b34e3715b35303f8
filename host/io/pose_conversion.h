#pragma once

#include "io/recording.h"

#include <Eigen/Geometry>

#include <span>
#include <string>
#include <vector>

namespace zonegrid {

/// Turns vectors of a recording's world into north-east-down.
/// `axes` must not be `layout_default`: the reader of a layout resolves it first.
[[nodiscard]] Eigen::Matrix3d north_east_down_from(WorldAxes axes);

/// How messages and notes call the axes: the words that description.toml uses.
[[nodiscard]] std::string name_of(WorldAxes axes);

/// Turns the frame of common laser scanners (forward, left, up) into forward-right-down.
[[nodiscard]] Eigen::Matrix3d body_from_forward_left_up();

/// The quaternion, normalised. Throws InputError at `where` if its norm is off by more than 1e-2.
[[nodiscard]] Eigen::Quaterniond checked_quaternion(double x, double y, double z, double w,
                                                    const std::string& where);

/// The nearest rotation. Throws InputError at `where` if an entry of R'R differs from the unit
/// matrix by 1e-2 or more, or if `matrix` is a reflection.
[[nodiscard]] Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& matrix,
                                               const std::string& where);

/// The pose in seven fields "tx ty tz qx qy qz qw". Throws InputError at `where`.
[[nodiscard]] Eigen::Isometry3d parse_pose(std::span<const std::string, 7> fields,
                                           const std::string& where);

/// A sensor's pose in the recording's own world.
struct TimedPose {
    double time_s = 0.0;
    Eigen::Isometry3d world_from_sensor = Eigen::Isometry3d::Identity();
};

/// The navigation of the body that carries the sensor, with velocities and turn rates by
/// differences. `axes` is not `layout_default`; `poses` are in strictly increasing order of time.
[[nodiscard]] std::vector<NavigationSample> samples_of_poses(
    std::span<const TimedPose> poses, WorldAxes axes, const Eigen::Isometry3d& body_from_sensor);

/// What samples_of_poses takes for granted, as a note of the recording.
[[nodiscard]] std::string describe_pose_navigation(WorldAxes axes);

} // namespace zonegrid
