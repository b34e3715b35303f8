#pragma once

#include "evaluation/evaluation.h"
#include "evaluation/solid_cells.h"

namespace zonegrid {

/// Judges cells. `passing`: cells of moving obstacles that count as surfaces, where they were when
/// the last image was taken.
[[nodiscard]] CellMeasures measure_cells(const JudgedMap& map, const TouchedCells& touched,
                                         const CellSet& passing, const TrueView& view,
                                         const SolidCells& solid);

} // namespace zonegrid
