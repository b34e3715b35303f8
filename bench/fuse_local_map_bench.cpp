#include "reference/fuse_local_map.h"

#include "field_grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zonegrid::bench {
namespace {

/// After one image into an empty grid every value follows from the statement alone.
bool values_follow(const FieldGrid& field) {
    std::uint64_t occupied = 0;
    std::vector<std::uint8_t> statements(field.grid.zone_cells());
    for (const auto place : field.local_map.zones()) {
        field.local_map.copy_zone(place, statements);
        const auto values = field.grid.find(place);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const int expected = statements[i] == ZG_STATEMENT_OCCUPIED ? field.options.hit
                                 : statements[i] == ZG_STATEMENT_FREE   ? -field.options.miss
                                                                        : 0;
            if (values[i] != expected) {
                return false;
            }
            occupied += expected > 0 ? 1U : 0U;
        }
    }
    return occupied > 100;
}

void fuse_local_map(benchmark::State& state) {
    FieldGrid field = make_field_grid(cell_m_of(state));
    if (!values_follow(field)) {
        state.SkipWithError("values are not those that the statements give");
        return;
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            reference::fuse_local_map(field.local_map, field.view, field.rule, field.grid));
    }
    const auto zones = field.local_map.zones().size();
    const auto cells = zones * field.grid.zone_cells();
    state.counters["zones"] = static_cast<double>(zones);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cells));
}
BENCHMARK(fuse_local_map)->Apply(field_sizes);

} // namespace
} // namespace zonegrid::bench
