// Draws a depth image into a local map (docs/model.md, section 5): fills the cells that it can
// prove free without walking, then walks what is left of every ray. docs/filling.md has the proofs.
// Twin of shaders/integrate_image.comp.
#include "kernels/params/integrate_image.h"
#include "kernels/parts/draw_segment.cl"

// Windows of level 0 are pixels, those of level l are squares of 2^l pixels, half overlapping from
// level 2 on. Distance between two of a level.
int window_stride(int level) {
    return level < 2 ? 1 : 1 << (level - 1);
}

// How many windows of a level stand on an image axis of `pixels`.
int window_count(int pixels, int level) {
    const int stride = window_stride(level);
    return (pixels + stride - 1) / stride;
}

// Where a level starts in the buffer of windows.
int window_offset(int width_px, int height_px, int level) {
    int offset = 0;
    for (int l = 0; l < level; ++l) {
        offset += window_count(width_px, l) * window_count(height_px, l);
    }
    return offset;
}

// Free space of the deepest pixel in each window; -1: all are missing.
__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void deepen_windows(
    __global const int* depths, // a pixel: near, far
    __global int* windows,      // level after level
    const struct DeepenWindowsParams params) {
    // 1. An item takes a row's next ZG_WINDOWS_AN_ITEM windows.
    const int columns = window_count(params.width_px, params.level);
    const int rows = window_count(params.height_px, params.level);
    const int parts = (columns + ZG_WINDOWS_AN_ITEM - 1) / ZG_WINDOWS_AN_ITEM;
    const int item = (int)(group_index() * group_items() + item_in_group());
    const int row = item / parts;
    if (row >= rows) {
        return;
    }
    const int first = item % parts * ZG_WINDOWS_AN_ITEM;
    const int last = min(first + ZG_WINDOWS_AN_ITEM, columns) - 1;
    const int here = window_offset(params.width_px, params.height_px, params.level) + row * columns;
    if (params.level == 0) {
        for (int column = first; column <= last; ++column) {
            windows[here + column] = depths[2 * (row * columns + column)];
        }
        return;
    }

    // 2. Four windows of the level before are one of this.
    const int scale = params.level == 1 ? 1 : 2;
    const int columns_before = window_count(params.width_px, params.level - 1);
    const int rows_before = window_count(params.height_px, params.level - 1);
    const int before = window_offset(params.width_px, params.height_px, params.level - 1);
    const int top = before + scale * row * columns_before;
    const int bottom = before + min(scale * row + scale, rows_before - 1) * columns_before;
    for (int column = first; column <= last; ++column) {
        const int left = scale * column;
        const int right = min(left + scale, columns_before - 1);
        windows[here + column] = max(max(windows[top + left], windows[top + right]),
                                     max(windows[bottom + left], windows[bottom + right]));
    }
}

// Do two ends of a row of cells lie so far beyond a side of the image that no cell between them can
// be filled? `beyond` counts pixels times depth, linear along the row.
bool outside(float beyond_first, float beyond_last, float reach) {
    return beyond_first > reach && beyond_last > reach;
}

