#pragma once

#include "model/tree_root.h"

#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid::reference {

/// Octree of a set of cells (docs/model.md, section 8.4): two bytes a node, depth first.
/// `cells`: each once, any order, all inside `root`.
[[nodiscard]] std::vector<std::uint8_t> encode_octree(std::span<const CellIndex> cells,
                                                      const TreeRoot& root);

/// The cells of an octree, sorted. Inverse of `encode_octree` for the same root.
/// Throws InputError if `octree` is no octree of that size.
[[nodiscard]] std::vector<CellIndex> decode_octree(std::span<const std::uint8_t> octree,
                                                   const TreeRoot& root);

} // namespace zonegrid::reference
