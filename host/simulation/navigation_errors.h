#pragma once

#include "io/plain_writer.h"
#include "simulation/faults.h"

#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid {

/// Standard deviations of the published system's navigation, at scale 1.
struct NavigationDeviations {
    double north_m = 0.20;
    double east_m = 0.20;
    double height_m = 0.50;
    double yaw_deg = 3.0;
    double pitch_deg = 4.0;
    double roll_deg = 0.7;
};

/// The navigation as the filter says it: each component of position and attitude carries an error
/// of its own, a first-order Gauss-Markov process that is stationary from the first sample on, and
/// white noise of a tenth of its deviation. Velocities, accelerations and rates stay true: errors
/// that vary over a minute hardly show in them.
[[nodiscard]] std::vector<EulerSample> with_errors(std::span<const EulerSample> truth,
                                                   const NavigationFaults& faults,
                                                   std::uint64_t seed);

} // namespace zonegrid
