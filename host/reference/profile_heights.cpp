#include "reference/profile_heights.h"

#include <algorithm>

namespace zonegrid::reference {

namespace {

constexpr std::int32_t no_cell = std::numeric_limits<std::int32_t>::max();

} // namespace

void HeightProfiler::add_zone(const ZoneIndex& zone, const ZoneBits& occupied) {
    const auto edge = static_cast<std::size_t>(zone_edge_);
    auto& tile = tiles_.try_emplace({zone.x, zone.y, 0}, edge * edge, no_cell).first->second;
    occupied.for_each([&](std::uint32_t index) {
        const CellIndex cell = cell_at(zone, index, zone_edge_);
        if (cell.z >= z_least_) {
            auto& highest = tile[index % (edge * edge)];
            highest = std::min(highest, cell.z);
        }
    });
}

std::vector<ProfileColumn> HeightProfiler::columns() const {
    std::vector<ProfileColumn> columns;
    for (const auto& [zone, tile] : tiles_) {
        for (std::uint32_t i = 0; i < tile.size(); ++i) {
            if (tile[i] != no_cell) {
                const CellIndex cell = cell_at(zone, i, zone_edge_);
                columns.push_back({cell.x, cell.y, tile[i]});
            }
        }
    }
    std::ranges::sort(columns);
    return columns;
}

} // namespace zonegrid::reference
