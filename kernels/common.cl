// What every kernel may use. Twin of shaders/common.glsl: same functions, same order.
#ifndef ZG_COMMON_CL
#define ZG_COMMON_CL

#include "host/model/constants.h"

// Which work-group this is. May be past the last one that was asked for.
uint group_index(void) {
    return (uint)get_group_id(0);
}

// Which item of its work-group this is, and how many there are.
uint item_in_group(void) {
    return (uint)get_local_id(0);
}

uint group_items(void) {
    return (uint)get_local_size(0);
}

uint count_bits(uint word) {
    return popcount(word);
}

// Place of the lowest and of the highest bit of a word that is not 0.
uint lowest_bit(uint word) {
    return count_bits((word & (0 - word)) - 1);
}

uint highest_bit(uint word) {
    return 31 - clz(word);
}

// a * b / 2^shift, rounded towards minus infinity, of the whole product; shift 1 .. 31.
int shifted_product(int a, int b, uint shift) {
    const uint low = as_uint(a) * as_uint(b);
    return as_int(as_uint(mul_hi(a, b)) << (32 - shift) | low >> shift);
}

// A grid's word holds four cells, the first in the lowest byte. Value of the cell at place 0 .. 3.
int unpack_cell(uint word, uint place) {
    return as_int(word << (24 - 8 * place)) >> 24;
}

// Inverse of unpack_cell: the cell's share of the word.
uint pack_cell(int value, uint place) {
    return (as_uint(value) & 255u) << (8 * place);
}

#endif
