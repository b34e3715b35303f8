#include "evaluation/cell_measures.h"

#include <algorithm>
#include <vector>

namespace zonegrid {
namespace {

/// Least distance at which `set` has a cell; `reaches` if that is farther.
std::size_t distance_to(const CellSet& set, const CellIndex& cell) {
    for (std::size_t reach = 0; reach < reaches; ++reach) {
        if (set.contains_within(cell, static_cast<std::int32_t>(reach))) {
            return reach;
        }
    }
    return reaches;
}

void count_distance(std::size_t distance, std::array<Share, reaches>& shares) {
    for (std::size_t reach = 0; reach < reaches; ++reach) {
        ++shares[reach].of;
        shares[reach].count += distance <= reach ? 1U : 0U;
    }
}

void count(bool counts, Share& share) {
    ++share.of;
    share.count += counts ? 1U : 0U;
}

} // namespace

CellMeasures measure_cells(const JudgedMap& map, const TouchedCells& touched,
                           const CellSet& passing, const TrueView& view, const SolidCells& solid) {
    CellMeasures measures;
    map.occupied.for_each([&](const CellIndex& cell) {
        count_distance(std::min(distance_to(touched.all(), cell), distance_to(passing, cell)),
                       measures.precision);
    });
    view.surface.for_each([&](const CellIndex& cell) {
        const auto cells = alternatives(view, cell);
        std::size_t distance = reaches;
        bool free = true;
        bool unknown = true;
        for (const auto& one : cells) {
            distance = std::min(distance, distance_to(map.occupied, one));
            free = free && map.free.contains(one);
            unknown = unknown && !map.knows(one);
        }
        count_distance(distance, measures.recall);
        if (map.tells_of(cell)) {
            count(free, measures.wrong_free_surface);
            count(unknown, measures.unknown_surface);
        }
    });
    view.free.for_each([&](const CellIndex& cell) {
        count(map.occupied.contains(cell), measures.wrong_occupied_free);
        if (map.tells_of(cell)) {
            count(!map.knows(cell), measures.unknown_free);
        }
    });
    map.free.for_each(
        [&](const CellIndex& cell) { count(solid.contains(cell), measures.wrong_free_solid); });
    return measures;
}

} // namespace zonegrid
