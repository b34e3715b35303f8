#include "support/device_statements.h"

#include "model/constants.h"

#include <vector>

namespace zonegrid {

oracle::CellValues statements_of(device::Device& device, const ops::DeviceLocalMap& local_map,
                                 std::span<const std::uint32_t> places, const Window& window) {
    const ops::ZoneLayout layout(window.zone_edge());
    std::vector<std::uint32_t> planes((places.size() + 1) * 2 * layout.plane_words());
    device.download(local_map.planes(), 0, std::as_writable_bytes(std::span(planes)));
    oracle::CellValues values;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto first = 2 * std::size_t{ops::DeviceLocalMap::slot_of(i)} * layout.plane_words();
        const auto free = std::span(planes).subspan(first, layout.plane_words());
        const auto occupied =
            std::span(planes).subspan(first + layout.plane_words(), layout.plane_words());
        for (std::uint32_t cell = 0; cell < layout.zone_cells; ++cell) {
            const auto says = [cell](std::span<const std::uint32_t> plane) {
                return (plane[cell / 32] >> (cell % 32) & 1U) != 0;
            };
            if (says(free) || says(occupied)) {
                values[cell_at(window.zone_at(places[i]), cell, window.zone_edge())] =
                    says(occupied) ? ZG_STATEMENT_OCCUPIED : ZG_STATEMENT_FREE;
            }
        }
    }
    return values;
}

} // namespace zonegrid
