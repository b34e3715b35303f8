#include "reference/profile_heights.h"

#include "field_grid.h"

#include <algorithm>
#include <utility>

namespace zonegrid::bench {
namespace {

using Zones = std::map<ZoneIndex, ZoneBits>;

std::vector<ProfileColumn> profile(const Zones& zones, int zone_edge) {
    reference::HeightProfiler profiler(zone_edge);
    for (const auto& [zone, bits] : zones) {
        profiler.add_zone(zone, bits);
    }
    return profiler.columns();
}

/// The same, cell by cell.
std::vector<ProfileColumn> plain_profile(const Zones& zones, int zone_edge) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> least;
    for (const auto& [zone, bits] : zones) {
        bits.for_each([&, at = zone](std::uint32_t index) {
            const CellIndex cell = cell_at(at, index, zone_edge);
            auto& z = least.try_emplace({cell.x, cell.y}, cell.z).first->second;
            z = std::min(z, cell.z);
        });
    }
    std::vector<ProfileColumn> columns;
    for (const auto& [column, z] : least) {
        columns.push_back({column.first, column.second, z});
    }
    return columns;
}

void profile_heights(benchmark::State& state) {
    const FieldGrid field = make_field_grid(cell_m_of(state));
    const Zones zones = occupied_zones(field);
    const auto columns = profile(zones, field.options.zone);
    if (columns.empty() || columns != plain_profile(zones, field.options.zone)) {
        state.SkipWithError("the profile is not that of its cells");
        return;
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(profile(zones, field.options.zone));
    }
    state.counters["zones"] = static_cast<double>(zones.size());
    state.counters["columns"] = static_cast<double>(columns.size());
}
BENCHMARK(profile_heights)->Apply(field_sizes);

} // namespace
} // namespace zonegrid::bench
