// Numbers the pieces of zones: components of the occupied cells of each zone alone (docs/model.md,
// section 8.2). Joins neighbours by union-find without locks, as in Jaiganesh and Burtscher, "A
// High-Performance Connected Components Implementation for GPUs", HPDC 2018.
// Twin of shaders/label_components.comp.
#include "kernels/common.cl"
#include "kernels/params/zone_pieces.h"

// Of a cell that is not occupied.
#define NO_PARENT 0xffffffffu

// The root of a cell's tree; parents are always less than their children. Shortens the way for
// those who come after. Other items may be joining trees: an atomic that changes nothing reads what
// they wrote.
uint root_of(volatile __global uint* parents, uint first, uint cell) {
    uint parent = atomic_min(&parents[first + cell], NO_PARENT);
    while (parent != cell) {
        const uint next = atomic_min(&parents[first + parent], NO_PARENT);
        atomic_min(&parents[first + cell], next);
        cell = parent;
        parent = next;
    }
    return cell;
}

// Makes one tree of two.
void join(volatile __global uint* parents, uint first, uint cell_0, uint cell_1) {
    uint a = root_of(parents, first, cell_0);
    uint b = root_of(parents, first, cell_1);
    while (a != b) {
        const uint lesser = min(a, b);
        const uint greater = max(a, b);
        // If it has found another parent meanwhile, that one is joined too.
        const uint parent = atomic_min(&parents[first + greater], lesser);
        if (parent == greater) {
            return;
        }
        a = lesser;
        b = parent;
    }
}

// Joins each run of set bits, `both` of a word and its neighbour `stride` cells before, once.
void join_runs(volatile __global uint* parents, uint first, uint word, uint both, uint row_starts,
               uint stride) {
    for (uint starts = both & (~(both << 1) | row_starts); starts != 0; starts &= starts - 1) {
        const uint cell = 32 * word + lowest_bit(starts);
        join(parents, first, cell, cell - stride);
    }
}

