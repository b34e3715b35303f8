#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace zonegrid {

/// The part of space that an image can see, window-relative, in integers (docs/model.md,
/// section 3): a cone with four sides from the camera's centre to the range. Lengths are in
/// 1/ZG_VIEW_PER_CELL cell, at most 2^15.
struct View {
    struct Vector {
        std::int32_t x = 0;
        std::int32_t y = 0;
        std::int32_t z = 0;
        friend auto operator<=>(const Vector&, const Vector&) = default;
    };

    bool bounded = false; ///< otherwise it is all of space: a scan, of which no sides are known
    /// Inner normals of left, right, top and bottom, of length 2^ZG_VIEW_NORMAL_BITS.
    std::array<Vector, 4> sides;
    Vector centre;           ///< camera's centre
    std::int32_t radius = 0; ///< the range
};

} // namespace zonegrid
