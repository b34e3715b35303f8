// Quadtree of the ground plan of each piece within its zone (docs/model.md, section 8.5): the zone
// is the root. Twin of shaders/encode_prism.comp.
#include "kernels/common.cl"
#include "kernels/params/zone_pieces.h"

// Words that hold the nodes of all levels of the largest zone, four a word. Level l is 2^l cells
// wide.
#define NODE_WORDS 86

// Where a level's nodes start, and the place of one among them.
uint node_place(uint zone_bits, uint level, uint x, uint y) {
    uint first = 0;
    for (uint l = 1; l < level; ++l) {
        first += 1u << (2 * (zone_bits - l));
    }
    const uint bits = zone_bits - level;
    return first + (y << bits | x);
}

// The byte of a node that has been worked out.
uint read_node(__local const uint* nodes_here, uint place) {
    return nodes_here[place / 4] >> (8 * (place % 4)) & 0xff;
}

// 0: the ground plan has none of a child's columns, 1: all, 2: some. Level 0 are columns.
uint child_state(__local const uint* plan, __local const uint* nodes_here, uint zone_bits,
                 uint level, uint x, uint y) {
    if (level == 0) {
        return plan[y] >> x & 1;
    }
    const uint node = read_node(nodes_here, node_place(zone_bits, level, x, y));
    return node == 0 ? 0 : node == 0x55 ? 1 : 2;
}

__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void encode_prism(
    __global const uint* numbers,  // a labelled zone, a cell: its piece from 1 on, or 0
    __global const uint* pieces,   // a piece: labelled zone, number
    __global const uint* measures, // a piece: as measure_objects leaves them
    volatile __global uint* used,  // words of `nodes` taken so far, 0 before
    __global uint* trees,          // a piece: first word in `nodes`, how many nodes
    __global uint* nodes,          // four nodes a word
    const struct ZonePiecesParams params) {
    __local uint plan[32]; // a row of columns a word
    __local uint nodes_here[NODE_WORDS];
    __local uint node_count;

    // 1. A work-group takes a piece, and draws its ground plan.
    const uint piece = group_index();
    if (piece >= params.items) {
        return;
    }
    const uint item = item_in_group();
    const uint zone_bits = (uint)params.zone_bits;
    const uint last = (1u << zone_bits) - 1;
    const uint zone_first = pieces[2 * piece] << (3 * zone_bits);
    const uint number = pieces[2 * piece + 1];
    __global const uint* const measure = measures + ZG_MEASURE_WORDS * piece;
    for (uint word = item; word < 32; word += group_items()) {
        plan[word] = 0;
    }
    for (uint word = item; word < NODE_WORDS; word += group_items()) {
        nodes_here[word] = 0;
    }
    if (item == 0) {
        node_count = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    const uint x_first = last - measure[1];
    const uint y_first = last - measure[2];
    const uint z_first = last - measure[3];
    const uint rows = measure[5] - y_first + 1;
    const uint box_rows = rows * (measure[6] - z_first + 1);
    for (uint row = item; row < box_rows; row += group_items()) {
        const uint y = y_first + row % rows;
        const uint place = ((z_first + row / rows) << zone_bits | y) << zone_bits;
        uint bits = 0;
        for (uint x = x_first; x <= measure[4]; ++x) {
            bits |= (numbers[zone_first + place + x] == number ? 1u : 0u) << x;
        }
        atomic_or(&plan[y], bits);
    }
    barrier(CLK_LOCAL_MEM_FENCE);

    // 2. Nodes level by level up to the root, those in the plan's box.
    for (uint level = 1; level <= zone_bits; ++level) {
        const uint x_0 = x_first >> level;
        const uint y_0 = y_first >> level;
        const uint width = (measure[4] >> level) - x_0 + 1;
        const uint count = width * ((measure[5] >> level) - y_0 + 1);
        for (uint node = item; node < count; node += group_items()) {
            const uint x = x_0 + node % width;
            const uint y = y_0 + node / width;
            uint byte = 0;
            for (uint child = 0; child < 4; ++child) {
                byte |= child_state(plan, nodes_here, zone_bits, level - 1, 2 * x + (child & 1),
                                    2 * y + (child >> 1))
                        << (2 * child);
            }
            const uint place = node_place(zone_bits, level, x, y);
            atomic_or(&nodes_here[place / 4], byte << (8 * (place % 4)));
            if (level == zone_bits || (byte != 0 && byte != 0x55)) {
                atomic_add(&node_count, 1);
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }

    // 3. One item writes them, depth first: the root, and all that hold some of the plan.
    if (item != 0) {
        return;
    }
    const uint first_word = atomic_add(used, (node_count + 3) / 4);
    trees[2 * piece] = first_word;
    trees[2 * piece + 1] = node_count;
    uint written = 0;
    uint word = 0;
    uint open[6]; // a level's children that hold some and come next, at their bits in the node
    uint level = zone_bits;
    uint x = 0;
    uint y = 0;
    bool entered = true;
    while (level <= zone_bits) {
        if (entered) {
            const uint node = read_node(nodes_here, node_place(zone_bits, level, x, y));
            open[level] = node >> 1 & 0x55;
            word |= node << (8 * (written % 4));
            ++written;
            if (written % 4 == 0 || written == node_count) {
                nodes[first_word + (written - 1) / 4] = word;
                word = 0;
            }
        }
        entered = open[level] != 0;
        if (entered) {
            const uint child = lowest_bit(open[level]) / 2;
            open[level] &= open[level] - 1;
            --level;
            x = 2 * x + (child & 1);
            y = 2 * y + (child >> 1);
        } else {
            ++level;
            x >>= 1;
            y >>= 1;
        }
    }
}
