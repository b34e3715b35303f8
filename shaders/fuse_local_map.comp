#version 450
#extension GL_GOOGLE_include_directive : require
// Adds local maps to the grid, saturating, zone by zone (docs/model.md, section 7).
// Twin of kernels/fuse_local_map.cl.
#include "kernels/params/fuse_local_map.h"
#include "shaders/common.glsl"

layout(std430, binding = 0) readonly buffer LocalPlanes {
    uint local_planes[]; // a zone: free plane, occupied plane
};
layout(std430, binding = 1) buffer GridCells {
    uint grid_cells[]; // a zone: 4 cells a word
};
layout(std430, binding = 2) buffer OccupiedPlanes {
    uint occupied_planes[]; // a zone: value >= threshold
};
layout(std430, binding = 3) readonly buffer ZonePairs {
    uint zone_pairs[]; // slot in local_planes, in grid_*
};
layout(std430, binding = 4) writeonly buffer ZoneChanges {
    uint zone_changes[]; // a pair: values, occupancies, cells stated
};
layout(push_constant) uniform Arguments {
    FuseLocalMapParams params;
};

shared uint values_changed;
shared uint occupancies_changed;
shared uint cells_stated;

void main() {
    // 1. A work-group takes one pair of zones.
    const uint pair = group_index();
    if (pair >= params.pair_count) {
        return;
    }
    const uint free_plane = zone_pairs[2 * pair] * 2 * params.plane_words;
    const uint occupied_plane = free_plane + params.plane_words;
    const uint grid_plane = zone_pairs[2 * pair + 1] * params.plane_words;
    if (item_in_group() == 0) {
        values_changed = 0;
        occupancies_changed = 0;
        cells_stated = 0;
    }
    barrier();

    // 2. An item takes 32 cells at a time. Where nothing is said, value and occupancy stay.
    uint my_values = 0;
    uint my_occupancies = 0;
    uint my_stated = 0;
    for (uint word = item_in_group(); word < params.plane_words; word += group_items()) {
        const uint occupied = local_planes[occupied_plane + word];
        const uint stated = local_planes[free_plane + word] | occupied;
        if (stated == 0) {
            continue;
        }
        my_stated += count_bits(stated);

        // 3. New values, four cells a word. Occupied beats free.
        uint occupied_after = 0;
        for (uint i = 0; i < 8; ++i) {
            const uint cells_word = (grid_plane + word) * 8 + i;
            const uint cells_before = grid_cells[cells_word];
            uint cells_after = 0;
            for (uint place = 0; place < 4; ++place) {
                const uint bit = 4 * i + place;
                const int before = unpack_cell(cells_before, place);
                const int delta = ((occupied >> bit) & 1) != 0 ? params.hit
                                  : ((stated >> bit) & 1) != 0 ? -params.miss
                                                               : 0;
                const int after = clamp(before + delta, -params.limit, params.limit);
                my_values += after != before ? 1 : 0;
                occupied_after |= (after >= params.threshold ? 1u : 0u) << bit;
                cells_after |= pack_cell(after, place);
            }
            grid_cells[cells_word] = cells_after;
        }

        // 4. The threshold test, and how many cells it now answers differently.
        const uint occupied_before = occupied_planes[grid_plane + word];
        my_occupancies += count_bits(occupied_before ^ occupied_after);
        occupied_planes[grid_plane + word] = occupied_after;
    }

    // 5. Sums over the zone.
    atomicAdd(values_changed, my_values);
    atomicAdd(occupancies_changed, my_occupancies);
    atomicAdd(cells_stated, my_stated);
    barrier();
    if (item_in_group() == 0) {
        zone_changes[3 * pair] = values_changed;
        zone_changes[3 * pair + 1] = occupancies_changed;
        zone_changes[3 * pair + 2] = cells_stated;
    }
}
