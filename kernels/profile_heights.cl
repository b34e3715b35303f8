// The highest occupied cell of each column of zones (docs/model.md, section 9).
// Twin of shaders/profile_heights.comp.
#include "kernels/common.cl"
#include "kernels/params/profile_heights.h"

__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void profile_heights(
    __global const uint* occupied_planes, // a zone's slot: its occupied cells
    __global const uint* zones,           // a zone to profile: slot, first layer that counts
    __global uint* heights,               // such a zone: least z of each column, four a word
    const struct ProfileHeightsParams params) {
    // 1. A work-group takes a zone, an item four columns at a time.
    const uint zone = group_index();
    if (zone >= params.zones) {
        return;
    }
    const uint zone_bits = (uint)params.zone_bits;
    const uint edge = 1u << zone_bits;
    const uint columns = edge << zone_bits;
    const uint plane = zones[2 * zone] * (columns / 32) * edge;
    for (uint word = item_in_group(); word < columns / 4; word += group_items()) {
        // 2. z points down, so the least counts.
        uint least = ~0u;
        uint left = 15;
        for (uint z = zones[2 * zone + 1]; z < edge && left != 0; ++z) {
            const uint cell = z * columns + 4 * word;
            uint found = occupied_planes[plane + cell / 32] >> (cell % 32) & left;
            left &= ~found;
            for (; found != 0; found &= found - 1) {
                const uint shift = 8 * lowest_bit(found);
                least = (least & ~(255u << shift)) | z << shift;
            }
        }
        heights[zone * (columns / 4) + word] = least;
    }
}
