#version 450
#extension GL_GOOGLE_include_directive : require
// Draws remembered cells back into empty zones of the grid (docs/model.md, section 6).
// Twin of kernels/draw_objects.cl.
#include "kernels/params/draw_objects.h"
#include "shaders/common.glsl"

layout(std430, binding = 0) buffer GridCells {
    uint grid_cells[]; // a zone: 4 cells a word
};
layout(std430, binding = 1) buffer OccupiedPlanes {
    uint occupied_planes[]; // a zone: value >= threshold
};
layout(std430, binding = 2) readonly buffer Cells {
    uint cells[]; // places in the buffer: slot * cells of a zone + index
};
layout(push_constant) uniform Arguments {
    DrawObjectsParams params;
};

void main() {
    // An item takes one cell; its value was 0.
    const uint item = group_index() * group_items() + item_in_group();
    if (item >= params.cells) {
        return;
    }
    const uint cell = cells[item];
    atomicOr(grid_cells[cell / 4], pack_cell(params.value, cell % 4));
    atomicOr(occupied_planes[cell / 32], 1u << (cell % 32));
}
