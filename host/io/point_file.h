#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <vector>

namespace zonegrid {

/// What stands for one point in a headerless binary or a text file.
enum class PointFields {
    xyz,            ///< x y z
    xyz_reflectance ///< x y z and a reflectance, which is not used
};

/// Reads the points of one sweep in metres: float32 NPY (N x 3, `fields` does not matter), text
/// (.txt, one point a line) or headerless little-endian float32 (.bin), told apart by the name's
/// ending. Non-finite points are kept: they count as missing rays.
/// Throws InputError naming the file if it is empty, truncated or of another shape.
[[nodiscard]] std::vector<Eigen::Vector3f> read_points(const std::filesystem::path& file,
                                                       PointFields fields);

} // namespace zonegrid
