#pragma once

#include "model/local_map.h"
#include "support/oracle_compare.h"

#include <cstdint>

namespace zonegrid {

/// Sets the statement of one cell of a zone, by the zone's place in the window and the cell's place
/// in the zone, order [z][y][x].
void say_in_zone(LocalMap& local_map, std::uint32_t place, std::uint32_t index,
                 std::uint8_t statement);

/// World cells with a statement, and what it is.
[[nodiscard]] oracle::CellValues statements_of(const LocalMap& local_map);

} // namespace zonegrid
