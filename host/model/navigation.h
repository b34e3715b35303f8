#pragma once

#include "zonegrid/sensors.h"

#include <Eigen/Geometry>

#include <deque>
#include <optional>

namespace zonegrid {

/// The latest navigation samples, and the pose between them (docs/model.md, section 2).
class NavigationBuffer {
public:
    /// Throws InputError if the sample is not finite, its attitude is no unit quaternion (norm off
    /// by more than 1e-3), or its time is not after the last one.
    void add(const NavigationSample& sample);

    /// Pose of the body at `time_s`: from the nearest sample with constant acceleration and
    /// constant turn rate. Nothing if none lies within `max_gap_s`.
    [[nodiscard]] std::optional<Eigen::Isometry3d> world_from_body(double time_s,
                                                                   double max_gap_s) const;

private:
    std::deque<NavigationSample> samples_;
};

/// The sample carried over `dt_s` (either sign).
[[nodiscard]] Eigen::Isometry3d extrapolate_pose(const NavigationSample& sample, double dt_s);

/// Pose of a sensor on the body, summed in the order docs/model.md gives.
[[nodiscard]] Eigen::Isometry3d mount_sensor(const Eigen::Isometry3d& world_from_body,
                                             const Eigen::Isometry3d& body_from_sensor);

} // namespace zonegrid
