#include "reference/integrate_scan.h"

#include "reference/draw_segment.h"

namespace zonegrid::reference {

void integrate_scan(const ScanRays& scan, LocalMap& local_map) {
    for (const auto& ray : scan.rays) {
        draw_segment(ray.start, ray.end, ZG_STATEMENT_FREE, local_map);
    }
    // Obstacles last, all of them: occupied beats free in whatever order the rays come.
    for (const auto& ray : scan.rays) {
        if (ray.hit) {
            draw_point(ray.end, ZG_STATEMENT_OCCUPIED, local_map);
        }
    }
}

} // namespace zonegrid::reference
