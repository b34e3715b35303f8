// Draws a depth image into a local map, every ray walked alone (docs/model.md, section 5).
// Twin of shaders/integrate_image.comp.
#include "kernels/params/integrate_image.h"
#include "kernels/parts/draw_segment.cl"

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

__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void integrate_image(
    volatile __global uint* local_planes, // a zone: free plane, occupied plane
    __global const uint* zone_slots,      // by place in the window
    volatile __global uint* faults,       // zones entered that nobody reserved
    __global const int* depths,           // a pixel: near, far
    __global const int* directions,       // a pixel: x, y, z
    const struct IntegrateImageParams params) {
    // 1. An item takes one pixel. -1: it is missing, or has no obstacle.
    const uint pixel = group_index() * group_items() + item_in_group();
    if (pixel >= params.pixels) {
        return;
    }
    const int near = depths[2 * pixel];
    const int far = depths[2 * pixel + 1];
    if (near < 0) {
        return;
    }
    const LocalMap map = {local_planes, zone_slots, faults, params.local_map};
    const int3 origin = (int3)(params.origin[0], params.origin[1], params.origin[2]);
    const int3 u = (int3)(params.u[0], params.u[1], params.u[2]);
    const int3 v = (int3)(params.v[0], params.v[1], params.v[2]);
    int3 centre;
    if (params.own_directions != 0) {
        centre =
            (int3)(directions[3 * pixel], directions[3 * pixel + 1], directions[3 * pixel + 2]);
    } else {
        const int u_px = (int)pixel % params.width_px;
        const int v_px = (int)pixel / params.width_px;
        centre = (int3)(params.a[0], params.a[1], params.a[2]) + u_px * u + v_px * v;
    }

    // 2. Sub-rays no further apart than a cell.
    const int depth = far >= 0 ? far : near;
    int level = 0;
    while (params.spanned != 0 && level < ZG_MAX_SPLIT_LEVEL && (params.spacing << level) < depth) {
        ++level;
    }

    // 3. Free space up to the obstacle, then the obstacle. Each has its plane: occupied beats free
    // when they are fused.
    for (int j = 0; j < 1 << level; ++j) {
        for (int i = 0; i < 1 << level; ++i) {
            int3 direction = centre;
            if (level > 0) {
                direction += sub_ray_offset(u, i, level) + sub_ray_offset(v, j, level);
            }
            const int3 near_point = point_at(origin, direction, near);
            draw_segment(&map, ZG_FREE_PLANE, origin, near_point);
            if (far == near) {
                draw_point(&map, ZG_OCCUPIED_PLANE, near_point);
            } else if (far >= 0) {
                draw_segment(&map, ZG_OCCUPIED_PLANE, near_point, point_at(origin, direction, far));
            }
        }
    }
}
