#include "evaluation/obstacle_measures.h"

#include "evaluation/best_line.h"
#include "evaluation/map_owners.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace zonegrid {
namespace {

Eigen::Vector3d middle_of(const CellIndex& cell) {
    return Eigen::Vector3d(cell.x, cell.y, cell.z) + Eigen::Vector3d::Constant(0.5);
}

/// A set of cells by its centre and box, in cells.
struct Extent {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::AlignedBox3d box;
    std::uint64_t count = 0;

    void add(const CellIndex& cell) {
        sum += middle_of(cell);
        box.extend(middle_of(cell));
        ++count;
    }
    [[nodiscard]] Eigen::Vector3d centre() const { return sum / static_cast<double>(count); }
    [[nodiscard]] Eigen::Vector3d size() const { return box.sizes() + Eigen::Vector3d::Ones(); }
};

/// Whether sets name two obstacles together.
class Company {
public:
    explicit Company(const std::vector<std::vector<std::uint32_t>>& sets) {
        for (const auto& set : sets) {
            for (const auto one : set) {
                with_[one].insert(set.begin(), set.end());
            }
        }
    }
    [[nodiscard]] std::set<std::uint32_t> of(std::uint32_t obstacle) const {
        const auto found = with_.find(obstacle);
        auto others = found == with_.end() ? std::set<std::uint32_t>() : found->second;
        others.erase(obstacle);
        return others;
    }

private:
    std::map<std::uint32_t, std::set<std::uint32_t>> with_;
};

class Judge {
public:
    Judge(const JudgedMap& map, const Truth& truth, const TouchedCells& touched,
          const TrueView& view)
        : map_(map),
          truth_(truth),
          touched_(touched),
          view_(view),
          owners_(map, touched, truth.surfaces),
          joined_(joined_obstacles(map, owners_)),
          touching_(touching_obstacles(touched, truth.surfaces)) {
        for (std::size_t i = 0; i < map.occupied_cells.size(); ++i) {
            if (owners_.is_ground(i)) {
                with_ground_.insert(map.occupied_cells[i].object);
            }
        }
    }

    [[nodiscard]] ObstacleMeasures judge(std::uint32_t obstacle) const {
        const TrueObstacle& described = truth_.surfaces.obstacles[obstacle];
        ObstacleMeasures measures;
        measures.name = described.name;
        measures.kind = described.kind;
        measures.visible_cells = view_.surface_of[obstacle].size();
        const auto judged = judged_cells(obstacle, measures.judged_with_ground);
        const auto own = own_cells(obstacle, measures.judged_with_ground);
        measures.map_cells = own.size();
        find(judged, own, measures);
        count_erased(judged, measures);
        count_objects(own, measures);
        if (described.kind != ObstacleKind::ground) {
            name_company(obstacle, measures);
            compare_places(judged, own, measures);
        }
        time_detection(obstacle, judged, own, measures);
        return measures;
    }

private:
    [[nodiscard]] bool is_ground(std::uint32_t obstacle) const {
        return truth_.surfaces.obstacles[obstacle].kind == ObstacleKind::ground;
    }

    /// Visible cells that the ground does not touch; all where it touches every one.
    [[nodiscard]] std::vector<CellIndex> judged_cells(std::uint32_t obstacle,
                                                      bool& with_ground) const {
        std::vector<CellIndex> clear;
        std::vector<CellIndex> all;
        view_.surface_of[obstacle].for_each([&](const CellIndex& cell) {
            all.push_back(cell);
            const auto there = touched_.obstacles_within(cell, 0);
            if (is_ground(obstacle) ||
                std::ranges::none_of(there, [&](auto other) { return is_ground(other); })) {
                clear.push_back(cell);
            }
        });
        with_ground = clear.empty();
        return with_ground ? all : clear;
    }

    /// Indices of the occupied cells that are the obstacle's own.
    [[nodiscard]] std::vector<std::uint32_t> own_cells(std::uint32_t obstacle,
                                                       bool with_ground) const {
        std::vector<std::uint32_t> own;
        for (const auto index : owners_.cells_of(obstacle)) {
            if (with_ground || is_ground(obstacle) || !owners_.is_ground(index)) {
                own.push_back(index);
            }
        }
        return own;
    }

    void find(const std::vector<CellIndex>& judged, const std::vector<std::uint32_t>& own,
              ObstacleMeasures& measures) const {
        CellSet cells;
        for (const auto index : own) {
            cells.insert(map_.occupied_cells[index].cell);
        }
        for (const auto& cell : judged) {
            ++measures.found_cells.of;
            measures.found_cells.count += cells.contains_within(cell, 1) ? 1U : 0U;
        }
        measures.found = !measures.judged_with_ground &&
                         measures.found_cells.value().value_or(0.0) >= found_share;
    }

    void count_erased(const std::vector<CellIndex>& judged, ObstacleMeasures& measures) const {
        for (const auto& cell : judged) {
            if (std::ranges::binary_search(map_.ever_occupied, cell, {}, &OnceOccupiedCell::cell)) {
                ++measures.erased_cells.of;
                measures.erased_cells.count += map_.occupied.contains(cell) ? 0U : 1U;
            }
        }
    }

