#pragma once

#include "evaluation/judged_map.h"
#include "evaluation/touched_cells.h"
#include "truth/surfaces.h"

#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid {

/// Which obstacles the map's occupied cells are of. A cell's owners are the obstacles that touch
/// it; where none does, those that touch one of its 26 neighbours; else it has none.
class MapOwners {
public:
    MapOwners(const JudgedMap& map, const TouchedCells& touched, const Surfaces& surfaces);

    /// Owners of JudgedMap::occupied_cells[index], ascending.
    [[nodiscard]] std::span<const std::uint32_t> owners(std::size_t index) const {
        return std::span(owners_).subspan(first_[index], first_[index + 1] - first_[index]);
    }
    /// Whether one of them is ground.
    [[nodiscard]] bool is_ground(std::size_t index) const { return ground_[index] != 0; }

    /// Indices of the occupied cells that an obstacle owns, ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& cells_of(std::uint32_t obstacle) const {
        return cells_of_[obstacle];
    }

private:
    std::vector<std::uint32_t> owners_;
    std::vector<std::size_t> first_; ///< by cell, and one more
    std::vector<char> ground_;
    std::vector<std::vector<std::uint32_t>> cells_of_;
};

/// Sets of obstacles that cells join: each holds those that own cells of one component (connected
/// through faces) of the occupied cells that the ground does not own. An obstacle counts by a cell
/// that it owns alone, or by any if it owns none alone in all of the map.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> joined_obstacles(const JudgedMap& map,
                                                                       const MapOwners& owners);

/// The same of the truth's cells: sets of obstacles that cells of this size cannot tell apart.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> touching_obstacles(
    const TouchedCells& touched, const Surfaces& surfaces);

} // namespace zonegrid
