#include "evaluation/touched_cells.h"

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

CellTriangle corners_of(const Surfaces& surfaces, std::uint32_t triangle,
                        const Eigen::Isometry3d& world_from_obstacle, double cell_m) {
    CellTriangle corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3f& vertex = surfaces.vertices_m[surfaces.triangles[triangle][i]];
        corners[i] = world_from_obstacle * vertex.cast<double>() / cell_m;
    }
    return corners;
}

} // namespace

void TouchedCells::add(std::uint32_t obstacle, const CellIndex& cell) {
    if (!of_[obstacle].insert(cell)) {
        return;
    }
    all_.insert(cell);
    auto& known = in_zone_[zone_of(cell, CellSet::zone_edge)];
    if (known.empty() || known.back() != obstacle) {
        const auto place = std::ranges::lower_bound(known, obstacle);
        if (place == known.end() || *place != obstacle) {
            known.insert(place, obstacle);
        }
    }
}

std::vector<std::uint32_t> TouchedCells::obstacles_within(const CellIndex& cell,
                                                          std::int32_t reach) const {
    std::vector<std::uint32_t> found;
    for_each_within(cell, reach, [&](const CellIndex& near) {
        if (!all_.contains(near)) {
            return;
        }
        for (const auto obstacle : in_zone_.at(zone_of(near, CellSet::zone_edge))) {
            if (of_[obstacle].contains(near)) {
                found.push_back(obstacle);
            }
        }
    });
    std::ranges::sort(found);
    const auto doubled = std::ranges::unique(found);
    found.erase(doubled.begin(), doubled.end());
    return found;
}

CellSet touch_cells(const Surfaces& surfaces, std::uint32_t obstacle,
                    const Eigen::Isometry3d& world_from_obstacle, double cell_m,
                    const CellBox& box) {
    CellSet cells;
    const TrueObstacle& described = surfaces.obstacles[obstacle];
    for (std::uint32_t i = 0; i < described.triangles; ++i) {
        for_each_touched_cell(
            corners_of(surfaces, described.first_triangle + i, world_from_obstacle, cell_m), box,
            [&](const CellIndex& cell) { cells.insert(cell); });
    }
    return cells;
}

TouchedCells touch_cells(const Surfaces& surfaces, double cell_m, const CellBox& box) {
    TouchedCells touched(surfaces.obstacles.size());
    for (std::uint32_t i = 0; i < surfaces.obstacles.size(); ++i) {
        if (!surfaces.obstacles[i].moving) {
            touch_cells(surfaces, i, Eigen::Isometry3d::Identity(), cell_m, box)
                .for_each([&](const CellIndex& cell) { touched.add(i, cell); });
        }
    }
    return touched;
}

std::optional<Eigen::AlignedBox3d> extent_m(const Surfaces& surfaces) {
    Eigen::AlignedBox3d extent;
    for (const auto& obstacle : surfaces.obstacles) {
        for (std::uint32_t i = 0; !obstacle.moving && i < obstacle.triangles; ++i) {
            for (const auto vertex : surfaces.triangles[obstacle.first_triangle + i]) {
                extent.extend(surfaces.vertices_m[vertex].cast<double>());
            }
        }
    }
    return extent.isEmpty() ? std::nullopt : std::optional(extent);
}

CellIndex cell_at_m(const Eigen::Vector3d& place_m, double cell_m) {
    constexpr double most = 1073741824.0;
    const auto cell = [&](double along_m) {
        return static_cast<std::int32_t>(std::clamp(std::floor(along_m / cell_m), -most, most));
    };
    return {cell(place_m.x()), cell(place_m.y()), cell(place_m.z())};
}

} // namespace zonegrid
