#pragma once

#include "model/constants.h"
#include "zonegrid/objects.h"

#include <bit>
#include <compare>
#include <cstdint>

namespace zonegrid {

/// A point in sub-cells (1/256 cell). Window-relative: 0 <= each < 2^19.
/// It stands for the centre of its sub-cell (docs/model.md, section 3).
struct SubPoint {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    friend auto operator<=>(const SubPoint&, const SubPoint&) = default;
};

/// The cell of a point, both in the same frame.
constexpr CellIndex cell_of(const SubPoint& point) {
    return {point.x >> ZG_SUB_BITS, point.y >> ZG_SUB_BITS, point.z >> ZG_SUB_BITS};
}

/// A ray's displacement per unit of depth, fixed point with ZG_DIRECTION_BITS fraction bits.
struct Direction {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    friend auto operator<=>(const Direction&, const Direction&) = default;
};

/// A zone by its whole-number coordinates in the world: it covers cells
/// [x * zone, (x + 1) * zone) and so on.
struct ZoneIndex {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    friend auto operator<=>(const ZoneIndex&, const ZoneIndex&) = default;
};

/// Quotient rounded towards minus infinity; `divisor` > 0.
template <class Integer>
constexpr Integer floor_div(Integer dividend, Integer divisor) {
    const Integer quotient = dividend / divisor;
    return dividend % divisor < 0 ? quotient - 1 : quotient;
}

constexpr ZoneIndex zone_of(const CellIndex& cell, std::int32_t zone_edge) {
    return {floor_div(cell.x, zone_edge), floor_div(cell.y, zone_edge),
            floor_div(cell.z, zone_edge)};
}

/// Least cell of a zone.
constexpr CellIndex first_cell_of(const ZoneIndex& zone, std::int32_t zone_edge) {
    return {zone.x * zone_edge, zone.y * zone_edge, zone.z * zone_edge};
}

/// Place of a cell in its zone's memory, order [z][y][x].
constexpr std::uint32_t index_in_zone(const CellIndex& cell, std::int32_t zone_edge) {
    const CellIndex first = first_cell_of(zone_of(cell, zone_edge), zone_edge);
    return static_cast<std::uint32_t>(
        ((cell.z - first.z) * zone_edge + (cell.y - first.y)) * zone_edge + (cell.x - first.x));
}

/// Inverse of `index_in_zone`. By shifts: `zone_edge` is a power of two, and this runs per cell.
constexpr CellIndex cell_at(const ZoneIndex& zone, std::uint32_t index, std::int32_t zone_edge) {
    const int bits = std::countr_zero(static_cast<std::uint32_t>(zone_edge));
    const auto place = static_cast<std::int32_t>(index);
    const CellIndex first = first_cell_of(zone, zone_edge);
    return {first.x + (place & (zone_edge - 1)), first.y + (place >> bits & (zone_edge - 1)),
            first.z + (place >> (2 * bits))};
}

} // namespace zonegrid
