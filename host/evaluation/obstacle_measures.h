#pragma once

#include "evaluation/evaluation.h"

#include <span>
#include <vector>

namespace zonegrid {

/// Judges the obstacles that do not move and that the view has seen, in their order.
[[nodiscard]] std::vector<ObstacleMeasures> measure_obstacles(const JudgedMap& map,
                                                              const Truth& truth,
                                                              const TouchedCells& touched,
                                                              const TrueView& view);

/// For each kind, but ground, with three found obstacles or more.
[[nodiscard]] std::vector<LineMeasures> measure_lines(std::span<const ObstacleMeasures> obstacles);

} // namespace zonegrid