// Sets the free plane of each reserved zone: cells of which it can be told without a walk that a
// ray passes them. Floats only choose the window to ask; where they are unsure, a cell stays empty.
__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void fill_cells(
    __global uint* local_planes, // a zone: free plane, occupied plane
    __global const uint* places, // of the reserved zones, in the window
    __global const int* windows, // level after level
    const struct FillCellsParams params) {
    // 1. A work-group takes a zone.
    const uint zone = group_index();
    if (zone >= params.zones) {
        return;
    }
    const int zone_bits = params.local_map.zone_bits;
    const int mask = (1 << zone_bits) - 1;
    const int zones = params.local_map.zones_per_axis;
    const int place = (int)places[zone];
    const int3 first_cell = (int3)(place % zones, place / zones % zones, place / (zones * zones))
                            << zone_bits;
    const int3 origin = (int3)(params.origin[0], params.origin[1], params.origin[2]);
    const float cell_sub = (float)ZG_SUB_PER_CELL;
    const float u_x = params.rows[0] * cell_sub;
    const float v_x = params.rows[3] * cell_sub;
    const float q_x = params.rows[6] * cell_sub;
    const float u_y = params.rows[1] * cell_sub;
    const float v_y = params.rows[4] * cell_sub;
    const float q_y = params.rows[7] * cell_sub;
    const float x_last = (float)min(mask, 31);
    const float y_last = (float)(31 >> zone_bits);
    const float u_most = (float)(params.width_px - 1);
    const float v_most = (float)(params.height_px - 1);
    const float widest_u = max(params.right[0], max(params.right[1], params.right[2]));
    const float widest_v = max(params.down[0], max(params.down[1], params.down[2]));
    const float widest =
        max(params.right[0] + params.down[0],
            max(params.right[1] + params.down[1], params.right[2] + params.down[2]));

    for (uint word = item_in_group(); word < params.local_map.plane_words; word += group_items()) {
        // 2. An item takes 32 cells at a time. The first one's centre from the camera, and the
        // row's two ends in the image.
        const int index = (int)(32 * word);
        const int3 cell = first_cell + (int3)(index & mask, (index >> zone_bits) & mask,
                                              index >> (2 * zone_bits));
        const int3 centre = (cell << ZG_SUB_BITS) + ZG_SUB_PER_CELL / 2 - origin;
        const float g_x = (float)centre.x - 0.5f;
        const float g_y = (float)centre.y - 0.5f;
        const float g_z = (float)centre.z - 0.5f;
        const float u_first = params.rows[0] * g_x + params.rows[1] * g_y + params.rows[2] * g_z;
        const float v_first = params.rows[3] * g_x + params.rows[4] * g_y + params.rows[5] * g_z;
        const float q_first = params.rows[6] * g_x + params.rows[7] * g_y + params.rows[8] * g_z;
        const float u_last = u_first + x_last * u_x + y_last * u_y;
        const float v_last = v_first + x_last * v_x + y_last * v_y;
        const float q_last = q_first + x_last * q_x + y_last * q_y;
        const float q_most = max(q_first, q_last);
        uint bits = 0;
        if (q_most >= ZG_FILL_NEAREST && min(q_first, q_last) <= (float)params.deepest &&
            !outside(-u_first, -u_last, ZG_FILL_ASIDE / widest_u) &&
            !outside(u_first - u_most * q_first, u_last - u_most * q_last,
                     ZG_FILL_ASIDE / widest_u) &&
            !outside(-v_first, -v_last, ZG_FILL_ASIDE / widest_v) &&
            !outside(v_first - v_most * q_first, v_last - v_most * q_last,
                     ZG_FILL_ASIDE / widest_v)) {
            // 3. The largest windows whose rays are surely close enough to each other at this
            // depth.
            int level = 0;
            while (level < ZG_WINDOW_LEVELS - 1 &&
                   (1.5f * (float)window_stride(level + 1) - 0.5f + params.slack_px) * widest *
                           q_most <=
                       ZG_FILL_WINDOW) {
                ++level;
            }
            __global const int* const deepest =
                windows + window_offset(params.width_px, params.height_px, level);
            const int columns = window_count(params.width_px, level);
            const float column_most = (float)(columns - 1);
            const float row_most = (float)(window_count(params.height_px, level) - 1);
            const float stride = (float)window_stride(level);
            const float per_stride = 1.0f / stride;
            const float middle = level == 0 ? 0.5f : 0.5f * per_stride - 0.5f;
            const float width = (float)((1 << level) - 1);
            const float farthest = fabs(g_x) + fabs(g_y) + fabs(g_z) + cell_sub * (x_last + y_last);

            // 4. A cell is passed if all rays of the window nearest to its centre pass inside it
            // where they are as deep as it, and one of them goes so far.
            for (int i = 0; i < 32; ++i) {
                const float x = (float)(i & mask);
                const float y = (float)(i >> zone_bits);
                const float depth = q_first + x * q_x + y * q_y;
                const float q = depth < ZG_FILL_NEAREST ? ZG_FILL_NEAREST : depth;
                const float u = (u_first + x * u_x + y * u_y) / q;
                const float v = (v_first + x * v_x + y * v_y) / q;
                float column = u * per_stride + middle;
                column = column < 0.0f ? 0.0f : column;
                column = column > column_most ? column_most : column;
                float row = v * per_stride + middle;
                row = row < 0.0f ? 0.0f : row;
                row = row > row_most ? row_most : row;
                const int column_index = (int)column;
                const int row_index = (int)row;
                const float left = (float)column_index * stride;
                const float top = (float)row_index * stride;
                const float right = left + width < u_most ? left + width : u_most;
                const float bottom = top + width < v_most ? top + width : v_most;
                const float aside = (u - left > right - u ? u - left : right - u) + params.slack_px;
                const float above = (v - top > bottom - v ? v - top : bottom - v) + params.slack_px;
                const float off_x = (aside * params.right[0] + above * params.down[0]) * q;
                const float off_y = (aside * params.right[1] + above * params.down[1]) * q;
                const float off_z = (aside * params.right[2] + above * params.down[2]) * q;
                const float reached = (float)deepest[row_index * columns + column_index];
                const bool passed = (depth >= ZG_FILL_NEAREST) & (16.0f * q >= farthest) &
                                    (off_x <= ZG_FILL_ASIDE) & (off_y <= ZG_FILL_ASIDE) &
                                    (off_z <= ZG_FILL_ASIDE) & (reached >= q + ZG_FILL_DEEPER);
                bits |= (passed ? 1u : 0u) << i;
            }
        }
        local_planes[2 * (zone + 1) * params.local_map.plane_words + word] = bits;
    }
}

