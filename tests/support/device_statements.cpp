#include "support/device_statements.h"

#include "model/constants.h"

#include <vector>

namespace zonegrid {

oracle::CellValues statements_of(const ops::DeviceLocalMap& local_map,
                                 std::span<const std::uint32_t> places, const Window& window) {
    std::vector<std::uint8_t> statements(ops::ZoneLayout(window.zone_edge()).zone_cells);
    oracle::CellValues values;
    for (std::size_t i = 0; i < places.size(); ++i) {
        local_map.download_zone(i, statements);
        for (std::uint32_t cell = 0; cell < statements.size(); ++cell) {
            if (statements[cell] != ZG_STATEMENT_NOTHING) {
                values[cell_at(window.zone_at(places[i]), cell, window.zone_edge())] =
                    statements[cell];
            }
        }
    }
    return values;
}

} // namespace zonegrid
