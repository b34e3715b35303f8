#include "reference/integrate_scan.h"

#include "field_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace zonegrid::bench {
namespace {

/// Every fourth pixel of every fourth row of the scene as a point in the camera's frame.
std::vector<Eigen::Vector3f> scan_ends(const FieldScene& scene) {
    const auto& camera = scene.camera;
    std::vector<Eigen::Vector3f> ends;
    for (int v_px = 0; v_px < camera.height_px; v_px += 4) {
        for (int u_px = 0; u_px < camera.width_px; u_px += 4) {
            const float depth_m =
                scene.depth_m[static_cast<std::size_t>(v_px * camera.width_px + u_px)];
            const Eigen::Vector3d direction((u_px - camera.cx_px) / camera.fx_px,
                                            (v_px - camera.cy_px) / camera.fy_px, 1.0);
            ends.push_back(direction.cast<float>() * depth_m);
        }
    }
    return ends;
}

/// The occupied cells must be the cells of the rays' ends, no more and no fewer.
std::string problem_with(const ScanRays& rays, const LocalMap& local_map, int zone_edge) {
    std::set<CellIndex> expected;
    const CellIndex first = local_map.window().first_cell();
    for (const auto& ray : rays.rays) {
        if (ray.hit) {
            expected.insert({first.x + (ray.end.x >> ZG_SUB_BITS),
                             first.y + (ray.end.y >> ZG_SUB_BITS),
                             first.z + (ray.end.z >> ZG_SUB_BITS)});
        }
    }
    std::set<CellIndex> occupied;
    const auto edge = static_cast<std::size_t>(zone_edge);
    std::vector<std::uint8_t> statements(edge * edge * edge);
    for (const auto place : local_map.zones()) {
        local_map.copy_zone(place, statements);
        for (std::size_t i = 0; i < statements.size(); ++i) {
            if (statements[i] == ZG_STATEMENT_OCCUPIED) {
                occupied.insert(cell_at(local_map.window().zone_at(place),
                                        static_cast<std::uint32_t>(i), zone_edge));
            }
        }
    }
    if (expected.size() < 100) {
        return "the scan hits next to nothing";
    }
    return expected == occupied ? "" : "occupied cells are not the cells of the rays' ends";
}

void integrate_scan(benchmark::State& state) {
    const FieldScene scene = make_field_scene();
    MapperOptions options;
    options.cell_m = cell_m_of(state);
    Window window = make_window(options, std::nullopt);
    window.move_to(*cell_of(scene.world_from_camera.translation(), options.cell_m));
    const auto ends_m = scan_ends(scene);
    Scan scan;
    scan.ends_m = ends_m;
    const ScanRays rays = quantize_scan(scan, scene.world_from_camera, options, window);
    LocalMap local_map(window);
    reference::integrate_scan(rays, local_map);
    if (const auto problem = problem_with(rays, local_map, options.zone); !problem.empty()) {
        state.SkipWithError(problem.c_str());
        return;
    }
    for (auto _ : state) {
        local_map.clear();
        reference::integrate_scan(rays, local_map);
    }
    state.counters["rays"] = static_cast<double>(rays.rays.size());
}
BENCHMARK(integrate_scan)->Apply(field_sizes);

} // namespace
} // namespace zonegrid::bench
