// Walks segments into the bit planes of a local map (docs/model.md, section 4).
// Twin of kernels/parts/draw_segment.cl: same functions, same order. What includes it has the push
// constants `params`, with a LocalMapParams `local_map`.
#ifndef ZG_DRAW_SEGMENT_GLSL
#define ZG_DRAW_SEGMENT_GLSL

#include "shaders/common.glsl"

layout(std430, binding = 0) buffer LocalPlanes {
    uint local_planes[]; // a zone's slot: free plane, occupied plane
};
layout(std430, binding = 1) readonly buffer ZoneSlots {
    uint zone_slots[]; // by a zone's place in the window; 0: no zone was reserved
};
layout(std430, binding = 2) buffer Faults {
    uint faults[]; // counts the zones entered that nobody reserved
};

// First word of the plane of the zone that holds a cell.
uint plane_of(uint plane, ivec3 cell) {
    const ivec3 zone = cell >> params.local_map.zone_bits;
    const int zones = params.local_map.zones_per_axis;
    const uint slot = zone_slots[(zone.z * zones + zone.y) * zones + zone.x];
    if (slot == 0) {
        atomicAdd(faults[0], 1);
    }
    return (2 * slot + plane) * params.local_map.plane_words;
}

// Place of a cell in its zone.
uint index_in_zone(ivec3 cell) {
    const int bits = params.local_map.zone_bits;
    const ivec3 within = cell & ((1 << bits) - 1);
    return uint(((within.z << bits | within.y) << bits) | within.x);
}

// Sets bits of a word. Most are set already, by the rays beside this one.
void mark(uint word, uint bits) {
    if ((local_planes[word] & bits) != bits) {
        atomicOr(local_planes[word], bits);
    }
}

void draw_point(uint plane, ivec3 point) {
    const ivec3 cell = point >> ZG_SUB_BITS;
    const uint index = index_in_zone(cell);
    mark(plane_of(plane, cell) + index / 32, 1u << (index % 32));
}

void draw_segment(uint plane, ivec3 start, ivec3 end) {
    // 1. Where it starts, how far each axis goes, and how many borders it crosses.
    const ivec3 way = end - start;
    const ivec3 distance = max(way, -way);
    const ivec3 sign = mix(ivec3(1), ivec3(-1), lessThan(way, ivec3(0)));
    ivec3 cell = start >> ZG_SUB_BITS;
    const ivec3 cells = (end >> ZG_SUB_BITS) - cell;
    const ivec3 crossings = max(cells, -cells);
    int left = crossings.x + crossings.y + crossings.z;

    // 2. The crossing that comes first: borders are counted in half sub-cells.
    const int cell_width = 2 * ZG_SUB_PER_CELL;
    const ivec3 within = start & (ZG_SUB_PER_CELL - 1);
    const ivec3 to_border =
        mix(2 * within + 1, cell_width - 1 - 2 * within, greaterThan(way, ivec3(0)));
    int e_xy = to_border.x * distance.y - to_border.y * distance.x;
    int e_xz = to_border.x * distance.z - to_border.z * distance.x;
    int e_yz = to_border.y * distance.z - to_border.z * distance.y;
    const ivec3 step = cell_width * distance;

    // 3. From cell to cell. Bits of one word are set at once.
    const int zone_bits = params.local_map.zone_bits;
    const int zone_mask = (1 << zone_bits) - 1;
    uint first_word = plane_of(plane, cell);
    uint index = index_in_zone(cell);
    const ivec3 stride = ivec3(1, 1 << zone_bits, 1 << 2 * zone_bits) * sign;
    uint word = first_word + index / 32;
    uint bits = 1u << (index % 32);
    for (; left > 0; --left) {
        int from;
        int to;
        if (e_xy < 0 && e_xz < 0) {
            e_xy += step.y;
            e_xz += step.z;
            index += uint(stride.x);
            from = cell.x;
            cell.x += sign.x;
            to = cell.x;
        } else if (e_yz < 0) {
            e_xy -= step.x;
            e_yz += step.z;
            index += uint(stride.y);
            from = cell.y;
            cell.y += sign.y;
            to = cell.y;
        } else {
            e_xz -= step.x;
            e_yz -= step.y;
            index += uint(stride.z);
            from = cell.z;
            cell.z += sign.z;
            to = cell.z;
        }
        if (((from ^ to) & ~zone_mask) != 0) {
            first_word = plane_of(plane, cell);
            index = index_in_zone(cell);
        }
        const uint next_word = first_word + index / 32;
        if (next_word != word) {
            mark(word, bits);
            word = next_word;
            bits = 0;
        }
        bits |= 1u << (index % 32);
    }
    mark(word, bits);
}

#endif
