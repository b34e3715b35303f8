#pragma once

#include "io/recording.h"

#include <filesystem>
#include <vector>

namespace zonegrid {

/// Reads the navigation.csv of a plain recording; docs/formats.md lists its columns. Positions in
/// x_m, y_m, z_m lie in the world `axes`; north_m, east_m, down_m go with north_east_down alone.
/// Velocities and turn rates that are not given come by differences.
/// Throws InputError naming file and line.
[[nodiscard]] std::vector<NavigationSample> read_navigation_csv(const std::filesystem::path& file,
                                                                WorldAxes axes);

} // namespace zonegrid
