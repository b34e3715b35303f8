#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace zonegrid {

/// A cell at a face of its zone that belongs to a piece.
struct BorderCell {
    std::uint16_t place = 0; ///< in the layer, which is ordered by the other two axes, lesser first
    std::uint16_t piece = 0; ///< from 1 on
    friend auto operator<=>(const BorderCell&, const BorderCell&) = default;
};

/// The occupied cells of a zone's first or last layer on an axis, ascending by place. Most layers
/// hold few: objects keep one a face for every zone that they were ever in.
using BorderLayer = std::vector<BorderCell>;

} // namespace zonegrid
