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

// Half sub-cells from border to border.
#define CELL_WIDTH (2 * ZG_SUB_PER_CELL)

// Slot of the zone that holds a cell; 0: no zone was reserved.
uint slot_of(ivec3 cell) {
    const ivec3 zone = cell >> params.local_map.zone_bits;
    const int zones = params.local_map.zones_per_axis;
    return zone_slots[(zone.z * zones + zone.y) * zones + zone.x];
}

// First word of the plane of the zone that holds a cell.
uint plane_of(uint plane, ivec3 cell) {
    const uint slot = slot_of(cell);
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

// Sets bits of a word. Most are set already, by the rays beside this one. The read may miss bits
// that others set meanwhile, which are then set once more.
void mark(uint word, uint bits) {
    const uint marked = local_planes[word];
    if ((marked & bits) != bits) {
        atomicOr(local_planes[word], bits);
    }
}

void draw_point(uint plane, ivec3 point) {
    const ivec3 cell = point >> ZG_SUB_BITS;
    const uint index = index_in_zone(cell);
    mark(plane_of(plane, cell) + index / 32, 1u << (index % 32));
}

// a b - c d of products that may leave 32 bits, where the difference does not.
int product_difference(int a, int b, int c, int d) {
    return int(uint(a) * uint(b) - uint(c) * uint(d));
}

// How many crossings on one axis come no later than `time` (half sub-cells) on the longest axis.
// The float may be wrong by one: the exact test after it decides.
int crossings_until(int time, int longest, int to_border, int distance) {
    const float there = float(time) * (float(distance) / float(longest));
    const int taken = max(int(floor((there - float(to_border)) / float(CELL_WIDTH))) + 1, 0);
    const int e = product_difference(time, distance, to_border + CELL_WIDTH * taken, longest);
    if (e >= 0) {
        return taken + 1;
    }
    return taken > 0 && e + CELL_WIDTH * longest < 0 ? taken - 1 : taken;
}

// Crossings on each axis up to one on the longest axis, near the end of the first `share` of a
// segment but surely within it. What ties with that one counts too: all cells around it are free.
ivec3 crossings_within(float share, ivec3 distance, ivec3 to_border) {
    const int longest = max(distance.x, max(distance.y, distance.z));
    const int first = distance.z == longest   ? to_border.z
                      : distance.y == longest ? to_border.y
                                              : to_border.x;
    // Two half sub-cells are more than the product is wrong by.
    const float reach = share * float(2 * longest) - 2.0f;
    const int taken = int(floor((reach - float(first)) / float(CELL_WIDTH))) + 1;
    if (taken <= 0) {
        return ivec3(0);
    }
    const int time = first + CELL_WIDTH * (taken - 1);
    return ivec3(crossings_until(time, longest, to_border.x, distance.x),
                 crossings_until(time, longest, to_border.y, distance.y),
                 crossings_until(time, longest, to_border.z, distance.z));
}

// Draws the cells of a segment but for some of those within its first `share`; at most `most` and
// one.
void draw_segment_part(uint plane, ivec3 start, ivec3 end, float share, int most) {
    // 1. How far each axis goes, where its next border is, and how many it crosses.
    const ivec3 way = end - start;
    const ivec3 distance = max(way, -way);
    const ivec3 sign = mix(ivec3(1), ivec3(-1), lessThan(way, ivec3(0)));
    const ivec3 within = start & (ZG_SUB_PER_CELL - 1);
    const ivec3 to_border =
        mix(2 * within + 1, CELL_WIDTH - 1 - 2 * within, greaterThan(way, ivec3(0)));
    const ivec3 cells = (end >> ZG_SUB_BITS) - (start >> ZG_SUB_BITS);
    const ivec3 crossings = max(cells, -cells);
    ivec3 taken = ivec3(0);
    if (share > 0.0f) {
        taken = crossings_within(share, distance, to_border);
    }
    int left = crossings.x + crossings.y + crossings.z - (taken.x + taken.y + taken.z);
    left = min(left, most);

    // 2. The crossing that comes first.
    const ivec3 pending = to_border + CELL_WIDTH * taken;
    int e_xy = product_difference(pending.x, distance.y, pending.y, distance.x);
    int e_xz = product_difference(pending.x, distance.z, pending.z, distance.x);
    int e_yz = product_difference(pending.y, distance.z, pending.z, distance.y);
    const ivec3 step = CELL_WIDTH * distance;
    ivec3 cell = (start >> ZG_SUB_BITS) + sign * taken;

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

void draw_segment(uint plane, ivec3 start, ivec3 end) {
    draw_segment_part(plane, start, end, 0.0f, 0x7fffffff);
}

#endif