// Displacement of sub-ray `i` of 2^level from its pixel's centre on one image axis.
int3 sub_ray_offset(int3 per_pixel, int i, int level) {
    const int m = 2 * i + 1 - (1 << level);
    const uint shift = (uint)(level + 1);
    return (int3)(shifted_product(per_pixel.x, m, shift), shifted_product(per_pixel.y, m, shift),
                  shifted_product(per_pixel.z, m, shift));
}

// The point at `depth` along `direction`.
int3 point_at(int3 origin, int3 direction, int depth) {
    return origin + (int3)(shifted_product(direction.x, depth, ZG_DIRECTION_BITS),
                           shifted_product(direction.y, depth, ZG_DIRECTION_BITS),
                           shifted_product(direction.z, depth, ZG_DIRECTION_BITS));
}

// Sub-rays of a pixel, 2^level by 2^level, are no further apart than a cell at `depth`.
int split_level(const struct IntegrateImageParams* params, int depth) {
    int level = 0;
    while (params->spanned != 0 && level < ZG_MAX_SPLIT_LEVEL &&
           (params->spacing << level) < depth) {
        ++level;
    }
    return level;
}

// Direction through the centre of a pixel of an ideal pinhole camera.
int3 pinhole_direction(const struct IntegrateImageParams* params, int u_px, int v_px) {
    return (int3)(params->a[0], params->a[1], params->a[2]) +
           u_px * (int3)(params->u[0], params->u[1], params->u[2]) +
           v_px * (int3)(params->v[0], params->v[1], params->v[2]);
}

// Walks the beginning of one ray a tile, the deepest one's: close to the camera all rays pass the
// same few cells.
__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void draw_near(
    volatile __global uint* local_planes, // a zone: free plane, occupied plane
    __global const uint* zone_slots,      // by place in the window
    volatile __global uint* faults,       // zones entered that nobody reserved
    __global const int* depths,           // a pixel: near, far
    const struct IntegrateImageParams params) {
    const int tile = (int)(group_index() * group_items() + item_in_group());
    const int tile_px = 1 << params.tile_level;
    const int columns = (params.width_px + tile_px - 1) / tile_px;
    const int u_first = tile % columns * tile_px;
    const int v_first = tile / columns * tile_px;
    int deepest = -1;
    int u_px = 0;
    int v_px = 0;
    for (int v = v_first; v < min(v_first + tile_px, params.height_px); ++v) {
        for (int u = u_first; u < min(u_first + tile_px, params.width_px); ++u) {
            const int near = depths[2 * (v * params.width_px + u)];
            if (near > deepest) {
                deepest = near;
                u_px = u;
                v_px = v;
            }
        }
    }
    if (deepest < 0) {
        return;
    }
    const LocalMap map = {local_planes, zone_slots, faults, params.local_map};
    const int3 origin = (int3)(params.origin[0], params.origin[1], params.origin[2]);
    const int far = depths[2 * (v_px * params.width_px + u_px) + 1];
    const int level = split_level(&params, far >= 0 ? far : deepest);
    int3 direction = pinhole_direction(&params, u_px, v_px);
    if (level > 0) {
        direction += sub_ray_offset((int3)(params.u[0], params.u[1], params.u[2]), 0, level) +
                     sub_ray_offset((int3)(params.v[0], params.v[1], params.v[2]), 0, level);
    }
    draw_segment_part(&map, ZG_FREE_PLANE, origin, point_at(origin, direction, deepest), 0.0f,
                      ZG_NEAR_CROSSINGS);
}

