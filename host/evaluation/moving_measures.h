#pragma once

#include "evaluation/evaluation.h"

namespace zonegrid {

/// Cells that the moving obstacles touch when image `image` is taken.
[[nodiscard]] CellSet moving_cells(const Truth& truth, std::size_t image, double cell_m,
                                   const CellBox& region);

/// Judges the obstacles that move, in the order of Truth::motions.
[[nodiscard]] std::vector<MovingMeasures> measure_moving(const JudgedMap& map, const Truth& truth,
                                                         const TouchedCells& touched,
                                                         const CellSet& passing,
                                                         const TrueView& view,
                                                         const CellBox& region);

} // namespace zonegrid
