#include "reference/encode_prism.h"

#include <algorithm>
#include <array>

namespace zonegrid::reference {

namespace {

struct Column {
    std::int32_t x = 0;
    std::int32_t y = 0;
    friend auto operator<=>(const Column&, const Column&) = default;
};

/// Writes the node that covers `columns` and, after it, its subtrees. `columns` is reordered.
void encode_node(std::span<Column> columns, const Column& origin, std::int32_t edge,
                 std::vector<std::uint8_t>& prism) {
    const std::int32_t half = edge / 2;
    const auto child_of = [&](const Column& column) {
        return (column.x - origin.x >= half ? 1U : 0U) | (column.y - origin.y >= half ? 2U : 0U);
    };
    std::ranges::sort(columns, {}, child_of);
    std::array<std::span<Column>, 4> children;
    std::uint32_t node = 0;
    std::size_t begin = 0;
    for (std::uint32_t child = 0; child < 4; ++child) {
        const auto count =
            static_cast<std::size_t>(std::ranges::count(columns.subspan(begin), child, child_of));
        children[child] = columns.subspan(begin, count);
        begin += count;
        const auto full = static_cast<std::size_t>(half) * static_cast<std::size_t>(half);
        const auto state = count == 0      ? ChildState::none
                           : count == full ? ChildState::all
                                           : ChildState::some;
        node |= static_cast<std::uint32_t>(state) << (2 * child);
    }
    prism.push_back(static_cast<std::uint8_t>(node));
    for (std::uint32_t child = 0; child < 4; ++child) {
        if (static_cast<ChildState>(node >> (2 * child) & 3U) == ChildState::some) {
            encode_node(children[child],
                        {origin.x + ((child & 1U) != 0 ? half : 0),
                         origin.y + ((child & 2U) != 0 ? half : 0)},
                        half, prism);
        }
    }
}

} // namespace

std::vector<std::uint8_t> encode_prism(std::span<const CellIndex> cells, const TreeRoot& root) {
    std::vector<Column> columns;
    columns.reserve(cells.size());
    for (const auto& cell : cells) {
        columns.push_back({cell.x, cell.y});
    }
    std::ranges::sort(columns);
    const auto doubled = std::ranges::unique(columns);
    columns.erase(doubled.begin(), doubled.end());
    std::vector<std::uint8_t> prism;
    encode_node(columns, {root.origin.x, root.origin.y}, root.edge, prism);
    return prism;
}

} // namespace zonegrid::reference
