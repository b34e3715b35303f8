#include "evaluation/evaluation.h"

#include "evaluation/cell_measures.h"
#include "evaluation/gap_measures.h"
#include "evaluation/moving_measures.h"
#include "evaluation/obstacle_measures.h"
#include "evaluation/solid_cells.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace zonegrid {
namespace {

/// A box of cells that grows. Nothing in it is more than 2^30 cells and a range from the origin.
struct GrowingBox {
    CellBox box;
    bool empty = true;

    void add(const CellIndex& cell, std::int32_t margin) {
        const CellBox around{{cell.x - margin, cell.y - margin, cell.z - margin},
                             {cell.x + margin, cell.y + margin, cell.z + margin}};
        if (empty) {
            box = around;
            empty = false;
            return;
        }
        box.low = {std::min(box.low.x, around.low.x), std::min(box.low.y, around.low.y),
                   std::min(box.low.z, around.low.z)};
        box.high = {std::max(box.high.x, around.high.x), std::max(box.high.y, around.high.y),
                    std::max(box.high.z, around.high.z)};
    }
};

/// What the images can show and the map speaks of, up to over the highest surface.
CellBox region_of(const JudgedMap& map, const Truth& truth) {
    constexpr std::int32_t margin = 3; // more than the farthest distance at which cells compare
    GrowingBox region;
    const auto range = static_cast<std::int32_t>(std::ceil(map.range_m / map.cell_m));
    for (std::size_t i = map.span.first; i < map.span.last; ++i) {
        region.add(cell_at_m(truth.images[i].world_from_camera.translation(), map.cell_m),
                   range + margin);
    }
    for (const CellSet* const cells : {&map.occupied, &map.free, &map.undecided}) {
        for (const auto& [zone, bits] : cells->zones()) {
            const CellIndex low = first_cell_of(zone, CellSet::zone_edge);
            const std::int32_t last = CellSet::zone_edge - 1;
            region.add(low, margin);
            region.add({low.x + last, low.y + last, low.z + last}, margin);
        }
    }
    CellBox cells = region.box;
    if (const auto extent = extent_m(truth.surfaces)) {
        cells.low.z = std::min(cells.low.z, cell_at_m(extent->min(), map.cell_m).z - 1);
    }
    return cells;
}

/// The part of a region of which the truth says what is solid: above, on and under surfaces.
CellBox solid_region(const CellBox& region, const Surfaces& surfaces, double cell_m) {
    CellBox box = region;
    if (const auto extent = extent_m(surfaces)) {
        const CellIndex low = cell_at_m(extent->min(), cell_m);
        const CellIndex high = cell_at_m(extent->max(), cell_m);
        box.low.x = std::max(box.low.x, low.x);
        box.low.y = std::max(box.low.y, low.y);
        box.high.x = std::min(box.high.x, high.x);
        box.high.y = std::min(box.high.y, high.y);
    }
    return box;
}

HeightProfile profile_of(const CellSet& cells, double cell_m) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> columns;
    cells.for_each([&](const CellIndex& cell) {
        const auto [column, is_new] = columns.try_emplace({cell.x, cell.y}, cell.z);
        column->second = std::min(column->second, cell.z);
    });
    HeightProfile profile{cell_m, {}};
    for (const auto& [place, z] : columns) {
        profile.columns.push_back({place.first, place.second, z});
    }
    return profile;
}

/// Visible surface cells and those that would do as well, which a map holds by chance.
CellSet with_alternatives(const TrueView& view) {
    CellSet cells;
    view.surface.for_each([&](const CellIndex& cell) {
        for (const auto& one : alternatives(view, cell)) {
            cells.insert(one);
        }
    });
    return cells;
}

Evaluation describe(const JudgedMap& map, const Truth& truth) {
    Evaluation evaluation;
    evaluation.map = map.folder;
    evaluation.recording = map.recording;
    evaluation.scene = truth.scene;
    evaluation.seed = truth.seed;
    evaluation.cell_m = map.cell_m;
    evaluation.range_m = map.range_m;
    evaluation.model = map.model;
    evaluation.has_history = map.has_history;
    for (std::size_t i = map.span.first; i < map.span.last; ++i) {
        evaluation.trajectory_m.emplace_back(truth.images[i].world_from_camera.translation());
    }
    return evaluation;
}

} // namespace

Evaluation evaluate(const JudgedMap& map, const Truth& truth, const TrueImageDrawer& draw,
                    const EvaluationOptions& options,
                    const std::function<void(std::size_t, std::size_t)>& observer) {
    Evaluation evaluation = describe(map, truth);
    const CellBox region = region_of(map, truth);
    const TouchedCells touched = touch_cells(truth.surfaces, map.cell_m, region);

    TrueViewOptions looking{map.cell_m, map.range_m, map.span.first, map.span.last, 1};
    looking.every = options.every.value_or(choose_every(truth.camera, looking));
    const std::size_t images = (map.span.last - map.span.first + looking.every - 1) / looking.every;
    const TrueView view = look_around(truth, touched, draw, looking,
                                      [&](std::size_t done) { observer(done, images); });
    evaluation.every = looking.every;
    evaluation.images = view.images;
    evaluation.hits = view.hits;
    evaluation.unplaced_hits = view.unplaced_hits;

    std::vector<CellIndex> open; // where the camera was, nothing is solid
    for (const auto& place_m : evaluation.trajectory_m) {
        open.push_back(cell_at_m(place_m, map.cell_m));
    }
    const SolidCells solid(touched.all(), solid_region(region, truth.surfaces, map.cell_m), open);
    const CellSet passing = moving_cells(truth, map.span.last - 1, map.cell_m, region);
    evaluation.cells = measure_cells(map, touched, passing, view, solid);
    evaluation.obstacles = measure_obstacles(map, truth, touched, view);
    for (std::size_t i = 0; i < view.surface_of.size(); ++i) {
        evaluation.obstacles_never_visible +=
            view.surface_of[i].empty() && !truth.surfaces.obstacles[i].moving ? 1U : 0U;
    }
    evaluation.lines = measure_lines(evaluation.obstacles);
    measure_gaps(map, truth, evaluation.obstacles, evaluation.lines);
    evaluation.moving = measure_moving(map, truth, touched, passing, view, region);
    evaluation.map_profile = profile_of(map.occupied, map.cell_m);
    evaluation.true_profile = profile_of(with_alternatives(view), map.cell_m);
    return evaluation;
}

} // namespace zonegrid
