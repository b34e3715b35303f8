#include "evaluation/triangle_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace zonegrid {
namespace {

/// Least and greatest of the corners along an axis.
std::pair<double, double> extent_along(const Eigen::Vector3d& axis, const CellTriangle& triangle) {
    const double a = axis.dot(triangle[0]);
    const double b = axis.dot(triangle[1]);
    const double c = axis.dot(triangle[2]);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

/// Whether the projections of the triangle and of a cube around the origin, faces included, part.
bool parts(const Eigen::Vector3d& axis, const CellTriangle& triangle, double half_edge) {
    const double reach = half_edge * axis.cwiseAbs().sum();
    const auto [least, greatest] = extent_along(axis, triangle);
    return least > reach || greatest < -reach;
}

/// Cubes with an edge of a power of two that descend to single cells.
class Descent {
public:
    Descent(const CellTriangle& triangle, const CellBox& box,
            const std::function<void(const CellIndex&)>& visit)
        : triangle_(triangle), box_(box), visit_(visit) {}

    void enter(const CellIndex& low, std::int32_t edge) {
        const Eigen::Vector3d corner(low.x, low.y, low.z);
        const CellIndex high{low.x + edge - 1, low.y + edge - 1, low.z + edge - 1};
        if (high.x < box_.low.x || high.y < box_.low.y || high.z < box_.low.z ||
            low.x > box_.high.x || low.y > box_.high.y || low.z > box_.high.z ||
            !touches_cube(triangle_, corner - Eigen::Vector3d::Constant(touch_slack),
                          edge + 2.0 * touch_slack)) {
            return;
        }
        if (edge == 1) {
            visit_(low);
            return;
        }
        const std::int32_t half = edge / 2;
        for (int child = 0; child < 8; ++child) {
            enter({low.x + (child & 1) * half, low.y + (child >> 1 & 1) * half,
                   low.z + (child >> 2) * half},
                  half);
        }
    }

private:
    const CellTriangle& triangle_;
    const CellBox& box_;
    const std::function<void(const CellIndex&)>& visit_;
};

} // namespace

bool touches_cube(const CellTriangle& triangle, const Eigen::Vector3d& low, double edge) {
    for (int axis = 0; axis < 3; ++axis) {
        const double least = std::min({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
        const double greatest = std::max({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
        if (least > low[axis] + edge || greatest < low[axis]) {
            return false;
        }
    }
    const double half_edge = 0.5 * edge;
    const Eigen::Vector3d middle = low + Eigen::Vector3d::Constant(half_edge);
    const CellTriangle around{triangle[0] - middle, triangle[1] - middle, triangle[2] - middle};
    const std::array<Eigen::Vector3d, 3> sides{around[1] - around[0], around[2] - around[1],
                                               around[0] - around[2]};
    // A plane on the cube's border: the faces decide above, and this keeps out what only they
    // share.
    if (parts(sides[0].cross(sides[1]), around, half_edge)) {
        return false;
    }
    for (const auto& side : sides) {
        for (int axis = 0; axis < 3; ++axis) {
            if (parts(side.cross(Eigen::Vector3d::Unit(axis)), around, half_edge)) {
                return false;
            }
        }
    }
    return true;
}

void for_each_touched_cell(const CellTriangle& triangle, const CellBox& box,
                           const std::function<void(const CellIndex&)>& visit) {
    CellIndex low;
    std::int32_t edge = 1;
    const std::array<std::int32_t*, 3> lows{&low.x, &low.y, &low.z};
    const std::array<std::int32_t, 3> box_lows{box.low.x, box.low.y, box.low.z};
    const std::array<std::int32_t, 3> box_highs{box.high.x, box.high.y, box.high.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const double least = std::min({triangle[0][i], triangle[1][i], triangle[2][i]});
        const double greatest = std::max({triangle[0][i], triangle[1][i], triangle[2][i]});
        // Clamped before rounding: a far triangle may lie beyond all whole numbers.
        const double first =
            std::max(std::floor(least - touch_slack), static_cast<double>(box_lows[axis]));
        const double last =
            std::min(std::floor(greatest + touch_slack), static_cast<double>(box_highs[axis]));
        if (first > last) {
            return;
        }
        *lows[axis] = static_cast<std::int32_t>(first);
        while (edge <= static_cast<std::int32_t>(last) - *lows[axis]) {
            edge *= 2;
        }
    }
    Descent(triangle, box, visit).enter(low, edge);
}

} // namespace zonegrid
