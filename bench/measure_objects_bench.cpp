#include "reference/measure_objects.h"

#include "field_grid.h"

#include <set>

namespace zonegrid::bench {
namespace {

bool measures_are_right(const std::vector<CellIndex>& cells, const Object& object) {
    const std::set<CellIndex> sorted(cells.begin(), cells.end());
    std::int64_t sum_z = 0;
    std::set<std::int32_t> heights;
    for (const auto& cell : sorted) {
        sum_z += cell.z;
        heights.insert(cell.z);
    }
    return object.id == *sorted.begin() && object.cell_count == sorted.size() &&
           object.cell_sum[2] == sum_z && object.box_min.z == *heights.begin() &&
           object.box_max.z == *heights.rbegin() && object.box_max.x == sorted.rbegin()->x;
}

void measure_objects(benchmark::State& state) {
    const FieldGrid field = make_field_grid(cell_m_of(state));
    const auto objects = object_cells(field);
    std::int64_t cell_count = 0;
    for (const auto& cells : objects) {
        if (!measures_are_right(cells, reference::measure_object(cells))) {
            state.SkipWithError("an object's numbers are not those of its sorted cells");
            return;
        }
        cell_count += static_cast<std::int64_t>(cells.size());
    }
    for (auto _ : state) {
        for (const auto& cells : objects) {
            benchmark::DoNotOptimize(reference::measure_object(cells));
        }
    }
    state.counters["objects"] = static_cast<double>(objects.size());
    state.SetItemsProcessed(state.iterations() * cell_count);
}
BENCHMARK(measure_objects)->Apply(field_sizes);

} // namespace
} // namespace zonegrid::bench
