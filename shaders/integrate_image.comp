#version 450
#extension GL_GOOGLE_include_directive : require
// Draws a depth image into a local map, every ray walked alone (docs/model.md, section 5).
// Twin of kernels/integrate_image.cl.
#include "kernels/params/integrate_image.h"

layout(std430, binding = 3) readonly buffer Depths {
    int depths[]; // a pixel: near, far
};
layout(std430, binding = 4) readonly buffer Directions {
    int directions[]; // a pixel: x, y, z
};
layout(push_constant) uniform Arguments {
    IntegrateImageParams params;
};

#include "shaders/parts/draw_segment.glsl"

// Displacement of sub-ray `i` of 2^level from its pixel's centre on one image axis.
ivec3 sub_ray_offset(ivec3 per_pixel, int i, int level) {
    const int m = 2 * i + 1 - (1 << level);
    const uint shift = uint(level + 1);
    return ivec3(shifted_product(per_pixel.x, m, shift), shifted_product(per_pixel.y, m, shift),
                 shifted_product(per_pixel.z, m, shift));
}

// The point at `depth` along `direction`.
ivec3 point_at(ivec3 origin, ivec3 direction, int depth) {
    return origin + ivec3(shifted_product(direction.x, depth, ZG_DIRECTION_BITS),
                          shifted_product(direction.y, depth, ZG_DIRECTION_BITS),
                          shifted_product(direction.z, depth, ZG_DIRECTION_BITS));
}

void main() {
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
    const ivec3 origin = ivec3(params.origin[0], params.origin[1], params.origin[2]);
    const ivec3 u = ivec3(params.u[0], params.u[1], params.u[2]);
    const ivec3 v = ivec3(params.v[0], params.v[1], params.v[2]);
    ivec3 centre;
    if (params.own_directions != 0) {
        centre = ivec3(directions[3 * pixel], directions[3 * pixel + 1], directions[3 * pixel + 2]);
    } else {
        const int u_px = int(pixel) % params.width_px;
        const int v_px = int(pixel) / params.width_px;
        centre = ivec3(params.a[0], params.a[1], params.a[2]) + u_px * u + v_px * v;
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
            ivec3 direction = centre;
            if (level > 0) {
                direction += sub_ray_offset(u, i, level) + sub_ray_offset(v, j, level);
            }
            const ivec3 near_point = point_at(origin, direction, near);
            draw_segment(ZG_FREE_PLANE, origin, near_point);
            if (far == near) {
                draw_point(ZG_OCCUPIED_PLANE, near_point);
            } else if (far >= 0) {
                draw_segment(ZG_OCCUPIED_PLANE, near_point, point_at(origin, direction, far));
            }
        }
    }
}
