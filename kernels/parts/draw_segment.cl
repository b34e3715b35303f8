// Walks segments into the bit planes of a local map (docs/model.md, section 4).
// Twin of shaders/parts/draw_segment.glsl: same functions, same order.
#ifndef ZG_DRAW_SEGMENT_CL
#define ZG_DRAW_SEGMENT_CL

#include "kernels/common.cl"
#include "kernels/params/local_map.h"

// Half sub-cells from border to border.
#define CELL_WIDTH (2 * ZG_SUB_PER_CELL)

// Where a local map lies.
typedef struct {
    volatile __global uint* planes; // a zone's slot: free plane, occupied plane
    __global const uint* slots;     // by a zone's place in the window; 0: no zone was reserved
    volatile __global uint* faults; // counts the zones entered that nobody reserved
    LocalMapParams params;
} LocalMap;

// Slot of the zone that holds a cell; 0: no zone was reserved.
uint slot_of(const LocalMap* map, int3 cell) {
    const int3 zone = cell >> map->params.zone_bits;
    const int zones = map->params.zones_per_axis;
    return map->slots[(zone.z * zones + zone.y) * zones + zone.x];
}

// First word of the plane of the zone that holds a cell.
uint plane_of(const LocalMap* map, uint plane, int3 cell) {
    const uint slot = slot_of(map, cell);
    if (slot == 0) {
        atomic_inc(map->faults);
    }
    return (2 * slot + plane) * map->params.plane_words;
}

// Place of a cell in its zone.
uint index_in_zone(const LocalMap* map, int3 cell) {
    const int bits = map->params.zone_bits;
    const int3 within = cell & ((1 << bits) - 1);
    return (uint)(((within.z << bits | within.y) << bits) | within.x);
}

// Sets bits of a word. Most are set already, by the rays beside this one. The read may miss bits
// that others set meanwhile, which are then set once more. OpenCL 1.2 reads atomically only by
// writing, which is slow; ZG_ATOMIC_READS is for programs that look for races, so that they see
// others.
void mark(const LocalMap* map, uint word, uint bits) {
#ifdef ZG_ATOMIC_READS
    const uint marked = atomic_or(&map->planes[word], 0);
#else
    const uint marked = map->planes[word];
#endif
    if ((marked & bits) != bits) {
        atomic_or(&map->planes[word], bits);
    }
}

void draw_point(const LocalMap* map, uint plane, int3 point) {
    const int3 cell = point >> ZG_SUB_BITS;
    const uint index = index_in_zone(map, cell);
    mark(map, plane_of(map, plane, cell) + index / 32, 1u << (index % 32));
}

// a b - c d of products that may leave 32 bits, where the difference does not.
int product_difference(int a, int b, int c, int d) {
    return as_int(as_uint(a) * as_uint(b) - as_uint(c) * as_uint(d));
}

// How many crossings on one axis come no later than `time` (half sub-cells) on the longest axis.
// The float may be wrong by one: the exact test after it decides.
int crossings_until(int time, int longest, int to_border, int distance) {
    const float there = (float)time * ((float)distance / (float)longest);
    const int taken = max((int)floor((there - (float)to_border) / (float)CELL_WIDTH) + 1, 0);
    const int e = product_difference(time, distance, to_border + CELL_WIDTH * taken, longest);
    if (e >= 0) {
        return taken + 1;
    }
    return taken > 0 && e + CELL_WIDTH * longest < 0 ? taken - 1 : taken;
}

// Crossings on each axis up to one on the longest axis, near the end of the first `share` of a
// segment but surely within it. What ties with that one counts too: all cells around it are free.
int3 crossings_within(float share, int3 distance, int3 to_border) {
    const int longest = max(distance.x, max(distance.y, distance.z));
    const int first = distance.z == longest   ? to_border.z
                      : distance.y == longest ? to_border.y
                                              : to_border.x;
    // Two half sub-cells are more than the product is wrong by.
    const float reach = share * (float)(2 * longest) - 2.0f;
    const int taken = (int)floor((reach - (float)first) / (float)CELL_WIDTH) + 1;
    if (taken <= 0) {
        return (int3)(0);
    }
    const int time = first + CELL_WIDTH * (taken - 1);
    return (int3)(crossings_until(time, longest, to_border.x, distance.x),
                  crossings_until(time, longest, to_border.y, distance.y),
                  crossings_until(time, longest, to_border.z, distance.z));
}

// Draws the cells of a segment but for some of those within its first `share`; at most `most` and
// one.
void draw_segment_part(const LocalMap* map, uint plane, int3 start, int3 end, float share,
                       int most) {
    // 1. How far each axis goes, where its next border is, and how many it crosses.
    const int3 way = end - start;
    const int3 distance = max(way, -way);
    const int3 sign = select((int3)(1), (int3)(-1), way < 0);
    const int3 within = start & (ZG_SUB_PER_CELL - 1);
    const int3 to_border = select(2 * within + 1, CELL_WIDTH - 1 - 2 * within, way > 0);
    const int3 cells = (end >> ZG_SUB_BITS) - (start >> ZG_SUB_BITS);
    const int3 crossings = max(cells, -cells);
    int3 taken = (int3)(0);
    if (share > 0.0f) {
        taken = crossings_within(share, distance, to_border);
    }
    int left = crossings.x + crossings.y + crossings.z - (taken.x + taken.y + taken.z);
    left = min(left, most);

    // 2. The crossing that comes first.
    const int3 pending = to_border + CELL_WIDTH * taken;
    int e_xy = product_difference(pending.x, distance.y, pending.y, distance.x);
    int e_xz = product_difference(pending.x, distance.z, pending.z, distance.x);
    int e_yz = product_difference(pending.y, distance.z, pending.z, distance.y);
    const int3 step = CELL_WIDTH * distance;
    int3 cell = (start >> ZG_SUB_BITS) + sign * taken;

    // 3. From cell to cell. Bits of one word are set at once.
    const int zone_bits = map->params.zone_bits;
    const int zone_mask = (1 << zone_bits) - 1;
    uint first_word = plane_of(map, plane, cell);
    uint index = index_in_zone(map, cell);
    const int3 stride = (int3)(1, 1 << zone_bits, 1 << 2 * zone_bits) * sign;
    uint word = first_word + index / 32;
    uint bits = 1u << (index % 32);
    for (; left > 0; --left) {
        int from;
        int to;
        if (e_xy < 0 && e_xz < 0) {
            e_xy += step.y;
            e_xz += step.z;
            index += (uint)(stride.x);
            from = cell.x;
            cell.x += sign.x;
            to = cell.x;
        } else if (e_yz < 0) {
            e_xy -= step.x;
            e_yz += step.z;
            index += (uint)(stride.y);
            from = cell.y;
            cell.y += sign.y;
            to = cell.y;
        } else {
            e_xz -= step.x;
            e_yz -= step.y;
            index += (uint)(stride.z);
            from = cell.z;
            cell.z += sign.z;
            to = cell.z;
        }
        if (((from ^ to) & ~zone_mask) != 0) {
            first_word = plane_of(map, plane, cell);
            index = index_in_zone(map, cell);
        }
        const uint next_word = first_word + index / 32;
        if (next_word != word) {
            mark(map, word, bits);
            word = next_word;
            bits = 0;
        }
        bits |= 1u << (index % 32);
    }
    mark(map, word, bits);
}

void draw_segment(const LocalMap* map, uint plane, int3 start, int3 end) {
    draw_segment_part(map, plane, start, end, 0.0f, INT_MAX);
}

#endif
