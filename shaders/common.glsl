// What every shader may use. Twin of kernels/common.cl: same functions, same order.
#ifndef ZG_COMMON_GLSL
#define ZG_COMMON_GLSL

#include "host/model/constants.h"

layout(local_size_x_id = 0) in;

// Which work-group this is. May be past the last one that was asked for: a long row of groups is
// folded, since devices need not take more than 65535 on an axis.
uint group_index() {
    return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
}

// Which item of its work-group this is, and how many there are.
uint item_in_group() {
    return gl_LocalInvocationID.x;
}

uint group_items() {
    return gl_WorkGroupSize.x;
}

uint count_bits(uint word) {
    return uint(bitCount(word));
}

// Place of the lowest and of the highest bit of a word that is not 0.
uint lowest_bit(uint word) {
    return uint(findLSB(word));
}

uint highest_bit(uint word) {
    return uint(findMSB(word));
}

// a * b / 2^shift, rounded towards minus infinity, of the whole product; shift 1 .. 31.
int shifted_product(int a, int b, uint shift) {
    int high;
    int low;
    imulExtended(a, b, high, low);
    return int(uint(high) << (32 - shift) | uint(low) >> shift);
}

// A grid's word holds four cells, the first in the lowest byte. Value of the cell at place 0 .. 3.
int unpack_cell(uint word, uint place) {
    return int(word << (24 - 8 * place)) >> 24;
}

// Inverse of unpack_cell: the cell's share of the word.
uint pack_cell(int value, uint place) {
    return (uint(value) & 255u) << (8 * place);
}

#endif
