#version 450
#extension GL_GOOGLE_include_directive : require
// Octree of each piece within its zone (docs/model.md, section 8.4): the zone is the root.
// Twin of kernels/encode_octree.cl.
#include "kernels/params/zone_pieces.h"
#include "shaders/common.glsl"

layout(std430, binding = 0) readonly buffer Numbers {
    uint numbers[]; // a labelled zone, a cell: its piece from 1 on, or 0
};
layout(std430, binding = 1) readonly buffer Pieces {
    uint pieces[]; // a piece: labelled zone, number
};
layout(std430, binding = 2) readonly buffer Measures {
    uint measures[]; // a piece: as measure_objects leaves them
};
layout(std430, binding = 3) buffer Used {
    uint used[]; // words of `nodes` taken so far, 0 before
};
layout(std430, binding = 4) writeonly buffer Trees {
    uint trees[]; // a piece: first word in `nodes`, how many nodes
};
layout(std430, binding = 5) writeonly buffer Nodes {
    uint nodes[]; // two nodes a word
};
layout(push_constant) uniform Arguments {
    ZonePiecesParams params;
};

// Words that hold the nodes of all levels of the largest zone, two a word. Level l is 2^l cells
// wide.
#define NODE_WORDS 2341

shared uint cells[1024];
shared uint nodes_here[NODE_WORDS];
shared uint node_count;

// Where a level's nodes start, and the place of one among them.
uint node_place(uint zone_bits, uint level, uint x, uint y, uint z) {
    uint first = 0;
    for (uint l = 1; l < level; ++l) {
        first += 1u << (3 * (zone_bits - l));
    }
    const uint bits = zone_bits - level;
    return first + (((z << bits | y) << bits) | x);
}

// The two bytes of a node that has been worked out.
uint read_node(uint place) {
    return nodes_here[place / 2] >> (16 * (place % 2)) & 0xffff;
}

// 0: the piece has none of a child's cells, 1: all, 2: some. Level 0 are cells.
uint child_state(uint zone_bits, uint level, uint x, uint y, uint z) {
    if (level == 0) {
        const uint place = ((z << zone_bits | y) << zone_bits) | x;
        return cells[place / 32] >> (place % 32) & 1;
    }
    const uint node = read_node(node_place(zone_bits, level, x, y, z));
    return node == 0 ? 0 : node == 0x5555 ? 1 : 2;
}

void main() {
    // 1. A work-group takes a piece, and copies its bits.
    const uint piece = group_index();
    if (piece >= params.items) {
        return;
    }
    const uint item = item_in_group();
    const uint zone_bits = uint(params.zone_bits);
    const uint last = (1u << zone_bits) - 1;
    const uint words = (1u << (3 * zone_bits)) / 32;
    const uint zone_first = pieces[2 * piece] << (3 * zone_bits);
    const uint number = pieces[2 * piece + 1];
    const uint measure = ZG_MEASURE_WORDS * piece;
    for (uint word = item; word < words; word += group_items()) {
        cells[word] = 0;
    }
    for (uint word = item; word < NODE_WORDS; word += group_items()) {
        nodes_here[word] = 0;
    }
    if (item == 0) {
        node_count = 0;
    }
    barrier();
    const uint x_first = last - measures[measure + 1];
    const uint y_first = last - measures[measure + 2];
    const uint z_first = last - measures[measure + 3];
    const uint rows = measures[measure + 5] - y_first + 1;
    const uint box_rows = rows * (measures[measure + 6] - z_first + 1);
    for (uint row = item; row < box_rows; row += group_items()) {
        const uint place = ((z_first + row / rows) << zone_bits | (y_first + row % rows))
                           << zone_bits;
        uint bits = 0;
        for (uint x = x_first; x <= measures[measure + 4]; ++x) {
            bits |= (numbers[zone_first + place + x] == number ? 1u : 0u) << x;
        }
        atomicOr(cells[place / 32], bits << (place % 32));
    }
    barrier();

    // 2. Nodes level by level up to the root, those in the piece's box.
    for (uint level = 1; level <= zone_bits; ++level) {
        const uint x_0 = x_first >> level;
        const uint y_0 = y_first >> level;
        const uint z_0 = z_first >> level;
        const uint width = (measures[measure + 4] >> level) - x_0 + 1;
        const uint height = (measures[measure + 5] >> level) - y_0 + 1;
        const uint count = width * height * ((measures[measure + 6] >> level) - z_0 + 1);
        for (uint node = item; node < count; node += group_items()) {
            const uint x = x_0 + node % width;
            const uint y = y_0 + node / width % height;
            const uint z = z_0 + node / (width * height);
            uint bytes = 0;
            for (uint child = 0; child < 8; ++child) {
                bytes |= child_state(zone_bits, level - 1, 2 * x + (child & 1),
                                     2 * y + (child >> 1 & 1), 2 * z + (child >> 2))
                         << (2 * child);
            }
            const uint place = node_place(zone_bits, level, x, y, z);
            atomicOr(nodes_here[place / 2], bytes << (16 * (place % 2)));
            if (level == zone_bits || (bytes != 0 && bytes != 0x5555)) {
                atomicAdd(node_count, 1);
            }
        }
        barrier();
    }

    // 3. One item writes them, depth first: the root, and all that hold some of the piece.
    if (item != 0) {
        return;
    }
    const uint first_word = atomicAdd(used[0], (node_count + 1) / 2);
    trees[2 * piece] = first_word;
    trees[2 * piece + 1] = node_count;
    uint written = 0;
    uint word = 0;
    uint open[6]; // a level's children that hold some and come next, at their bits in the node
    uint level = zone_bits;
    uint x = 0;
    uint y = 0;
    uint z = 0;
    bool entered = true;
    while (level <= zone_bits) {
        if (entered) {
            const uint node = read_node(node_place(zone_bits, level, x, y, z));
            open[level] = node >> 1 & 0x5555;
            word |= node << (16 * (written % 2));
            ++written;
            if (written % 2 == 0 || written == node_count) {
                nodes[first_word + (written - 1) / 2] = word;
                word = 0;
            }
        }
        entered = open[level] != 0;
        if (entered) {
            const uint child = lowest_bit(open[level]) / 2;
            open[level] &= open[level] - 1;
            --level;
            x = 2 * x + (child & 1);
            y = 2 * y + (child >> 1 & 1);
            z = 2 * z + (child >> 2);
        } else {
            ++level;
            x >>= 1;
            y >>= 1;
            z >>= 1;
        }
    }
}
