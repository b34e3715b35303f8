#include "reference/draw_objects.h"

#include "model/lattice.h"

namespace zonegrid::reference {

void draw_objects(std::span<const CellIndex> cells, const FusionRule& rule, std::int32_t zone_edge,
                  std::span<std::int8_t> values) {
    for (const auto& cell : cells) {
        values[index_in_zone(cell, zone_edge)] = static_cast<std::int8_t>(rule.drawn());
    }
}

} // namespace zonegrid::reference
