#include "reference/encode_prism.h"

#include "field_grid.h"
#include "reference/measure_objects.h"

#include <set>
#include <utility>

namespace zonegrid::bench {
namespace {

/// Columns under the node at `next`, read back from the prism.
std::size_t count_columns(const std::vector<std::uint8_t>& prism, std::size_t edge,
                          std::size_t& next) {
    const unsigned node = prism.at(next++);
    const std::size_t half = edge / 2;
    std::size_t columns = 0;
    for (unsigned child = 0; child < 4; ++child) {
        const auto state = static_cast<ChildState>(node >> (2 * child) & 3U);
        columns += state == ChildState::all    ? half * half
                   : state == ChildState::some ? count_columns(prism, half, next)
                                               : 0;
    }
    return columns;
}

bool prism_is_right(const std::vector<CellIndex>& cells, const TreeRoot& root) {
    std::set<std::pair<std::int32_t, std::int32_t>> columns;
    for (const auto& cell : cells) {
        columns.emplace(cell.x, cell.y);
    }
    const auto prism = reference::encode_prism(cells, root);
    std::size_t next = 0;
    return count_columns(prism, static_cast<std::size_t>(root.edge), next) == columns.size() &&
           next == prism.size();
}

void encode_prism(benchmark::State& state) {
    const FieldGrid field = make_field_grid(cell_m_of(state));
    const auto objects = object_cells(field);
    std::vector<TreeRoot> roots;
    std::int64_t cell_count = 0;
    for (const auto& cells : objects) {
        const Object object = reference::measure_object(cells);
        roots.push_back(prism_root(object.box_min, object.box_max, field.options.zone));
        if (!prism_is_right(cells, roots.back())) {
            state.SkipWithError("a prism has another number of columns than its object");
            return;
        }
        cell_count += static_cast<std::int64_t>(cells.size());
    }
    for (auto _ : state) {
        for (std::size_t i = 0; i < objects.size(); ++i) {
            benchmark::DoNotOptimize(reference::encode_prism(objects[i], roots[i]));
        }
    }
    state.counters["objects"] = static_cast<double>(objects.size());
    state.SetItemsProcessed(state.iterations() * cell_count);
}
BENCHMARK(encode_prism)->Apply(field_sizes);

} // namespace
} // namespace zonegrid::bench
