#pragma once

#include "field_scene.h"
#include "model/fusion.h"
#include "model/local_map.h"
#include "model/rays.h"
#include "model/zone_bits.h"
#include "model/zoned_cells.h"

#include <benchmark/benchmark.h>

#include <map>
#include <vector>

namespace zonegrid::bench {

/// The field scene taken through the model: one image, integrated and fused once.
struct FieldGrid {
    MapperOptions options;
    FusionRule rule;
    FieldScene scene;
    Window window;
    View view;          ///< of the image
    LocalMap local_map; ///< what it says
    Grid grid;          ///< that, fused into an empty grid
};

/// `line` model, range 40 m, zones of 32 cells.
[[nodiscard]] FieldGrid make_field_grid(double cell_m);

/// Occupied cells of the grid, zone by zone; zones without any are left out.
[[nodiscard]] std::map<ZoneIndex, ZoneBits> occupied_zones(const FieldGrid& field);

/// The cells of each object, objects in no particular order.
[[nodiscard]] std::vector<std::vector<CellIndex>> object_cells(const FieldGrid& field);

/// Edge of a cell for a benchmark whose first argument is in centimetres.
[[nodiscard]] inline double cell_m_of(const benchmark::State& state) {
    return static_cast<double>(state.range(0)) / 100.0;
}

/// The sizes every benchmark runs at.
inline void field_sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("cell_cm")->Arg(50)->Arg(25)->Arg(10)->Unit(benchmark::kMillisecond);
}

} // namespace zonegrid::bench
