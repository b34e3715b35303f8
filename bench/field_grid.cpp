#include "field_grid.h"

#include "reference/fuse_local_map.h"
#include "reference/integrate_image.h"
#include "reference/label_components.h"

#include <utility>

namespace zonegrid::bench {

FieldGrid make_field_grid(double cell_m) {
    MapperOptions options;
    options.cell_m = cell_m;
    options.range_m = 40.0;
    FieldScene scene = make_field_scene();
    Window window = make_window(options, scene.camera);
    window.move_to(*cell_of(scene.world_from_camera.translation(), cell_m));
    LocalMap local_map(window);
    Grid grid(window);
    const FusionRule rule(options);

    ImageRays rays;
    ImageQuantizer(scene.camera, options)
        .quantize(scene.depth_m, scene.world_from_camera, window, rays);
    reference::integrate_image(rays, local_map);
    reference::fuse_local_map(local_map, rays.view, rule, grid);
    return {options,        rule, std::move(scene), window, rays.view, std::move(local_map),
            std::move(grid)};
}

std::map<ZoneIndex, ZoneBits> occupied_zones(const FieldGrid& field) {
    std::map<ZoneIndex, ZoneBits> zones;
    for (const auto place : field.grid.held()) {
        ZoneBits bits =
            occupied_bits(field.grid.find(place), field.rule.threshold, field.options.zone);
        if (bits.any()) {
            zones.emplace(field.window.zone_at(place), std::move(bits));
        }
    }
    return zones;
}

std::vector<std::vector<CellIndex>> object_cells(const FieldGrid& field) {
    std::map<ZoneIndex, reference::ZonePieces> pieces;
    for (const auto& [zone, bits] : occupied_zones(field)) {
        pieces.emplace(zone, reference::label_zone(bits, field.options.zone));
    }
    std::vector<std::vector<CellIndex>> objects;
    for (const auto& component : reference::join_pieces(pieces)) {
        auto& cells = objects.emplace_back();
        for (const auto& [zone, piece] : component) {
            for (const auto index : pieces.at(zone).pieces[piece]) {
                cells.push_back(cell_at(zone, index, field.options.zone));
            }
        }
    }
    return objects;
}

} // namespace zonegrid::bench
