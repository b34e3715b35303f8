#include "reference/encode_octree.h"

#include "field_grid.h"
#include "reference/measure_objects.h"

#include <algorithm>
#include <utility>

namespace zonegrid::bench {
namespace {

struct Rooted {
    std::vector<CellIndex> cells;
    TreeRoot root;
};

std::vector<Rooted> rooted_objects(const FieldGrid& field) {
    std::vector<Rooted> objects;
    for (auto& cells : object_cells(field)) {
        const Object object = reference::measure_object(cells);
        objects.push_back({cells, octree_root(object.box_min, object.box_max, field.options.zone)});
    }
    return objects;
}

std::int64_t cells_in(const std::vector<Rooted>& objects) {
    std::int64_t cells = 0;
    for (const auto& object : objects) {
        cells += static_cast<std::int64_t>(object.cells.size());
    }
    return cells;
}

void encode_octree(benchmark::State& state) {
    const auto objects = rooted_objects(make_field_grid(cell_m_of(state)));
    std::size_t bytes = 0;
    for (const auto& object : objects) {
        const auto octree = reference::encode_octree(object.cells, object.root);
        auto sorted = object.cells;
        std::ranges::sort(sorted);
        if (reference::decode_octree(octree, object.root) != sorted) {
            state.SkipWithError("an octree does not give back its object's cells");
            return;
        }
        bytes += octree.size();
    }
    for (auto _ : state) {
        for (const auto& object : objects) {
            benchmark::DoNotOptimize(reference::encode_octree(object.cells, object.root));
        }
    }
    state.counters["objects"] = static_cast<double>(objects.size());
    state.counters["bytes"] = static_cast<double>(bytes);
    state.SetItemsProcessed(state.iterations() * cells_in(objects));
}
BENCHMARK(encode_octree)->Apply(field_sizes);

void decode_octree(benchmark::State& state) {
    const auto objects = rooted_objects(make_field_grid(cell_m_of(state)));
    std::vector<std::pair<std::vector<std::uint8_t>, TreeRoot>> octrees;
    for (const auto& object : objects) {
        octrees.emplace_back(reference::encode_octree(object.cells, object.root), object.root);
        if (reference::decode_octree(octrees.back().first, object.root).size() !=
            object.cells.size()) {
            state.SkipWithError("an octree does not give back its object's cells");
            return;
        }
    }
    for (auto _ : state) {
        for (const auto& [octree, root] : octrees) {
            benchmark::DoNotOptimize(reference::decode_octree(octree, root));
        }
    }
    state.SetItemsProcessed(state.iterations() * cells_in(objects));
}
BENCHMARK(decode_octree)->Apply(field_sizes);

} // namespace
} // namespace zonegrid::bench