    void count_objects(const std::vector<std::uint32_t>& own, ObstacleMeasures& measures) const {
        std::map<std::uint32_t, std::uint64_t> cells_in;
        for (const auto index : own) {
            const auto object = map_.occupied_cells[index].object;
            ++cells_in[object];
            measures.joined_with_ground =
                measures.joined_with_ground ||
                (measures.kind != ObstacleKind::ground && with_ground_.contains(object));
        }
        measures.objects = cells_in.size();
        for (const auto& [object, cells] : cells_in) {
            measures.largest_share =
                std::max(measures.largest_share,
                         static_cast<double>(cells) / static_cast<double>(own.size()));
        }
    }

    void name_company(std::uint32_t obstacle, ObstacleMeasures& measures) const {
        const auto touching = touching_.of(obstacle);
        for (const auto other : joined_.of(obstacle)) {
            const std::string& name = truth_.surfaces.obstacles[other].name;
            measures.merged_with.push_back(name);
            if (touching.contains(other)) {
                measures.touching.push_back(name);
            }
        }
    }

    void compare_places(const std::vector<CellIndex>& judged, const std::vector<std::uint32_t>& own,
                        ObstacleMeasures& measures) const {
        if (own.empty()) {
            return;
        }
        Extent expected;
        for (const auto& cell : judged) {
            expected.add(cell);
        }
        Extent actual;
        for (const auto index : own) {
            actual.add(map_.occupied_cells[index].cell);
        }
        const double cell_m = map_.cell_m;
        measures.centre_m = actual.centre() * cell_m;
        measures.true_centre_m = expected.centre() * cell_m;
        const Eigen::Vector3d error_m = *measures.centre_m - *measures.true_centre_m;
        measures.horizontal_error_m = error_m.head<2>().norm();
        measures.vertical_error_m = -error_m.z();
        measures.size_m = actual.size() * cell_m;
        measures.true_size_m = expected.size() * cell_m;
        measures.size_error_m = (*measures.size_m - *measures.true_size_m).cwiseAbs().maxCoeff();
    }

    void time_detection(std::uint32_t obstacle, const std::vector<CellIndex>& judged,
                        const std::vector<std::uint32_t>& own, ObstacleMeasures& measures) const {
        if (const auto& sight = view_.first_sight[obstacle]) {
            measures.first_sight =
                Moment{sight->image, truth_.images[sight->image].time_s, sight->distance_m};
        }
        std::uint32_t image = CellStamp::never;
        for (const auto index : own) {
            image = std::min(image, map_.occupied_cells[index].since_image);
        }
        if (image == CellStamp::never) {
            return;
        }
        const Eigen::Vector3d camera_m = truth_.images[image].world_from_camera.translation();
        double distance_m = std::numeric_limits<double>::infinity();
        for (const auto& cell : judged) {
            distance_m = std::min(distance_m, (middle_of(cell) * map_.cell_m - camera_m).norm());
        }
        measures.detection = Moment{image, truth_.images[image].time_s, distance_m};
    }

    const JudgedMap& map_;
    const Truth& truth_;
    const TouchedCells& touched_;
    const TrueView& view_;
    MapOwners owners_;
    Company joined_;
    Company touching_;
    std::set<std::uint32_t> with_ground_; ///< objects with a cell that the ground owns
};

double line_error(const std::vector<Eigen::Vector2d>& points) {
    return fit_line(points).greatest_distance(points);
}

} // namespace

std::vector<ObstacleMeasures> measure_obstacles(const JudgedMap& map, const Truth& truth,
                                                const TouchedCells& touched, const TrueView& view) {
    const Judge judge(map, truth, touched, view);
    std::vector<ObstacleMeasures> measures;
    for (std::uint32_t i = 0; i < view.surface_of.size(); ++i) {
        if (!view.surface_of[i].empty()) {
            measures.push_back(judge.judge(i));
        }
    }
    return measures;
}

std::vector<LineMeasures> measure_lines(std::span<const ObstacleMeasures> obstacles) {
    struct Points {
        std::vector<Eigen::Vector2d> found;
        std::vector<Eigen::Vector2d> expected;
    };
    std::map<ObstacleKind, Points> by_kind;
    for (const auto& obstacle : obstacles) {
        if (obstacle.found && obstacle.centre_m) {
            by_kind[obstacle.kind].found.emplace_back(obstacle.centre_m->head<2>());
            by_kind[obstacle.kind].expected.emplace_back(obstacle.true_centre_m->head<2>());
        }
    }
    std::vector<LineMeasures> lines;
    for (const auto& [kind, points] : by_kind) {
        if (points.found.size() >= 3) {
            lines.push_back({kind,
                             points.found.size(),
                             line_error(points.found),
                             line_error(points.expected),
                             {}});
        }
    }
    return lines;
}

} // namespace zonegrid
