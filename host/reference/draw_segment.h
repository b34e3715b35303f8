#pragma once

#include "model/segment_walk.h"
#include "model/zoned_cells.h"

#include <cstdint>

namespace zonegrid::reference {

/// Sets every cell of a segment to one statement. Both ends lie in the local map's window.
inline void draw_segment(const SubPoint& start, const SubPoint& end, std::uint8_t statement,
                         LocalMap& local_map) {
    // A segment stays in a zone for tens of cells: the zone is looked up only where the segment
    // crosses into another. `left` packs, a byte an axis, how many steps remain before that.
    const Window& window = local_map.window();
    const std::int32_t edge = window.zone_edge();
    const std::int32_t zones = window.zones_per_axis();
    SegmentWalk walk(start, end);

    struct Axis {
        Axis(std::int32_t sub, std::int32_t sign, std::int32_t zone_edge)
            : zone((sub >> ZG_SUB_BITS) / zone_edge),
              within((sub >> ZG_SUB_BITS) % zone_edge),
              left(sign > 0 ? zone_edge - 1 - within : within) {}
        std::int32_t zone;
        std::int32_t within;
        std::int32_t left;
    };
    const Axis x(start.x, walk.sign_x(), edge);
    const Axis y(start.y, walk.sign_y(), edge);
    const Axis z(start.z, walk.sign_z(), edge);

    std::int32_t place = (z.zone * zones + y.zone) * zones + x.zone;
    std::int32_t index = (z.within * edge + y.within) * edge + x.within;
    std::int32_t left = x.left | y.left << 8 | z.left << 16;
    const std::int32_t stride_x = walk.sign_x();
    const std::int32_t stride_y = walk.sign_y() * edge;
    const std::int32_t stride_z = walk.sign_z() * edge * edge;
    constexpr std::int32_t borrowed = 0x808080;

    std::uint8_t* cells = local_map.touch(static_cast<std::uint32_t>(place)).data();
    cells[index] = statement;
    for (std::int32_t steps = walk.steps(); steps > 0; --steps) {
        const auto step = walk.next();
        index += (step.x & stride_x) + (step.y & stride_y) + (step.z & stride_z);
        left -= (step.x & 1) + (step.y & 1 << 8) + (step.z & 1 << 16);
        if ((left & borrowed) != 0) {
            index -= edge * ((step.x & stride_x) + (step.y & stride_y) + (step.z & stride_z));
            left += (step.x & edge) + (step.y & edge << 8) + (step.z & edge << 16);
            place += (step.x & walk.sign_x()) + (step.y & walk.sign_y() * zones) +
                     (step.z & walk.sign_z() * zones * zones);
            cells = local_map.touch(static_cast<std::uint32_t>(place)).data();
        }
        cells[index] = statement;
    }
}

} // namespace zonegrid::reference
