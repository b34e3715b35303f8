// Count, box, sums and least cell of each piece of labelled zones (docs/model.md, section 8.3).
// Twin of shaders/measure_objects.comp.
#include "kernels/common.cl"
#include "kernels/params/zone_pieces.h"

__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void measure_objects(
    __global const uint* numbers,      // a labelled zone, a cell: its piece from 1 on, or 0
    __global const uint* first_pieces, // a labelled zone: its first piece's place below
    volatile __global uint* measures,  // a piece: ZG_MEASURE_WORDS, 0 before
    const struct ZonePiecesParams params) {
    // 1. A work-group takes a zone, an item a row of cells at a time.
    const uint zone = group_index();
    if (zone >= params.items) {
        return;
    }
    const uint zone_bits = (uint)params.zone_bits;
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
            volatile __global uint* const piece =
                measures + ZG_MEASURE_WORDS * (first_pieces[zone] + number - 1);
            atomic_add(&piece[0], cells);
            atomic_max(&piece[1], last - x_first);
            atomic_max(&piece[2], last - y);
            atomic_max(&piece[3], last - z);
            atomic_max(&piece[4], x - 1);
            atomic_max(&piece[5], y);
            atomic_max(&piece[6], z);
            atomic_add(&piece[7], cells * (x_first + x - 1) / 2);
            atomic_add(&piece[8], cells * y);
            atomic_add(&piece[9], cells * z);
            atomic_max(&piece[10], ~(((x_first << zone_bits | y) << zone_bits) | z));
        }
    }
}
