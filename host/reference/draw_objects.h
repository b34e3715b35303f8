#pragma once

#include "model/fusion.h"
#include "zonegrid/objects.h"

#include <cstdint>
#include <span>

namespace zonegrid::reference {

/// Draws remembered cells back into their zone (docs/model.md, section 6): each gets the value
/// `rule.drawn()`. `values`: the zone's cells, order [z][y][x]; `cells` all lie in that zone.
void draw_objects(std::span<const CellIndex> cells, const FusionRule& rule, std::int32_t zone_edge,
                  std::span<std::int8_t> values);

} // namespace zonegrid::reference
