#pragma once

#include "model/zone_bits.h"
#include "ops/device_grid.h"
#include "ops/label_components.h"
#include "support/oracle_random.h"

#include <cstdint>
#include <vector>

namespace zonegrid {

/// Occupied cells of some zones to label: noise from sparse to full, single cells, slabs,
/// checkerboards, spirals, combs whose teeth meet late. At least one, at most eight.
[[nodiscard]] std::vector<ZoneBits> nasty_zones(oracle::Random& random, std::int32_t zone_edge);

/// Labels zones that lie in a buffer as a grid's chunk holds them, in another order.
void label(device::Device& device, const std::vector<ZoneBits>& zones,
           ops::LabelComponents& operation);

/// The cells of each piece of each zone, by the reference, within the zone.
[[nodiscard]] std::vector<std::vector<CellIndex>> pieces_of(const std::vector<ZoneBits>& zones,
                                                            std::int32_t zone_edge);

} // namespace zonegrid
