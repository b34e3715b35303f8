#pragma once

#include "evaluation/cell_set.h"
#include "evaluation/triangle_cells.h"

#include <optional>
#include <span>
#include <unordered_set>

namespace zonegrid {

/// The inside of things: cells of a region that no surface touches and that nothing comes to from
/// the sky. A cell is reached if a path through faces of cells of the region leads to it, past all
/// touched cells, from the region's top layer (least z) or from one of the `open` cells. The
/// region's sides and bottom let nothing in.
class SolidCells {
public:
    /// `touched` must outlive it. Memory: a bit a cell where surfaces are, next to none elsewhere.
    SolidCells(const CellSet& touched, const CellBox& region, std::span<const CellIndex> open);

    [[nodiscard]] bool contains(const CellIndex& cell) const;

private:
    /// What is reached of a zone; nothing: all of it.
    using Reached = std::optional<ZoneBits>;

    void seed_top();
    void reach(const ZoneIndex& zone, const ZoneBits& from);
    void spread(const ZoneIndex& zone);
    [[nodiscard]] ZoneBits open_cells(const ZoneIndex& zone) const;
    [[nodiscard]] bool is_inside(const ZoneIndex& zone) const;
    [[nodiscard]] bool meets_region(const ZoneIndex& zone) const;

    const CellSet& touched_;
    CellBox region_;
    std::unordered_map<ZoneIndex, Reached, ZoneHash> reached_;
    std::vector<ZoneIndex> waiting_; ///< zones whose neighbours must be told
};

} // namespace zonegrid
