#include "support/statements.h"

#include "model/constants.h"

#include <vector>

namespace zonegrid {

void say_in_zone(LocalMap& local_map, std::uint32_t place, std::uint32_t index,
                 std::uint8_t statement) {
    const Window& window = local_map.window();
    const CellIndex cell = cell_at(window.zone_at(place), index, window.zone_edge());
    const CellIndex first = window.first_cell();
    local_map.set({cell.x - first.x, cell.y - first.y, cell.z - first.z}, statement);
}

oracle::CellValues statements_of(const LocalMap& local_map) {
    const Window& window = local_map.window();
    const auto edge = static_cast<std::size_t>(window.zone_edge());
    std::vector<std::uint8_t> statements(edge * edge * edge);
    oracle::CellValues values;
    for (const auto place : local_map.zones()) {
        local_map.copy_zone(place, statements);
        for (std::uint32_t i = 0; i < statements.size(); ++i) {
            if (statements[i] != ZG_STATEMENT_NOTHING) {
                values[cell_at(window.zone_at(place), i, window.zone_edge())] = statements[i];
            }
        }
    }
    return values;
}

} // namespace zonegrid
