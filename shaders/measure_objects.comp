#version 450
#extension GL_GOOGLE_include_directive : require
// Count, box, sums and least cell of each piece of labelled zones (docs/model.md, section 8.3).
// Twin of kernels/measure_objects.cl.
#include "kernels/params/zone_pieces.h"
#include "shaders/common.glsl"

layout(std430, binding = 0) readonly buffer Numbers {
    uint numbers[]; // a labelled zone, a cell: its piece from 1 on, or 0
};
layout(std430, binding = 1) readonly buffer FirstPieces {
    uint first_pieces[]; // a labelled zone: its first piece's place below
};
layout(std430, binding = 2) buffer Measures {
    uint measures[]; // a piece: ZG_MEASURE_WORDS, 0 before
};
layout(push_constant) uniform Arguments {
    ZonePiecesParams params;
};

void main() {
    // 1. A work-group takes a zone, an item a row of cells at a time.
    const uint zone = group_index();
    if (zone >= params.items) {
        return;
    }
    const uint zone_bits = uint(params.zone_bits);
    const uint last = (1u << zone_bits) - 1;
    const uint rows = 1u << (2 * zone_bits);
    for (uint row = item_in_group(); row < rows; row += group_items()) {
        const uint y = row & last;
        const uint z = row >> zone_bits;
        const uint first = (rows * zone + row) << zone_bits;

        // 2. Run by run of cells of one piece.
        uint x = 0;
        while (x <= last) {
            const uint number = numbers[first + x];
            const uint x_first = x;
            while (x <= last && numbers[first + x] == number) {
                ++x;
            }
            if (number == 0) {
                continue;
            }
            const uint cells = x - x_first;
            const uint piece = ZG_MEASURE_WORDS * (first_pieces[zone] + number - 1);
            atomicAdd(measures[piece + 0], cells);
            atomicMax(measures[piece + 1], last - x_first);
            atomicMax(measures[piece + 2], last - y);
            atomicMax(measures[piece + 3], last - z);
            atomicMax(measures[piece + 4], x - 1);
            atomicMax(measures[piece + 5], y);
            atomicMax(measures[piece + 6], z);
            atomicAdd(measures[piece + 7], cells * (x_first + x - 1) / 2);
            atomicAdd(measures[piece + 8], cells * y);
            atomicAdd(measures[piece + 9], cells * z);
            atomicMax(measures[piece + 10], ~(((x_first << zone_bits | y) << zone_bits) | z));
        }
    }
}
