#pragma once

#include "evaluation/evaluation.h"

#include <span>
#include <vector>

namespace zonegrid {

/// Greatest distance of an obstacle's true middle from the line, for it to stand in a row.
inline constexpr double row_error_m = 1.0;

/// Adds what is between neighbours to those of `lines` whose obstacles stand in a row. `obstacles`
/// are those that the lines were measured of.
void measure_gaps(const JudgedMap& map, const Truth& truth,
                  std::span<const ObstacleMeasures> obstacles, std::vector<LineMeasures>& lines);

} // namespace zonegrid
