#pragma once

#include "model/lattice.h"

#include <cassert>
#include <cstdint>
#include <cstdlib>

namespace zonegrid {

/// One axis of a segment between two sub-cell centres (docs/model.md, section 4).
struct SegmentAxis {
    /// Borders are counted in half sub-cells, so that sub-cell centres are whole numbers.
    static constexpr std::int32_t cell_width = 2 * ZG_SUB_PER_CELL;

    SegmentAxis(std::int32_t start, std::int32_t end)
        : distance(std::abs(end - start)),
          sign(end < start ? -1 : 1),
          first_cell(start >> ZG_SUB_BITS),
          crossings(std::abs((end >> ZG_SUB_BITS) - first_cell)) {
        assert(distance < (1 << 19));
        const std::int32_t within = start & (ZG_SUB_PER_CELL - 1);
        to_border = end > start ? cell_width - 1 - 2 * within : 2 * within + 1;
    }

    std::int32_t distance;   ///< sub-cells
    std::int32_t sign;       ///< direction of travel
    std::int32_t first_cell; ///< cell of the start
    std::int32_t crossings;  ///< cell borders between start and end
    std::int32_t to_border;  ///< from the start to the first border, half sub-cells
};

struct Segment {
    Segment(const SubPoint& start, const SubPoint& end)
        : x(start.x, end.x), y(start.y, end.y), z(start.z, end.z) {}

    /// Cell borders between start and end: one less than the number of cells.
    [[nodiscard]] std::int32_t crossings() const { return x.crossings + y.crossings + z.crossings; }

    SegmentAxis x;
    SegmentAxis y;
    SegmentAxis z;
};

/// Walks a segment from cell to cell in 32-bit integers. For each border, in order (ties go to z,
/// then y), calls `visitor.cross_x()`, `.cross_y()` or `.cross_z()`, then `visitor.arrive()`; ends
/// when that returns false. The crossings go on beyond the segment's end: the visitor counts.
///
/// The visitor is taken by value, and the walk forced inline: only as a local variable do its
/// members stay in registers, and a call costs as much as ten steps.
template <class Visitor>
[[gnu::always_inline]] inline void walk_segment(const Segment& segment, Visitor visitor) {
    const auto& [x, y, z] = segment;
    // |e| <= 2^28: two pending crossings are at most one cell apart in time.
    std::int32_t e_xy = x.to_border * y.distance - y.to_border * x.distance;
    std::int32_t e_xz = x.to_border * z.distance - z.to_border * x.distance;
    std::int32_t e_yz = y.to_border * z.distance - z.to_border * y.distance;
    const std::int32_t step_x = SegmentAxis::cell_width * x.distance;
    const std::int32_t step_y = SegmentAxis::cell_width * y.distance;
    const std::int32_t step_z = SegmentAxis::cell_width * z.distance;
    do {
        if (e_xy < 0 && e_xz < 0) {
            e_xy += step_y;
            e_xz += step_z;
            visitor.cross_x();
        } else if (e_yz < 0) {
            e_xy -= step_x;
            e_yz += step_z;
            visitor.cross_y();
        } else {
            e_xz -= step_x;
            e_yz -= step_y;
            visitor.cross_z();
        }
    } while (visitor.arrive());
}

/// Calls `visit(x, y, z)` for every cell of the segment, in order, window-relative cells.
template <class Visit>
void for_each_cell(const SubPoint& start, const SubPoint& end, Visit&& visit) {
    const Segment segment(start, end);
    struct {
        Visit& visit;
        const Segment& segment;
        std::int32_t x;
        std::int32_t y;
        std::int32_t z;
        std::int32_t left;
        void cross_x() { x += segment.x.sign; }
        void cross_y() { y += segment.y.sign; }
        void cross_z() { z += segment.z.sign; }
        bool arrive() {
            if (--left < 0) {
                return false;
            }
            visit(x, y, z);
            return true;
        }
    } visitor{visit,
              segment,
              segment.x.first_cell,
              segment.y.first_cell,
              segment.z.first_cell,
              segment.crossings()};
    visit(visitor.x, visitor.y, visitor.z);
    walk_segment(segment, visitor);
}

} // namespace zonegrid
