#pragma once

#include "zonegrid/objects.h"

#include <Eigen/Core>

#include <array>
#include <functional>

namespace zonegrid {

/// Corners in cells: world coordinates divided by the edge of a cell.
using CellTriangle = std::array<Eigen::Vector3d, 3>;

/// Whether a triangle and a cube of `edge` cells, whose least corner is `low`, have a point in
/// common. The cube's faces at its least coordinates belong to it, those at its greatest do not, as
/// it is with cells: a wall on a border belongs to the cells on its far side only. Where nothing
/// but an edge or a corner of the cube meets the inside of a slanting triangle, that counts.
///
/// Source: the thirteen separating axes of T. Akenine-Moeller, "Fast 3D Triangle-Box Overlap
/// Testing", Journal of Graphics Tools 6(1), 2001. In double, without slack.
[[nodiscard]] bool touches_cube(const CellTriangle& triangle, const Eigen::Vector3d& low,
                                double edge);

/// Cells from `low` to `high`, both included.
struct CellBox {
    CellIndex low;
    CellIndex high;

    [[nodiscard]] bool contains(const CellIndex& cell) const {
        return cell.x >= low.x && cell.x <= high.x && cell.y >= low.y && cell.y <= high.y &&
               cell.z >= low.z && cell.z <= high.z;
    }
};

/// Calls `visit` once for every cell of the box that the triangle touches. Cost: in proportion to
/// these cells, whatever the triangle's size and slant.
void for_each_touched_cell(const CellTriangle& triangle, const CellBox& box,
                           const std::function<void(const CellIndex&)>& visit);

} // namespace zonegrid
