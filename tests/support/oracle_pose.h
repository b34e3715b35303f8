#pragma once

#include "zonegrid/sensors.h"

#include <array>
#include <optional>
#include <vector>

namespace zonegrid::oracle {

using Triple = std::array<double, 3>;
using Rotation = std::array<Triple, 3>; ///< rows

/// Where a sensor is and how it is turned, in the world frame, metres.
struct Pose {
    Triple position_m{};
    Rotation rotation{};
};

/// `(R_i0 w_0 + R_i1 w_1) + R_i2 w_2`, rounded after each operation.
[[nodiscard]] Triple rotate(const Rotation& rotation, const Triple& vector);

/// World pose of a sensor at `time_s` from all samples so far (docs/model.md, section 2); nothing
/// if none is within `max_gap_s`.
[[nodiscard]] std::optional<Pose> sensor_pose(const std::vector<NavigationSample>& samples,
                                              double time_s, double max_gap_s,
                                              const Eigen::Isometry3d& body_from_sensor);

} // namespace zonegrid::oracle
