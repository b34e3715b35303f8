#include "evaluation/gap_measures.h"

#include "evaluation/best_line.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

/// An obstacle in the frame of its row: along the row, across it, and up.
struct Member {
    const ObstacleMeasures* obstacle = nullptr;
    Eigen::AlignedBox3d box; ///< along, across, height above the world's origin; metres
};

/// The frame of a row: along its line, across it, and up.
struct Row {
    BestLine line;

    [[nodiscard]] Eigen::Vector3d into(const Eigen::Vector3d& place_m) const {
        const Eigen::Vector2d offset = place_m.head<2>() - line.origin;
        return {offset.dot(line.along), offset.dot(line.across()), -place_m.z()};
    }
    [[nodiscard]] Eigen::Vector3d out_of(const Eigen::Vector3d& place) const {
        const Eigen::Vector2d flat =
            line.origin + place.x() * line.along + place.y() * line.across();
        return {flat.x(), flat.y(), -place.z()};
    }
};

Eigen::Vector2d middle_of(const Surfaces& surfaces, const TrueObstacle& obstacle) {
    Eigen::AlignedBox2d box;
    for (std::uint32_t i = 0; i < obstacle.triangles; ++i) {
        for (const auto vertex : surfaces.triangles[obstacle.first_triangle + i]) {
            box.extend(Eigen::Vector2d(surfaces.vertices_m[vertex].head<2>().cast<double>()));
        }
    }
    return box.center();
}

Eigen::AlignedBox3d box_in(const Row& row, const Surfaces& surfaces, const TrueObstacle& obstacle) {
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = 0; i < obstacle.triangles; ++i) {
        for (const auto vertex : surfaces.triangles[obstacle.first_triangle + i]) {
            box.extend(row.into(surfaces.vertices_m[vertex].cast<double>()));
        }
    }
    return box;
}

/// Places from `low` to `high`, at most half a cell apart, both ends half a step away.
std::vector<double> places_between(double low, double high, double cell_m) {
    const auto count = static_cast<int>(std::ceil(2.0 * (high - low) / cell_m));
    std::vector<double> places;
    for (int i = 0; i < count; ++i) {
        places.push_back(low + (high - low) * (i + 0.5) / count);
    }
    return places;
}

/// What the map says of the gap between two neighbours: between their facing ends, as wide as the
/// narrower one, over the upper half of the lower one.
GapMeasures measure_gap(const JudgedMap& map, const Row& row, const Member& one,
                        const Member& other) {
    const auto& a = one.box;
    const auto& b = other.box;
    const double wide = 0.5 * std::min(a.sizes().y(), b.sizes().y());
    const double middle = 0.5 * (a.center().y() + b.center().y());
    const double high = std::min(a.max().z(), b.max().z());
    const double low = 0.5 * (high + std::max(a.min().z(), b.min().z()));
    GapMeasures gap{
        one.obstacle->name, other.obstacle->name, b.min().x() - a.max().x(), 0.0, {}, {}};
    const auto along = places_between(a.max().x(), b.min().x(), map.cell_m);
    double clear_m = 0.0;
    for (const double x : along) {
        bool clear = true;
        for (const double y : places_between(middle - wide, middle + wide, map.cell_m)) {
            for (const double z : places_between(low, high, map.cell_m)) {
                const CellIndex cell = cell_at_m(row.out_of({x, y, z}), map.cell_m);
                const bool occupied = map.occupied.contains(cell);
                clear = clear && !occupied;
                gap.occupied.count += occupied ? 1U : 0U;
                gap.free.count += map.free.contains(cell) ? 1U : 0U;
                ++gap.free.of;
            }
        }
        clear_m = clear ? clear_m + gap.true_m / static_cast<double>(along.size()) : 0.0;
        gap.clear_m = std::max(gap.clear_m, clear_m);
    }
    gap.occupied.of = gap.free.of;
    return gap;
}

} // namespace

void measure_gaps(const JudgedMap& map, const Truth& truth,
                  std::span<const ObstacleMeasures> obstacles, std::vector<LineMeasures>& lines) {
    for (auto& line : lines) {
        std::vector<const ObstacleMeasures*> standing;
        std::vector<const TrueObstacle*> expected;
        std::vector<Eigen::Vector2d> middles;
        for (const auto& obstacle : obstacles) {
            const auto known =
                std::ranges::find(truth.surfaces.obstacles, obstacle.name, &TrueObstacle::name);
            if (obstacle.kind == line.kind && known != truth.surfaces.obstacles.end()) {
                standing.push_back(&obstacle);
                expected.push_back(&*known);
                middles.push_back(middle_of(truth.surfaces, *known));
            }
        }
        const Row row{fit_line(middles)};
        if (row.line.greatest_distance(middles) > row_error_m) {
            continue;
        }
        std::vector<Member> members;
        for (std::size_t i = 0; i < standing.size(); ++i) {
            members.push_back({standing[i], box_in(row, truth.surfaces, *expected[i])});
        }
        std::ranges::sort(members, {},
                          [](const Member& member) { return member.box.center().x(); });
        for (std::size_t i = 1; i < members.size(); ++i) {
            if (members[i].box.min().x() > members[i - 1].box.max().x()) {
                line.gaps.push_back(measure_gap(map, row, members[i - 1], members[i]));
            }
        }
    }
}

} // namespace zonegrid
