#pragma once

#include "zonegrid/objects.h"

#include <array>
#include <cstdint>
#include <vector>

namespace zonegrid::oracle {

/// A sub-cell by its whole-number coordinates (x, y, z), 1/256 cell each; it stands for its centre.
/// Any origin at a cell's border will do; two ends of a segment share it.
using SubCell = std::array<std::int64_t, 3>;

/// The cell a sub-cell lies in.
[[nodiscard]] CellIndex cell_of(const SubCell& sub);

/// Whether the straight segment between the centres of `from` and `to` passes `cell`.
///
/// From geometry alone: on each axis the segment is in the cell's slab during one interval of its
/// parameter; the cell is passed if the three intervals have a moment in common. Where the
/// segment meets an edge or corner exactly, the border in z counts as reached a moment before that
/// in y, and that in y before that in x (docs/model.md, section 4). Ends at most 2^20 sub-cells
/// apart on an axis, so that the exact fractions compare in 64 bits.
[[nodiscard]] bool crossed(const SubCell& from, const SubCell& to, const CellIndex& cell);

/// All cells of the segment's bounding box that are `crossed`, in the order they are entered.
[[nodiscard]] std::vector<CellIndex> segment_cells(const SubCell& from, const SubCell& to);

} // namespace zonegrid::oracle
