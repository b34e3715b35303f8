// Walks segments into the bit planes of a local map (docs/model.md, section 4).
// Twin of shaders/parts/draw_segment.glsl: same functions, same order.
#ifndef ZG_DRAW_SEGMENT_CL
#define ZG_DRAW_SEGMENT_CL

#include "kernels/common.cl"
#include "kernels/params/local_map.h"

// Where a local map lies.
typedef struct {
    volatile __global uint* planes; // a zone's slot: free plane, occupied plane
    __global const uint* slots;     // by a zone's place in the window; 0: no zone was reserved
    volatile __global uint* faults; // counts the zones entered that nobody reserved
    LocalMapParams params;
} LocalMap;

// First word of the plane of the zone that holds a cell.
uint plane_of(const LocalMap* map, uint plane, int3 cell) {
    const int3 zone = cell >> map->params.zone_bits;
    const int zones = map->params.zones_per_axis;
    const uint slot = map->slots[(zone.z * zones + zone.y) * zones + zone.x];
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

// Sets bits of a word. Most are set already, by the rays beside this one.
void mark(const LocalMap* map, uint word, uint bits) {
    if ((map->planes[word] & bits) != bits) {
        atomic_or(&map->planes[word], bits);
    }
}

void draw_point(const LocalMap* map, uint plane, int3 point) {
    const int3 cell = point >> ZG_SUB_BITS;
    const uint index = index_in_zone(map, cell);
    mark(map, plane_of(map, plane, cell) + index / 32, 1u << (index % 32));
}

void draw_segment(const LocalMap* map, uint plane, int3 start, int3 end) {
    // 1. Where it starts, how far each axis goes, and how many borders it crosses.
    const int3 way = end - start;
    const int3 distance = max(way, -way);
    const int3 sign = select((int3)(1), (int3)(-1), way < 0);
    int3 cell = start >> ZG_SUB_BITS;
    const int3 cells = (end >> ZG_SUB_BITS) - cell;
    const int3 crossings = max(cells, -cells);
    int left = crossings.x + crossings.y + crossings.z;

    // 2. The crossing that comes first: borders are counted in half sub-cells.
    const int cell_width = 2 * ZG_SUB_PER_CELL;
    const int3 within = start & (ZG_SUB_PER_CELL - 1);
    const int3 to_border = select(2 * within + 1, cell_width - 1 - 2 * within, way > 0);
    int e_xy = to_border.x * distance.y - to_border.y * distance.x;
    int e_xz = to_border.x * distance.z - to_border.z * distance.x;
    int e_yz = to_border.y * distance.z - to_border.z * distance.y;
    const int3 step = cell_width * distance;

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

#endif