// Are all cells of a box free already?
bool all_free(const LocalMap* map, int3 least, int3 greatest) {
    const int mask = (1 << map->params.zone_bits) - 1;
    const int edge = map->params.zones_per_axis << map->params.zone_bits;
    if (min(least.x, min(least.y, least.z)) < 0 ||
        max(greatest.x, max(greatest.y, greatest.z)) >= edge) {
        return false;
    }
    for (int z = least.z; z <= greatest.z; ++z) {
        for (int y = least.y; y <= greatest.y; ++y) {
            // A zone's row of cells along x lies in one word.
            for (int x = least.x; x <= greatest.x;) {
                const int3 cell = (int3)(x, y, z);
                const int last = min(greatest.x, x | mask);
                const uint slot = slot_of(map, cell);
                const uint index = index_in_zone(map, cell);
                const uint bits = (~0u >> (31 - (last - x))) << (index % 32);
                if (slot == 0 ||
                    (map->planes[2 * slot * map->params.plane_words + index / 32] & bits) != bits) {
                    return false;
                }
                x = last + 1;
            }
        }
    }
    return true;
}

// Finds for each tile a depth up to which all of its rays pass cells that are free already.
// INT_MAX: to their ends.
__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void skip_tiles(
    volatile __global uint* local_planes, // a zone: free plane, occupied plane
    __global const uint* zone_slots,      // by place in the window
    volatile __global uint* faults,       // zones entered that nobody reserved
    __global const int* windows,          // level after level
    __global const int* wide_skips,       // a tile of wide_level
    __global int* skips,                  // a tile
    const struct IntegrateImageParams params) {
    // 1. An item takes a tile, which is a window too. Its directions lie in a box.
    const int tile = (int)(group_index() * group_items() + item_in_group());
    const int tile_px = 1 << params.tile_level;
    const int columns = (params.width_px + tile_px - 1) / tile_px;
    const int rows = (params.height_px + tile_px - 1) / tile_px;
    if (tile >= columns * rows) {
        return;
    }
    const int column = tile % columns;
    const int row = tile / columns;
    const int deepest =
        windows[window_offset(params.width_px, params.height_px, params.tile_level) +
                2 * row * window_count(params.width_px, params.tile_level) + 2 * column];
    const int u_first = column * tile_px;
    const int v_first = row * tile_px;
    const int u_last = min(u_first + tile_px, params.width_px) - 1;
    const int v_last = min(v_first + tile_px, params.height_px) - 1;
    const int3 corner_0 = pinhole_direction(&params, u_first, v_first);
    const int3 corner_1 = pinhole_direction(&params, u_last, v_first);
    const int3 corner_2 = pinhole_direction(&params, u_first, v_last);
    const int3 corner_3 = pinhole_direction(&params, u_last, v_last);
    int3 least = min(min(corner_0, corner_1), min(corner_2, corner_3));
    int3 greatest = max(max(corner_0, corner_1), max(corner_2, corner_3));
    if (params.spanned != 0) {
        // Sub-rays stay within half a pixel of its centre.
        const int3 u = (int3)(params.u[0], params.u[1], params.u[2]);
        const int3 v = (int3)(params.v[0], params.v[1], params.v[2]);
        const int3 aside = (max(u, -u) >> 1) + (max(v, -v) >> 1) + 2;
        least -= aside;
        greatest += aside;
    }

    // 2. Slice after slice, the box around all rays between two depths.
    const LocalMap map = {local_planes, zone_slots, faults, params.local_map};
    const int3 origin = (int3)(params.origin[0], params.origin[1], params.origin[2]);
    int from = 0;
    if (params.wide_level > 0) {
        const int wide_px = 1 << params.wide_level;
        from = wide_skips[v_first / wide_px * ((params.width_px + wide_px - 1) / wide_px) +
                          u_first / wide_px];
    }
    int slice = params.slice;
    int rows_left = ZG_SKIP_ROWS;
    while (from < deepest && slice >= ZG_LEAST_SLICE) {
        const int to = min(from + slice, deepest);
        const int3 zero = (int3)(0);
        int3 low = min(point_at(zero, least, from), point_at(zero, least, to));
        int3 high = max(point_at(zero, greatest, from), point_at(zero, greatest, to));
        // Ends are rounded down to a sub-cell, so rays run up to one below the exact line, but
        // never to the other side of the camera.
        low = select(max(low - 1, zero), low - 1, least < 0);
        high = select(min(high + 1, zero), high + 1, greatest > 0);
        low = (origin + low) >> ZG_SUB_BITS;
        high = (origin + high) >> ZG_SUB_BITS;
        rows_left -= (high.y - low.y + 1) * (high.z - low.z + 1);
        if (rows_left < 0) {
            break;
        }
        if (all_free(&map, low, high)) {
            from = to;
            slice = min(2 * slice, params.slice);
        } else {
            slice /= 2;
        }
    }
    // A ray of no length needs the camera's cell alone, which draw_near has drawn.
    skips[tile] = from >= deepest ? INT_MAX : from;
}

