// Draws remembered cells back into empty zones of the grid (docs/model.md, section 6).
// Twin of shaders/draw_objects.comp.
#include "kernels/common.cl"
#include "kernels/params/draw_objects.h"

__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void draw_objects(
    volatile __global uint* grid_cells,      // a zone: 4 cells a word
    volatile __global uint* occupied_planes, // a zone: value >= threshold
    __global const uint* cells,              // places in the buffer: slot * cells of a zone + index
    const struct DrawObjectsParams params) {
    // An item takes one cell; its value was 0.
    const uint item = group_index() * group_items() + item_in_group();
    if (item >= params.cells) {
        return;
    }
    const uint cell = cells[item];
    atomic_or(&grid_cells[cell / 4], pack_cell(params.value, cell % 4));
    atomic_or(&occupied_planes[cell / 32], 1u << (cell % 32));
}
