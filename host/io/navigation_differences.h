#pragma once

#include "zonegrid/sensors.h"

#include <span>

namespace zonegrid {

/// Samples further apart than this are no neighbours: what lies between is unknown.
inline constexpr double navigation_gap_s = 0.1;

/// Velocities from positions, by differences of neighbouring samples: central, one-sided at the
/// ends and beside gaps, zero for a sample without any neighbour. Accelerations become zero.
/// `samples` are in strictly increasing order of time.
void derive_velocities(std::span<NavigationSample> samples);

/// The same for turn rates in the body frame: the rotation vector of q(i-1)^-1 q(i+1), divided by
/// the time between.
void derive_body_rates(std::span<NavigationSample> samples);

} // namespace zonegrid
