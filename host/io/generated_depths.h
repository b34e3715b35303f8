#pragma once

#include "io/seeded_numbers.h"
#include "zonegrid/options.h"
#include "zonegrid/sensors.h"

#include <vector>

namespace zonegrid {

/// A random depth image of the camera's size: blank, sky, one pixel, noise, steps, a wall, depths
/// within a sub-cell of the range, or everything at once with the least and greatest floats.
[[nodiscard]] std::vector<float> generate_depths(SeededNumbers& numbers, const Camera& camera,
                                                 const MapperOptions& options);

/// The ends of a random scan's rays in the scanner's frame, some of them missing.
[[nodiscard]] std::vector<Eigen::Vector3f> generate_scan(SeededNumbers& numbers,
                                                         const MapperOptions& options);

} // namespace zonegrid