__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void label_components(
    __global const uint* occupied_planes, // a zone's slot: its occupied cells
    __global const uint* slots,           // of the zones to label
    volatile __global uint* parents,      // a labelled zone, a cell: another of its piece
    __global uint* numbers,               // a labelled zone, a cell: its piece from 1 on, or 0
    __global uint* layers,                // a labelled zone: numbers in its outer layers
    __global uint* counts,                // a labelled zone: pieces, occupied cells
    const struct ZonePiecesParams params) {
    __local uint roots_of_item[ZG_GROUP_ITEMS];
    __local uint cells_of_item[ZG_GROUP_ITEMS];

    // 1. A work-group takes a zone.
    const uint zone = group_index();
    if (zone >= params.items) {
        return;
    }
    const uint item = item_in_group();
    const uint zone_bits = (uint)params.zone_bits;
    const uint edge = 1u << zone_bits;
    const uint layer_cells = edge << zone_bits;
    const uint words = (layer_cells << zone_bits) / 32;
    const uint first = 32 * words * zone;
    const uint plane = slots[zone] * words;
    const uint row_starts = edge == 32 ? 1u : edge == 16 ? 0x00010001u : 0x01010101u;

    // 2. Runs along x: all cells of a run have its first one as parent.
    for (uint word = item; word < words; word += group_items()) {
        const uint bits = occupied_planes[plane + word];
        const uint starts = bits & (~(bits << 1) | row_starts);
        for (uint i = 0; i < 32; ++i) {
            const uint up_to_here = starts & (~0u >> (31 - i));
            parents[first + 32 * word + i] =
                (bits >> i & 1) != 0 ? 32 * word + highest_bit(up_to_here) : NO_PARENT;
        }
    }
    barrier(CLK_GLOBAL_MEM_FENCE);

    // 3. Neighbours along y and z. A word holds whole rows. All items go round the same number of
    // times: PoCL 3.1 leaves out a loop between barriers that has loops in it and that some items
    // never enter.
    for (uint base = 0; base < words; base += group_items()) {
        const uint word = min(base + item, words - 1);
        const uint bits = base + item < words ? occupied_planes[plane + word] : 0;
        const uint y = 32 * word >> zone_bits & (edge - 1); // of the word's first row
        uint beside_y = edge < 32 ? bits << (edge & 31) : 0;
        if (y > 0) {
            beside_y |= occupied_planes[plane + word - 1] >> (32 - edge);
        }
        join_runs(parents, first, word, bits & beside_y, row_starts, edge);
        if (word >= layer_cells / 32) {
            const uint beside_z = occupied_planes[plane + word - layer_cells / 32];
            join_runs(parents, first, word, bits & beside_z, row_starts, layer_cells);
        }
    }
    barrier(CLK_GLOBAL_MEM_FENCE);

    // 4. All cells become children of their roots.
    for (uint base = 0; base < 32 * words; base += group_items()) {
        const uint cell = min(base + item, 32 * words - 1);
        if (atomic_min(&parents[first + cell], NO_PARENT) != NO_PARENT) {
            const uint root = root_of(parents, first, cell);
            atomic_min(&parents[first + cell], root);
        }
    }
    barrier(CLK_GLOBAL_MEM_FENCE);

    // 5. Each item counts the roots in its share of the words, and those of all items before it.
    const uint share = (words + group_items() - 1) / group_items();
    const uint share_first = min(item * share, words);
    const uint share_end = min(share_first + share, words);
    uint roots = 0;
    uint cells = 0;
    for (uint cell = 32 * share_first; cell < 32 * share_end; ++cell) {
        const uint parent = parents[first + cell];
        roots += parent == cell ? 1 : 0;
        cells += parent != NO_PARENT ? 1 : 0;
    }
    roots_of_item[item] = roots;
    cells_of_item[item] = cells;
    barrier(CLK_LOCAL_MEM_FENCE);
    uint number = 0;
    for (uint i = 0; i < item; ++i) {
        number += roots_of_item[i];
    }
    if (item == 0) {
        uint all_roots = 0;
        uint all_cells = 0;
        for (uint i = 0; i < group_items(); ++i) {
            all_roots += roots_of_item[i];
            all_cells += cells_of_item[i];
        }
        counts[2 * zone] = all_roots;
        counts[2 * zone + 1] = all_cells;
    }

    // 6. Roots are numbered in their order, and all cells after their roots.
    for (uint cell = 32 * share_first; cell < 32 * share_end; ++cell) {
        if (parents[first + cell] == cell) {
            number += 1;
            numbers[first + cell] = number;
        }
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (uint cell = item; cell < 32 * words; cell += group_items()) {
        const uint root = parents[first + cell];
        if (root == NO_PARENT) {
            numbers[first + cell] = 0;
        } else if (root != cell) {
            numbers[first + cell] = numbers[first + root];
        }
    }
    barrier(CLK_GLOBAL_MEM_FENCE);

    // 7. The outer layers, two numbers a word: for x, y and z the first layer and the last one,
    // ordered by the two other axes, the lesser first.
    const uint layer_words = layer_cells / 2;
    for (uint word = item; word < 6 * layer_words; word += group_items()) {
        const uint side = word / layer_words;
        const uint axis = side / 2;
        const uint depth = side % 2 != 0 ? edge - 1 : 0;
        uint pair = 0;
        for (uint i = 0; i < 2; ++i) {
            const uint place = 2 * (word % layer_words) + i;
            const uint cell = axis == 0   ? place * edge + depth
                              : axis == 1 ? (place >> zone_bits) * layer_cells + depth * edge +
                                                (place & (edge - 1))
                                          : depth * layer_cells + place;
            pair |= numbers[first + cell] << (16 * i);
        }
        layers[6 * layer_words * zone + word] = pair;
    }
}
