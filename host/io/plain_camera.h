#pragma once

#include "io/description_table.h"
#include "zonegrid/sensors.h"

#include <filesystem>

namespace zonegrid {

/// Reads the table [camera] of a plain recording: an ideal pinhole, a pinhole behind a lens
/// (Brown-Conrady, turned into directions) or a table of directions in a file of `folder`. Mounting
/// and stereo noise are left at their defaults. Throws InputError naming file, line and key.
[[nodiscard]] Camera read_plain_camera(DescriptionTable& table,
                                       const std::filesystem::path& folder);

/// Sets fx, fy, cx and cy to the straight lines closest to the camera's table of directions. False
/// if these do not grow with the pixel, to the right and downwards; then the four mean nothing.
[[nodiscard]] bool fit_mean_spacing(Camera& camera);

} // namespace zonegrid
