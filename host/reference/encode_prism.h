#pragma once

#include "model/tree_root.h"

#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid::reference {

/// Quadtree of the ground plan of a set of cells (docs/model.md, section 8.5): one byte a node,
/// depth first. `cells`: any order, all inside `root` on x and y; their z does not matter.
[[nodiscard]] std::vector<std::uint8_t> encode_prism(std::span<const CellIndex> cells,
                                                     const TreeRoot& root);

} // namespace zonegrid::reference
