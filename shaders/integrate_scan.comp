#version 450
#extension GL_GOOGLE_include_directive : require
// Draws a scan into a local map, every ray walked alone (docs/model.md, section 5).
// Twin of kernels/integrate_scan.cl.
#include "kernels/params/integrate_scan.h"

layout(std430, binding = 3) readonly buffer Rays {
    int rays[]; // a ray: start, end, 1 if an obstacle is at the end
};
layout(push_constant) uniform Arguments {
    IntegrateScanParams params;
};

#include "shaders/parts/draw_segment.glsl"

void main() {
    // An item takes one ray.
    const uint ray = group_index() * group_items() + item_in_group();
    if (ray >= params.rays) {
        return;
    }
    const uint first = 7 * ray;
    const ivec3 start = ivec3(rays[first], rays[first + 1], rays[first + 2]);
    const ivec3 end = ivec3(rays[first + 3], rays[first + 4], rays[first + 5]);
    draw_segment(ZG_FREE_PLANE, start, end);
    if (rays[first + 6] != 0) {
        draw_point(ZG_OCCUPIED_PLANE, end);
    }
}
