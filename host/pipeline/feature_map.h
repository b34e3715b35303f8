#pragma once

#include "model/lattice.h"
#include "model/window.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace zonegrid {

/// What is known of obstacles outside the window, independent of the grid (docs/model.md,
/// sections 6 and 8). Held in memory, a zone's occupied cells as an octree.
class FeatureMap {
public:
    explicit FeatureMap(std::int32_t zone_edge) : zone_edge_(zone_edge) {}

    /// Remembers the occupied cells of a zone; replaces what was known of it. Forgets the zone if
    /// `cells` is empty.
    void remember(const ZoneIndex& zone, std::span<const CellIndex> cells);

    /// Hands over and forgets what is remembered of a zone.
    [[nodiscard]] std::vector<CellIndex> take(const ZoneIndex& zone);

    /// Remembered zones that a window holds.
    [[nodiscard]] std::vector<ZoneIndex> zones_in(const Window& window) const;

    /// What is remembered of a zone, sorted.
    [[nodiscard]] std::vector<CellIndex> cells(const ZoneIndex& zone) const;

    /// Remembered zones and the octree of each.
    [[nodiscard]] const std::map<ZoneIndex, std::vector<std::uint8_t>>& zones() const {
        return zones_;
    }

private:
    std::int32_t zone_edge_;
    std::map<ZoneIndex, std::vector<std::uint8_t>> zones_;
};

} // namespace zonegrid
