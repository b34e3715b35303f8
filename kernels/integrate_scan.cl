// Draws a scan into a local map, every ray walked alone (docs/model.md, section 5).
// Twin of shaders/integrate_scan.comp.
#include "kernels/params/integrate_scan.h"
#include "kernels/parts/draw_segment.cl"

__kernel __attribute__((reqd_work_group_size(ZG_GROUP_ITEMS, 1, 1))) void integrate_scan(
    volatile __global uint* local_planes, // a zone: free plane, occupied plane
    __global const uint* zone_slots,      // by place in the window
    volatile __global uint* faults,       // zones entered that nobody reserved
    __global const int* rays,             // a ray: start, end, 1 if an obstacle is at the end
    const struct IntegrateScanParams params) {
    // An item takes one ray.
    const uint ray = group_index() * group_items() + item_in_group();
    if (ray >= params.rays) {
        return;
    }
    const LocalMap map = {local_planes, zone_slots, faults, params.local_map};
    const uint first = 7 * ray;
    const int3 start = (int3)(rays[first], rays[first + 1], rays[first + 2]);
    const int3 end = (int3)(rays[first + 3], rays[first + 4], rays[first + 5]);
    draw_segment(&map, ZG_FREE_PLANE, start, end);
    if (rays[first + 6] != 0) {
        draw_point(&map, ZG_OCCUPIED_PLANE, end);
    }
}
