#pragma once

#include "zonegrid/objects.h"

#include <span>

namespace zonegrid::reference {

/// Identifier, count, bounding box and sums of an object's cells (docs/model.md, sections 8.2 and
/// 8.3). `cells`: at least one, each once, any order. Octree and prism are left empty.
[[nodiscard]] Object measure_object(std::span<const CellIndex> cells);

} // namespace zonegrid::reference
