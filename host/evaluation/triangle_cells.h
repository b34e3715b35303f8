#pragma once

#include "zonegrid/objects.h"

#include <Eigen/Core>

#include <array>
#include <functional>

namespace zonegrid {

/// Corners in cells: world coordinates divided by the edge of a cell.
using CellTriangle = std::array<Eigen::Vector3d, 3>;

/// A surface that comes this close to a cell, in cells, touches it: half a sub-cell, for a mapper
/// cannot tell places apart any better. So a floor on a border touches the cells on either side.
inline constexpr double touch_slack = 1.0 / 512.0;

/// Whether a triangle and a cube of `edge` cells, whose least corner is `low`, have a point in
/// common; faces, edges and corners belong to both.
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

/// Calls `visit` once for every cell of the box that the triangle touches, `touch_slack` included:
/// the cell's cube is that much larger on all sides. Cost: in proportion to
/// these cells, whatever the triangle's size and slant.
void for_each_touched_cell(const CellTriangle& triangle, const CellBox& box,
                           const std::function<void(const CellIndex&)>& visit);

} // namespace zonegrid
