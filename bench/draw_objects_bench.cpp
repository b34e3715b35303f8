#include "reference/draw_objects.h"

#include "field_grid.h"

#include <algorithm>

namespace zonegrid::bench {
namespace {

/// The occupied cells of each zone, as the feature map hands them over.
std::vector<std::vector<CellIndex>> remembered_zones(const FieldGrid& field) {
    std::vector<std::vector<CellIndex>> zones;
    for (const auto& [zone, bits] : occupied_zones(field)) {
        auto& cells = zones.emplace_back();
        bits.for_each([&](std::uint32_t index) {
            cells.push_back(cell_at(zone, index, field.options.zone));
        });
    }
    return zones;
}

void draw_objects(benchmark::State& state) {
    const FieldGrid field = make_field_grid(cell_m_of(state));
    const auto zones = remembered_zones(field);
    std::vector<std::int8_t> values(field.grid.zone_cells());
    std::int64_t cell_count = 0;
    for (const auto& cells : zones) {
        std::ranges::fill(values, std::int8_t{0});
        reference::draw_objects(cells, field.rule, field.options.zone, values);
        if (std::ranges::count(values, field.rule.drawn()) != std::ssize(cells) ||
            std::ranges::count(values, 0) != std::ssize(values) - std::ssize(cells)) {
            state.SkipWithError("a zone has other cells than were drawn into it");
            return;
        }
        cell_count += std::ssize(cells);
    }
    for (auto _ : state) {
        for (const auto& cells : zones) {
            std::ranges::fill(values, std::int8_t{0});
            reference::draw_objects(cells, field.rule, field.options.zone, values);
            benchmark::DoNotOptimize(values.data());
        }
    }
    state.counters["zones"] = static_cast<double>(zones.size());
    state.SetItemsProcessed(state.iterations() * cell_count);
}
BENCHMARK(draw_objects)->Apply(field_sizes);

} // namespace
} // namespace zonegrid::bench
