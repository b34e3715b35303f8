#include "pipeline/reference_engine.h"

#include "reference/draw_objects.h"
#include "reference/fuse_local_map.h"
#include "reference/integrate_image.h"
#include "reference/integrate_scan.h"
#include "reference/profile_heights.h"

namespace zonegrid {

ReferenceEngine::ReferenceEngine(const MapperOptions& options, const Window& window)
    : rule_(options), grid_(window), local_map_(window), tracker_(options.zone) {}

void ReferenceEngine::move_to(const Window& window,
                              const std::function<void(const ZoneIndex&, const ZoneBits&)>& leave) {
    local_map_.move_to(window);
    grid_.move_to(window, [&](const ZoneIndex& zone, std::span<const std::int8_t> values) {
        leave(zone, occupied_bits(values, rule_.threshold, window.zone_edge()));
    });
}

void ReferenceEngine::draw_objects(const ZoneIndex& zone, std::span<const CellIndex> cells) {
    const Window& window = grid_.window();
    reference::draw_objects(cells, rule_, window.zone_edge(), grid_.touch(window.place_of(zone)));
}

void ReferenceEngine::integrate_image(const ImageRays& rays) {
    local_map_.clear();
    reference::integrate_image(rays, local_map_);
    view_ = rays.view;
}

void ReferenceEngine::integrate_scan(const ScanRays& scan) {
    local_map_.clear();
    reference::integrate_scan(scan, local_map_);
    view_ = {};
}

FusionResult ReferenceEngine::fuse_local_map() {
    return reference::fuse_local_map(local_map_, view_, rule_, grid_);
}

void ReferenceEngine::visit_local_map(
    const std::function<void(std::uint32_t, std::span<const std::uint8_t>)>& visit) {
    const auto edge = static_cast<std::size_t>(grid_.window().zone_edge());
    std::vector<std::uint8_t> statements(edge * edge * edge);
    for (const auto place : local_map_.zones()) {
        local_map_.copy_zone(place, statements);
        visit(place, statements);
    }
}

void ReferenceEngine::track(std::span<const ZoneIndex> changed) {
    for (const auto& zone : changed) {
        tracker_.set_zone(zone, occupied(grid_.window().place_of(zone)));
    }
}

std::vector<ProfileColumn> ReferenceEngine::profile_heights(std::int32_t z_least) {
    reference::HeightProfiler profiler(grid_.window().zone_edge(), z_least);
    for (const auto place : grid_.held()) {
        profiler.add_zone(grid_.window().zone_at(place), occupied(place));
    }
    return profiler.columns();
}

ZoneBits ReferenceEngine::occupied(std::uint32_t place) const {
    return occupied_bits(grid_.find(place), rule_.threshold, grid_.window().zone_edge());
}

} // namespace zonegrid
