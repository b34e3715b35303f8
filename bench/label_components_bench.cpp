#include "reference/label_components.h"

#include "field_grid.h"

#include <set>
#include <utility>

namespace zonegrid::bench {
namespace {

using Zones = std::map<ZoneIndex, ZoneBits>;
using Pieces = std::map<ZoneIndex, reference::ZonePieces>;

Pieces label_zones(const Zones& zones, int zone_edge) {
    Pieces pieces;
    for (const auto& [zone, bits] : zones) {
        pieces.emplace(zone, reference::label_zone(bits, zone_edge));
    }
    return pieces;
}

/// Number of components of a set of cells, by plain flood fill.
std::size_t count_components(std::set<CellIndex> left) {
    std::size_t components = 0;
    while (!left.empty()) {
        ++components;
        std::vector<CellIndex> open{left.extract(left.begin()).value()};
        while (!open.empty()) {
            const CellIndex cell = open.back();
            open.pop_back();
            for (const CellIndex& next : {CellIndex{cell.x + 1, cell.y, cell.z},
                                          {cell.x - 1, cell.y, cell.z},
                                          {cell.x, cell.y + 1, cell.z},
                                          {cell.x, cell.y - 1, cell.z},
                                          {cell.x, cell.y, cell.z + 1},
                                          {cell.x, cell.y, cell.z - 1}}) {
                if (left.erase(next) != 0) {
                    open.push_back(next);
                }
            }
        }
    }
    return components;
}

std::set<CellIndex> all_cells(const Zones& zones, int zone_edge) {
    std::set<CellIndex> cells;
    for (const auto& [zone, bits] : zones) {
        bits.for_each([&](std::uint32_t index) { cells.insert(cell_at(zone, index, zone_edge)); });
    }
    return cells;
}

void report_sizes(benchmark::State& state, const Zones& zones, std::size_t components) {
    state.counters["zones"] = static_cast<double>(zones.size());
    state.counters["objects"] = static_cast<double>(components);
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(zones.size() * 32 * 32 * 32));
}

void label_components(benchmark::State& state) {
    const FieldGrid field = make_field_grid(cell_m_of(state));
    const Zones zones = occupied_zones(field);
    const auto components = reference::join_pieces(label_zones(zones, field.options.zone)).size();
    if (components != count_components(all_cells(zones, field.options.zone))) {
        state.SkipWithError("the number of components is not that of a plain flood fill");
        return;
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(reference::join_pieces(label_zones(zones, field.options.zone)));
    }
    report_sizes(state, zones, components);
}
BENCHMARK(label_components)->Apply(field_sizes);

/// The part that runs over all zones, whichever of them changed.
void label_components_join(benchmark::State& state) {
    const FieldGrid field = make_field_grid(cell_m_of(state));
    const Zones zones = occupied_zones(field);
    const Pieces pieces = label_zones(zones, field.options.zone);
    const auto components = reference::join_pieces(pieces).size();
    if (components != count_components(all_cells(zones, field.options.zone))) {
        state.SkipWithError("the number of components is not that of a plain flood fill");
        return;
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(reference::join_pieces(pieces));
    }
    report_sizes(state, zones, components);
}
BENCHMARK(label_components_join)->Apply(field_sizes);

} // namespace
} // namespace zonegrid::bench
