#include "evaluation/map_owners.h"

#include <algorithm>
#include <array>
#include <set>

namespace zonegrid {
namespace {

std::array<CellIndex, 6> face_neighbours(const CellIndex& cell) {
    return {{{cell.x - 1, cell.y, cell.z},
             {cell.x + 1, cell.y, cell.z},
             {cell.x, cell.y - 1, cell.z},
             {cell.x, cell.y + 1, cell.z},
             {cell.x, cell.y, cell.z - 1},
             {cell.x, cell.y, cell.z + 1}}};
}

/// Calls `visit(cell)` for every cell of the component of `start` that `holds` lets in; notes them
/// in `seen`.
template <class Holds, class Visit>
void walk_component(const CellIndex& start, CellSet& seen, const Holds& holds, const Visit& visit) {
    std::vector<CellIndex> waiting{start};
    seen.insert(start);
    while (!waiting.empty()) {
        const CellIndex cell = waiting.back();
        waiting.pop_back();
        visit(cell);
        for (const auto& near : face_neighbours(cell)) {
            if (holds(near) && seen.insert(near)) {
                waiting.push_back(near);
            }
        }
    }
}

using Sets = std::vector<std::vector<std::uint32_t>>;

void add_set(const std::set<std::uint32_t>& obstacles, Sets& sets) {
    if (obstacles.size() > 1) {
        sets.emplace_back(obstacles.begin(), obstacles.end());
    }
}

} // namespace

MapOwners::MapOwners(const JudgedMap& map, const TouchedCells& touched, const Surfaces& surfaces)
    : ground_(map.occupied_cells.size()), cells_of_(surfaces.obstacles.size()) {
    first_.push_back(0);
    for (std::size_t i = 0; i < map.occupied_cells.size(); ++i) {
        auto found = touched.obstacles_within(map.occupied_cells[i].cell, 0);
        if (found.empty()) {
            found = touched.obstacles_within(map.occupied_cells[i].cell, 1);
        }
        for (const auto obstacle : found) {
            owners_.push_back(obstacle);
            cells_of_[obstacle].push_back(static_cast<std::uint32_t>(i));
            if (surfaces.obstacles[obstacle].kind == ObstacleKind::ground) {
                ground_[i] = 1;
            }
        }
        first_.push_back(owners_.size());
    }
}

Sets joined_obstacles(const JudgedMap& map, const MapOwners& owners) {
    std::set<std::uint32_t> with_own;
    CellSet walkable;
    for (std::size_t i = 0; i < map.occupied_cells.size(); ++i) {
        if (!owners.is_ground(i)) {
            walkable.insert(map.occupied_cells[i].cell);
            if (owners.owners(i).size() == 1) {
                with_own.insert(owners.owners(i)[0]);
            }
        }
    }
    Sets sets;
    CellSet seen;
    for (std::size_t i = 0; i < map.occupied_cells.size(); ++i) {
        const CellIndex& start = map.occupied_cells[i].cell;
        if (owners.is_ground(i) || seen.contains(start)) {
            continue;
        }
        std::set<std::uint32_t> obstacles;
        walk_component(
            start, seen, [&](const CellIndex& cell) { return walkable.contains(cell); },
            [&](const CellIndex& cell) {
                const auto place =
                    std::ranges::lower_bound(map.occupied_cells, cell, {}, &OccupiedCell::cell);
                const auto found =
                    owners.owners(static_cast<std::size_t>(place - map.occupied_cells.begin()));
                for (const auto obstacle : found) {
                    if (found.size() == 1 || !with_own.contains(obstacle)) {
                        obstacles.insert(obstacle);
                    }
                }
            });
        add_set(obstacles, sets);
    }
    return sets;
}

Sets touching_obstacles(const TouchedCells& touched, const Surfaces& surfaces) {
    CellSet walkable;
    for (std::uint32_t i = 0; i < touched.obstacles(); ++i) {
        if (surfaces.obstacles[i].kind != ObstacleKind::ground) {
            walkable.insert_all(touched.of(i));
        }
    }
    // A cell that the ground touches too joins nothing: things that stand side by side would.
    const auto is_ground = [&](const CellIndex& cell) {
        return std::ranges::any_of(touched.obstacles_within(cell, 0), [&](const auto obstacle) {
            return surfaces.obstacles[obstacle].kind == ObstacleKind::ground;
        });
    };
    Sets sets;
    CellSet seen;
    walkable.for_each([&](const CellIndex& start) {
        if (seen.contains(start) || is_ground(start)) {
            return;
        }
        std::set<std::uint32_t> obstacles;
        walk_component(
            start, seen,
            [&](const CellIndex& cell) { return walkable.contains(cell) && !is_ground(cell); },
            [&](const CellIndex& cell) {
                for (const auto obstacle : touched.obstacles_within(cell, 0)) {
                    obstacles.insert(obstacle);
                }
            });
        add_set(obstacles, sets);
    });
    return sets;
}

} // namespace zonegrid
