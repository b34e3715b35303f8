#pragma once

#include <cstdint>

namespace zonegrid::ops {

/// How zones lie in a device's buffers: zone after zone, cells in the order [z][y][x] throughout.
/// - bit plane: bit i % 32 of word i / 32 for cell i;
/// - local map: a plane of the free cells, then a plane of the occupied cells, which beat them;
/// - grid: a byte a cell, signed, so four cells a word, the first in the lowest byte.
struct ZoneLayout {
    std::uint32_t zone_cells;

    /// `zone_edge`: 8, 16 or 32 cells.
    explicit ZoneLayout(std::int32_t zone_edge)
        : zone_cells(static_cast<std::uint32_t>(zone_edge * zone_edge * zone_edge)) {}

    [[nodiscard]] std::uint32_t plane_words() const { return zone_cells / 32; }
    [[nodiscard]] std::uint64_t plane_bytes() const { return zone_cells / 8; }
    [[nodiscard]] std::uint64_t local_bytes() const { return 2 * plane_bytes(); }
    [[nodiscard]] std::uint64_t grid_bytes() const { return zone_cells; }
};

} // namespace zonegrid::ops
