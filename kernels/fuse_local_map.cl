// Adds local maps to the grid, saturating, zone by zone (docs/model.md, section 7).
// Twin of shaders/fuse_local_map.comp.
#include "kernels/common.cl"
#include "kernels/params/fuse_local_map.h"

// How far inside of one of the view's sides that corner of a cell lies that is least inside.
// x, y, z: from the view's centre to the cell's first corner.
int least_inside(const struct FuseLocalMapParams* params, uint side, int x, int y, int z) {
    const int nx = params->view_side_x[side];
    const int ny = params->view_side_y[side];
    const int nz = params->view_side_z[side];
    return nx * x + ny * y + nz * z + ZG_VIEW_PER_CELL * (min(nx, 0) + min(ny, 0) + min(nz, 0));
}

// How far that end of a cell lies from the view's centre on an axis that is farther from it,
// squared.
uint farther_squared(int first) {
    const int way = max(-first, first + ZG_VIEW_PER_CELL);
    return as_uint(way * way);
}

// Whether all of a cell lies in the view. cell: its place in the zone.
bool sees_whole(const struct FuseLocalMapParams* params, uint zone_in_window, uint cell) {
    if (params->view_bounded == 0) {
        return true;
    }
    const uint bits = params->zone_bits;
    const uint within = (1u << bits) - 1;
    const uint cell_x = ((zone_in_window & 255) << bits) + (cell & within);
    const uint cell_y = ((zone_in_window >> 8 & 255) << bits) + (cell >> bits & within);
    const uint cell_z = ((zone_in_window >> 16) << bits) + (cell >> (2 * bits));
    const int x = ZG_VIEW_PER_CELL * as_int(cell_x) - params->view_centre[0];
    const int y = ZG_VIEW_PER_CELL * as_int(cell_y) - params->view_centre[1];
    const int z = ZG_VIEW_PER_CELL * as_int(cell_z) - params->view_centre[2];
    for (uint side = 0; side < 4; ++side) {
        if (least_inside(params, side, x, y, z) < ZG_VIEW_MARGIN << ZG_VIEW_NORMAL_BITS) {
            return false;
        }
    }
    const uint radius = as_uint(params->view_radius - ZG_VIEW_MARGIN);
    return farther_squared(x) + farther_squared(y) + farther_squared(z) <= radius * radius;
}

__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void fuse_local_map(
    __global const uint* local_planes, // a zone: free plane, occupied plane
    __global uint* grid_cells,         // a zone: 4 cells a word
    __global uint* occupied_planes,    // a zone: value >= threshold
    __global const uint*
        zone_pairs, // slot in local_planes, in grid_*, zone's x, y, z in the window by bytes
    __global uint* zone_changes, // a pair: values, occupancies, cells stated
    const struct FuseLocalMapParams params) {
    __local uint values_changed;
    __local uint occupancies_changed;
    __local uint cells_stated;

    // 1. A work-group takes one pair of zones.
    const uint pair = group_index();
    if (pair >= params.pair_count) {
        return;
    }
    const uint free_plane = zone_pairs[3 * pair] * 2 * params.plane_words;
    const uint occupied_plane = free_plane + params.plane_words;
    const uint grid_plane = zone_pairs[3 * pair + 1] * params.plane_words;
    const uint zone_in_window = zone_pairs[3 * pair + 2];
    if (item_in_group() == 0) {
        values_changed = 0;
        occupancies_changed = 0;
        cells_stated = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);

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

        // 3. New values, four cells a word. Occupied beats free. Obstacles are denied only where
        // all of their cell is seen.
        uint occupied_after = 0;
        for (uint i = 0; i < 8; ++i) {
            const uint cells_word = (grid_plane + word) * 8 + i;
            const uint cells_before = grid_cells[cells_word];
            uint cells_after = 0;
            for (uint place = 0; place < 4; ++place) {
                const uint bit = 4 * i + place;
                const int before = unpack_cell(cells_before, place);
                int delta = 0;
                if (((occupied >> bit) & 1) != 0) {
                    delta = params.hit;
                } else if (((stated >> bit) & 1) != 0 &&
                           (before < params.threshold ||
                            sees_whole(&params, zone_in_window, 32 * word + bit))) {
                    delta = -params.miss;
                }
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
    atomic_add(&values_changed, my_values);
    atomic_add(&occupancies_changed, my_occupancies);
    atomic_add(&cells_stated, my_stated);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item_in_group() == 0) {
        zone_changes[3 * pair] = values_changed;
        zone_changes[3 * pair + 1] = occupancies_changed;
        zone_changes[3 * pair + 2] = cells_stated;
    }
}
