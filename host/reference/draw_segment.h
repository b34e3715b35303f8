#pragma once

#include "model/local_map.h"
#include "model/segment_walk.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace zonegrid::reference {

/// Sets the cells of segments from one point to one statement, all in one octant: what they share
/// is here. A segment stays in a brick for tens of cells, so the brick is looked up only where the
/// segment enters another.
class SegmentPen {
public:
    /// A pen at `start` for segments that go up (+1) or down (-1) on x, y and z.
    SegmentPen(const SubPoint& start, const std::array<std::int32_t, 3>& signs,
               std::uint8_t statement, LocalMap& local_map)
        : local_map_(&local_map), statement_(statement) {
        const CellIndex cell = cell_of(start);
        const std::array within{cell.x & (edge - 1), cell.y & (edge - 1), cell.z & (edge - 1)};
        std::int32_t stride = 1;
        std::int32_t brick_stride = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            const Word to_go = signs[i] > 0 ? edge - 1 - within[i] : within[i];
            left_ |= to_go << (field_bits * i);
            axes_[i] = {std::ptrdiff_t{signs[i]} * stride, std::ptrdiff_t{signs[i]} * stride * edge,
                        signs[i] * brick_stride, Word{edge} << (field_bits * i)};
            stride *= edge;
            brick_stride *= local_map.bricks_per_axis();
        }
        brick_ = local_map.brick_of(cell);
        cell_ = local_map.touch(brick_) + LocalMap::index_in_brick(cell);
    }

    /// Draws the whole of a segment that starts where this pen stands and goes its way. Never
    /// inlined: a loop that shares its registers with the caller's runs a tenth slower.
    [[gnu::noinline]] void draw(const Segment& segment) const {
        *cell_ = statement_;
        walk_segment(segment, Stroke(*this, segment.crossings()));
    }

private:
    // What is left, in one word, so that one test a step tells everything: for each axis the cells
    // to go before the next crossing leaves the brick (6 bits and one that a borrow sets), then the
    // crossings to go (the sign set by a borrow). Separate counters and tests cost as much as the
    // step itself: they crowd the branch predictor, which must foresee the axes.
    using Word = std::int64_t;
    static constexpr std::int32_t edge = LocalMap::brick_edge;
    static constexpr unsigned field_bits = LocalMap::brick_bits + 1;
    static constexpr unsigned crossings_shift = 3 * field_bits;
    static constexpr Word borrowed_x = edge;
    static constexpr Word borrowed = std::numeric_limits<Word>::min() | borrowed_x |
                                     borrowed_x << field_bits | borrowed_x << (2 * field_bits);

    struct Axis {
        std::ptrdiff_t step = 0;     ///< to the next cell in the brick's memory
        std::ptrdiff_t back = 0;     ///< what a crossing into the next brick steps too far
        std::int32_t brick_step = 0; ///< to the next brick's place in the window
        Word refill = 0;             ///< the edge of a brick, in the axis' field
    };

    /// What changes on the way: so little that it stays in registers.
    class Stroke {
    public:
        Stroke(const SegmentPen& pen, std::int32_t crossings)
            : pen_(&pen),
              left_(pen.left_ | Word{crossings} << crossings_shift),
              brick_(pen.brick_),
              cell_(pen.cell_) {}

        void cross_x() { cross<0>(); }
        void cross_y() { cross<1>(); }
        void cross_z() { cross<2>(); }

        /// Marks the cell arrived at, unless that is beyond the segment's end.
        bool arrive() {
            if ((left_ & borrowed) != 0) [[unlikely]] {
                if (!enter_brick()) {
                    return false;
                }
            }
            *cell_ = pen_->statement_;
            return true;
        }

    private:
        template <std::size_t axis>
        void cross() {
            cell_ += pen_->axes_[axis].step;
            left_ -= (Word{1} << crossings_shift) + (Word{1} << (field_bits * axis));
        }

        // Forced inline: a call would take the stroke's address, which keeps it out of registers.
        [[gnu::always_inline]] bool enter_brick() {
            // A borrow runs on into the fields above, so the lowest one is the axis just crossed,
            // or the crossings'. No branch chooses the axis: it could not be foreseen.
            const auto lowest = static_cast<unsigned>(
                std::countr_zero(static_cast<std::uint64_t>(left_ & borrowed)));
            if (lowest >= crossings_shift) {
                return false;
            }
            const Axis& axis = pen_->axes_[lowest / field_bits];
            left_ += axis.refill;
            if (left_ < 0) {
                return false;
            }
            LocalMap& local_map = *pen_->local_map_;
            const auto index = cell_ - local_map.touch(brick_) - axis.back;
            brick_ += static_cast<std::uint32_t>(axis.brick_step);
            cell_ = local_map.touch(brick_) + index;
            return true;
        }

        const SegmentPen* pen_;
        Word left_;
        std::uint32_t brick_;
        std::uint8_t* cell_;
    };

    LocalMap* local_map_;
    std::uint8_t statement_;
    std::array<Axis, 3> axes_;
    Word left_ = 0;
    std::uint32_t brick_ = 0;
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
    local_map.set(cell_of(point), statement);
}

} // namespace zonegrid::reference
