#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace zonegrid {

/// A cell by its whole-number coordinates in the world frame (x north, y east, z down): it covers
/// [x, x + 1) * cell_m and so on.
struct CellIndex {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    friend auto operator<=>(const CellIndex&, const CellIndex&) = default;
};

/// A set of occupied cells connected through faces (docs/model.md, section 8).
struct Object {
    CellIndex id; ///< its least cell: by x, then y, then z
    std::uint64_t cell_count = 0;
    CellIndex box_min;                      ///< inclusive
    CellIndex box_max;                      ///< inclusive
    std::array<std::int64_t, 3> cell_sum{}; ///< sum of x, y and z over its cells
    std::vector<std::uint8_t> octree;       ///< docs/model.md, section 8.4
    std::vector<std::uint8_t> prism; ///< quadtree of the ground plan, docs/model.md, section 8.5

    /// Centre of mass in metres, world frame.
    [[nodiscard]] Eigen::Vector3d centre_m(double cell_m) const;

    friend bool operator==(const Object&, const Object&) = default;
};

/// One column of the height profile: the highest occupied cell above ground plan cell (x, y).
/// z points down, so it is the least z.
struct ProfileColumn {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    friend auto operator<=>(const ProfileColumn&, const ProfileColumn&) = default;
};

/// Columns with at least one occupied cell, sorted by x, then y.
struct HeightProfile {
    double cell_m = 0.0;
    std::vector<ProfileColumn> columns;
};

} // namespace zonegrid
