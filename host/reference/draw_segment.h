#pragma once

#include "model/segment_walk.h"
#include "model/zoned_cells.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace zonegrid::reference {

/// Sets the cells of a segment to one statement while it is walked. A segment stays in a zone for
/// tens of cells, so the zone is looked up only where the segment enters another.
class SegmentPen {
public:
    /// A pen at `start` for segments that go up (+1) or down (-1) on x, y and z.
    SegmentPen(const SubPoint& start, const std::array<std::int32_t, 3>& signs,
               std::uint8_t statement, LocalMap& local_map)
        : local_map_(&local_map), statement_(statement), edge_(local_map.window().zone_edge()) {
        const std::int32_t cells[3] = {start.x >> ZG_SUB_BITS, start.y >> ZG_SUB_BITS,
                                       start.z >> ZG_SUB_BITS};
        std::int32_t stride = 1;
        std::int32_t place_stride = 1;
        std::int32_t index = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t within = cells[i] % edge_;
            step_[i] = std::ptrdiff_t{signs[i]} * stride;
            place_step_[i] = signs[i] * place_stride;
            left_ |= (signs[i] > 0 ? edge_ - 1 - within : within) << (field_bits * i);
            index += within * stride;
            place_ += cells[i] / edge_ * place_stride;
            stride *= edge_;
            place_stride *= local_map.window().zones_per_axis();
        }
        enter_zone(index);
    }

    /// Draws the whole of a segment that starts where this pen stands and goes its way.
    void draw(const Segment& segment) const {
        SegmentPen pen = *this;
        pen.left_ |= segment.crossings() << crossings_shift;
        *pen.cell_ = statement_;
        walk_segment(segment, pen);
    }

    void cross_x() { cross<0>(); }
    void cross_y() { cross<1>(); }
    void cross_z() { cross<2>(); }

    /// Marks the cell arrived at, unless that is beyond the segment's end.
    bool arrive() {
        if ((left_ & borrowed) != 0) [[unlikely]] {
            if (!leave_zone()) {
                return false;
            }
        }
        *cell_ = statement_;
        return true;
    }

private:
    // What is left, in one word, so that one test a step tells everything: for each axis the cells
    // to go before the next crossing leaves the zone (5 bits and one that a borrow sets), then the
    // crossings to go (13 bits, the sign set by a borrow). Separate counters and tests cost as much
    // as the step itself: they crowd the branch predictor, which must foresee the axes.
    static constexpr std::size_t field_bits = 6;
    static constexpr std::size_t crossings_shift = 3 * field_bits;
    static constexpr std::int32_t borrowed_x = 1 << (field_bits - 1);
    static constexpr std::int32_t borrowed_y = borrowed_x << field_bits;
    static constexpr std::int32_t borrowed_z = borrowed_y << field_bits;
    static constexpr std::int32_t borrowed =
        std::numeric_limits<std::int32_t>::min() | borrowed_x | borrowed_y | borrowed_z;

    template <std::size_t axis>
    void cross() {
        cell_ += step_[axis];
        left_ -= (1 << crossings_shift) + (1 << (field_bits * axis));
    }

    // These are forced inline: a call would take the pen's address, which keeps its members out of
    // registers.
    [[gnu::always_inline]] bool leave_zone() {
        // A borrow runs on into the fields above, so the lowest one is the axis just crossed.
        if ((left_ & borrowed_x) != 0) {
            return cross_zone<0>();
        }
        if ((left_ & borrowed_y) != 0) {
            return cross_zone<1>();
        }
        return (left_ & borrowed_z) != 0 && cross_zone<2>();
    }

    template <std::size_t axis>
    [[gnu::always_inline]] bool cross_zone() {
        left_ += edge_ << (field_bits * axis);
        if (left_ < 0) {
            return false;
        }
        place_ += place_step_[axis];
        enter_zone(cell_ - zone_cells_ - edge_ * step_[axis]);
        return true;
    }

    [[gnu::always_inline]] void enter_zone(std::ptrdiff_t index) {
        zone_cells_ = local_map_->touch(static_cast<std::uint32_t>(place_)).data();
        cell_ = zone_cells_ + index;
    }

    LocalMap* local_map_;
    std::uint8_t statement_;
    std::int32_t edge_;
    std::ptrdiff_t step_[3]{};     ///< to the next cell in the zone's memory
    std::int32_t place_step_[3]{}; ///< to the next zone's place in the window
    std::int32_t left_ = 0;
    std::int32_t place_ = 0; ///< of the zone, in the window's table
    std::uint8_t* zone_cells_ = nullptr;
    std::uint8_t* cell_ = nullptr;
};

/// Pens for all segments from one point, one for each combination of directions: what they share is
/// worked out once.
class SegmentPens {
public:
    SegmentPens(const SubPoint& start, std::uint8_t statement, LocalMap& local_map)
        : start_(start) {
        pens_.reserve(8);
        for (std::int32_t octant = 0; octant < 8; ++octant) {
            const auto sign = [octant](std::int32_t bit) { return (octant & bit) != 0 ? -1 : 1; };
            pens_.emplace_back(start, std::array{sign(1), sign(2), sign(4)}, statement, local_map);
        }
    }

    /// Draws the cells of the segment to `end`, which lies in the local map's window.
    void draw_to(const SubPoint& end) const {
        const Segment segment(start_, end);
        const auto bit = [](const SegmentAxis& axis, std::size_t value) {
            return axis.sign < 0 ? value : std::size_t{0};
        };
        pens_[bit(segment.x, 1) | bit(segment.y, 2) | bit(segment.z, 4)].draw(segment);
    }

private:
    SubPoint start_;
    std::vector<SegmentPen> pens_;
};

/// Sets every cell of a segment to one statement. Both ends lie in the local map's window.
inline void draw_segment(const SubPoint& start, const SubPoint& end, std::uint8_t statement,
                         LocalMap& local_map) {
    const Segment segment(start, end);
    SegmentPen(start, {segment.x.sign, segment.y.sign, segment.z.sign}, statement, local_map)
        .draw(segment);
}

/// Sets the cell of a point to one statement.
inline void draw_point(const SubPoint& point, std::uint8_t statement, LocalMap& local_map) {
    const std::int32_t edge = local_map.window().zone_edge();
    const std::int32_t zones = local_map.window().zones_per_axis();
    const CellIndex cell{point.x >> ZG_SUB_BITS, point.y >> ZG_SUB_BITS, point.z >> ZG_SUB_BITS};
    const ZoneIndex zone = zone_of(cell, edge);
    const auto place = static_cast<std::uint32_t>((zone.z * zones + zone.y) * zones + zone.x);
    local_map.touch(place)[index_in_zone(cell, edge)] = statement;
}

} // namespace zonegrid::reference
