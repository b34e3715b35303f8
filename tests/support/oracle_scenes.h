#pragma once

#include "support/oracle_random.h"
#include "zonegrid/options.h"
#include "zonegrid/sensors.h"

#include <vector>

namespace zonegrid::oracle {

/// Odd sizes, from 1 x 1 to 16 x 12; every third with a table of directions, some with stereo, some
/// with whole slopes; mounted anyhow.
[[nodiscard]] Camera random_camera(Random& random);

/// Small range in cells (at most `range_cells`), so that exact intersection stays quick.
[[nodiscard]] MapperOptions random_options(Random& random, double range_cells);

/// Any turn, two in five of them exact quarter turns, which put rays on edges and corners.
[[nodiscard]] Eigen::Quaterniond random_attitude(Random& random);

/// Within +-`most` cells of the origin, often exactly on cell borders or half way between them.
[[nodiscard]] Eigen::Vector3d random_position(Random& random, double cell_m, double most);

/// What depth images of `random_depths` look like.
enum class Picture {
    all_missing,
    all_infinite,
    one_pixel,
    noise,
    step,
    range_end, ///< within a sub-cell of the pixel's range, on either side
    beyond,
    mixed ///< everything at once, with the smallest and greatest floats
};
inline constexpr int picture_kinds = 8;

[[nodiscard]] std::vector<float> random_depths(Random& random, const Camera& camera,
                                               const MapperOptions& options, Picture picture);

/// A random camera of at least 3 x 3 pixels: one that sees some cells whole.
[[nodiscard]] Camera seeing_camera(Random& random);

/// Random options with which one hit makes an unknown cell occupied, and a range of 6 to 12 cells;
/// half of them 5/16 cell more than whole: less the margin of 3/16 cell that is an odd number of
/// eighths, whose square is a sum of three in many ways, so corners of cells are exactly there.
[[nodiscard]] MapperOptions seeing_options(Random& random);

/// Mostly multiples of 1/16 cell within +-`most` cells: from there, corners of cells are exactly at
/// the borders of an upright camera's view.
[[nodiscard]] Eigen::Vector3d seeing_position(Random& random, double cell_m, int most);

/// Ends of a scan that says occupied all around its sensor, up to the range, cell by cell.
[[nodiscard]] std::vector<Eigen::Vector3f> filling_ends(const MapperOptions& options);

/// Free to the range or half of it in a box of pixels, but for some missing; all others missing.
[[nodiscard]] std::vector<float> framed_depths(Random& random, const Camera& camera,
                                               const MapperOptions& options);

} // namespace zonegrid::oracle