// Draws what is left of each ray.
__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void draw_rays(
    volatile __global uint* local_planes, // a zone: free plane, occupied plane
    __global const uint* zone_slots,      // by place in the window
    volatile __global uint* faults,       // zones entered that nobody reserved
    __global const int* depths,           // a pixel: near, far
    __global const int* directions,       // a pixel: x, y, z
    __global const int* skips,            // a tile
    const struct IntegrateImageParams params) {
    // 1. An item takes one sub-ray of a pixel, if the pixel is split so often. All sub-rays of a
    // pixel would be too many steps for one item: some devices end loops after 65535 rounds.
    const uint item = group_index() * group_items() + item_in_group();
    const int pixel = (int)(item >> (2 * params.most_split));
    if (pixel >= params.width_px * params.height_px) {
        return;
    }
    const int near = depths[2 * pixel];
    const int far = depths[2 * pixel + 1];
    if (near < 0) { // missing
        return;
    }
    const int level = split_level(&params, far >= 0 ? far : near);
    const int i = (int)(item & ((1u << params.most_split) - 1));
    const int j = (int)(item >> params.most_split & ((1u << params.most_split) - 1));
    if (i >> level != 0 || j >> level != 0) {
        return;
    }
    const int u_px = pixel % params.width_px;
    const int v_px = pixel / params.width_px;
    int3 direction;
    if (params.own_directions != 0) {
        direction =
            (int3)(directions[3 * pixel], directions[3 * pixel + 1], directions[3 * pixel + 2]);
    } else {
        direction = pinhole_direction(&params, u_px, v_px);
    }
    if (level > 0) {
        direction += sub_ray_offset((int3)(params.u[0], params.u[1], params.u[2]), i, level) +
                     sub_ray_offset((int3)(params.v[0], params.v[1], params.v[2]), j, level);
    }

    // 2. How much of it passes cells that are free already.
    int skip = 0;
    if (params.tile_level > 0) {
        const int tile_px = 1 << params.tile_level;
        const int columns = (params.width_px + tile_px - 1) / tile_px;
        skip = skips[v_px / tile_px * columns + u_px / tile_px];
    }

    // 3. Free space up to the obstacle, then the obstacle; -1: there is none. Each has its plane:
    // occupied beats free when they are fused.
    const LocalMap map = {local_planes, zone_slots, faults, params.local_map};
    const int3 origin = (int3)(params.origin[0], params.origin[1], params.origin[2]);
    const int3 near_point = point_at(origin, direction, near);
    if (skip == 0 || skip < near) {
        const float share = (float)skip / (float)max(near, 1);
        draw_segment_part(&map, ZG_FREE_PLANE, origin, near_point, share, INT_MAX);
    }
    if (far == near) {
        draw_point(&map, ZG_OCCUPIED_PLANE, near_point);
    } else if (far >= 0) {
        draw_segment(&map, ZG_OCCUPIED_PLANE, near_point, point_at(origin, direction, far));
    }
}
