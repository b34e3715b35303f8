#pragma once

#include "model/lattice.h"

#include <cassert>
#include <cstdint>
#include <cstdlib>

namespace zonegrid {

/// Walks the cells of a segment in 32-bit integers (docs/model.md, section 4).
class SegmentWalk {
public:
    SegmentWalk(const SubPoint& start, const SubPoint& end)
        : x_(start.x, end.x), y_(start.y, end.y), z_(start.z, end.z) {
        assert(x_.speed < (1 << 19) && y_.speed < (1 << 19) && z_.speed < (1 << 19));
        e_xy_ = x_.to_border * y_.speed - y_.to_border * x_.speed;
        e_xz_ = x_.to_border * z_.speed - z_.to_border * x_.speed;
        e_yz_ = y_.to_border * z_.speed - z_.to_border * y_.speed;
        step_x_ = cell_width * x_.speed;
        step_y_ = cell_width * y_.speed;
        step_z_ = cell_width * z_.speed;
    }

    /// Number of border crossings: one less than the number of cells.
    [[nodiscard]] std::int32_t steps() const { return x_.cells + y_.cells + z_.cells; }
    [[nodiscard]] std::int32_t sign_x() const { return x_.sign; }
    [[nodiscard]] std::int32_t sign_y() const { return y_.sign; }
    [[nodiscard]] std::int32_t sign_z() const { return z_.sign; }

    /// Which axis the next crossing is on: exactly one mask is -1 (all bits), the others 0.
    struct Step {
        std::int32_t x;
        std::int32_t y;
        std::int32_t z;
    };

    /// Takes the next crossing; ties go to z, then y. Masks in place of branches: which axis is
    /// next is close to random and a mispredicted branch costs more than the whole step.
    Step next() {
        const std::int32_t mask_x = (e_xy_ & e_xz_) >> 31;
        const std::int32_t mask_y = (e_yz_ >> 31) & ~mask_x;
        const std::int32_t mask_z = ~(mask_x | mask_y);
        // |e| <= 2^28: pending crossings are at most one cell apart in time.
        e_xy_ += (mask_x & step_y_) - (mask_y & step_x_);
        e_xz_ += (mask_x & step_z_) - (mask_z & step_x_);
        e_yz_ += (mask_y & step_z_) - (mask_z & step_y_);
        return {mask_x, mask_y, mask_z};
    }

private:
    /// Borders are counted in half sub-cells, so that sub-cell centres are whole numbers.
    static constexpr std::int32_t cell_width = 2 * ZG_SUB_PER_CELL;

    struct Axis {
        Axis(std::int32_t start, std::int32_t end)
            : speed(std::abs(end - start)),
              sign(end < start ? -1 : 1),
              cells(std::abs((end >> ZG_SUB_BITS) - (start >> ZG_SUB_BITS))) {
            const std::int32_t within = start & (ZG_SUB_PER_CELL - 1);
            to_border = end > start ? cell_width - 1 - 2 * within : 2 * within + 1;
        }
        std::int32_t speed;
        std::int32_t sign;
        std::int32_t cells;
        std::int32_t to_border;
    };

    Axis x_;
    Axis y_;
    Axis z_;
    std::int32_t e_xy_;
    std::int32_t e_xz_;
    std::int32_t e_yz_;
    std::int32_t step_x_;
    std::int32_t step_y_;
    std::int32_t step_z_;
};

/// Calls `visit(x, y, z)` for every cell of the segment, in order, window-relative cells.
template <class Visit>
void for_each_cell(const SubPoint& start, const SubPoint& end, Visit&& visit) {
    std::int32_t x = start.x >> ZG_SUB_BITS;
    std::int32_t y = start.y >> ZG_SUB_BITS;
    std::int32_t z = start.z >> ZG_SUB_BITS;
    visit(x, y, z);
    SegmentWalk walk(start, end);
    for (std::int32_t left = walk.steps(); left > 0; --left) {
        const auto step = walk.next();
        x += step.x & walk.sign_x();
        y += step.y & walk.sign_y();
        z += step.z & walk.sign_z();
        visit(x, y, z);
    }
}

} // namespace zonegrid
