#pragma once

#include "model/lattice.h"
#include "model/zone_bits.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace zonegrid {

struct ZoneHash {
    std::size_t operator()(const ZoneIndex& zone) const {
        const auto mixed = [](std::int32_t n, std::uint64_t factor) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(n)) * factor;
        };
        return static_cast<std::size_t>(mixed(zone.x, 0x9E3779B97F4A7C15U) ^
                                        mixed(zone.y, 0xC2B2AE3D27D4EB4FU) ^
                                        mixed(zone.z, 0x165667B19E3779F9U));
    }
};

/// A set of cells, a bit each, in zones of its own that cost memory only where it has cells.
class CellSet {
public:
    static constexpr std::int32_t zone_edge = 32;

    /// Returns whether it was not in the set before.
    bool insert(const CellIndex& cell);
    void insert_all(const CellSet& other);

    [[nodiscard]] bool contains(const CellIndex& cell) const;
    /// Whether a cell of the set is at most `reach` cells away on every axis (Chebyshev distance).
    [[nodiscard]] bool contains_within(const CellIndex& cell, std::int32_t reach) const;

    [[nodiscard]] std::uint64_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }

    [[nodiscard]] const std::unordered_map<ZoneIndex, ZoneBits, ZoneHash>& zones() const {
        return zones_;
    }

    /// Calls `visit(cell)` for every cell, in no particular order.
    template <class Visit>
    void for_each(Visit&& visit) const {
        for (const auto& [zone, bits] : zones_) {
            bits.for_each(
                [&, &at = zone](std::uint32_t index) { visit(cell_at(at, index, zone_edge)); });
        }
    }

private:
    [[nodiscard]] const ZoneBits* find(const ZoneIndex& zone) const;

    std::unordered_map<ZoneIndex, ZoneBits, ZoneHash> zones_;
    std::uint64_t size_ = 0;
    // The zone asked for last: cells are mostly asked for in runs.
    ZoneIndex inserted_zone_;
    ZoneBits* inserted_bits_ = nullptr;
};

/// Calls `visit(cell)` for the cell and all others at most `reach` cells away on every axis.
template <class Visit>
void for_each_within(const CellIndex& cell, std::int32_t reach, Visit&& visit) {
    for (std::int32_t z = -reach; z <= reach; ++z) {
        for (std::int32_t y = -reach; y <= reach; ++y) {
            for (std::int32_t x = -reach; x <= reach; ++x) {
                visit(CellIndex{cell.x + x, cell.y + y, cell.z + z});
            }
        }
    }
}

} // namespace zonegrid
