#include "reference/encode_prism.h"

#include <array>

namespace zonegrid::reference {

namespace {

struct Column {
    std::int32_t x = 0;
    std::int32_t y = 0;
};

/// Writes the node that covers `columns` and, after it, its subtrees; returns whether the ground
/// plan fills it, in which case nothing has been written. `columns` is not empty and may name a
/// column many times; `spare` is as long; both are overwritten.
bool encode_node(std::span<Column> columns, std::span<Column> spare, const Column& origin,
                 std::int32_t edge, std::vector<std::uint8_t>& prism) {
    if (edge == 1) {
        return true;
    }
    const std::int32_t half = edge / 2;
    const auto child_of = [&](const Column& column) {
        return (column.x - origin.x >= half ? 1U : 0U) | (column.y - origin.y >= half ? 2U : 0U);
    };
    // 1. Move the columns to `spare`, child by child.
    std::array<std::size_t, 5> begin{};
    for (const auto& column : columns) {
        ++begin[child_of(column) + 1];
    }
    for (std::size_t child = 0; child < 4; ++child) {
        begin[child + 1] += begin[child];
    }
    auto next = begin;
    for (const auto& column : columns) {
        spare[next[child_of(column)]++] = column;
    }
    // 2. Descend; only then it is known which children are full.
    const std::size_t place = prism.size();
    prism.push_back(0);
    std::uint32_t node = 0;
    for (std::uint32_t child = 0; child < 4; ++child) {
        const std::size_t count = begin[child + 1] - begin[child];
        if (count == 0) {
            continue;
        }
        const bool full = encode_node(
            spare.subspan(begin[child], count), columns.subspan(begin[child], count),
            {origin.x + ((child & 1U) != 0 ? half : 0), origin.y + ((child & 2U) != 0 ? half : 0)},
            half, prism);
        const auto state = full ? ChildState::all : ChildState::some;
        node |= static_cast<std::uint32_t>(state) << (2 * child);
    }
    // 3. Write the node.
    constexpr std::uint32_t all_full = 0x55;
    if (node == all_full) {
        prism.resize(place);
        return true;
    }
    prism[place] = static_cast<std::uint8_t>(node);
    return false;
}

} // namespace

std::vector<std::uint8_t> encode_prism(std::span<const CellIndex> cells, const TreeRoot& root) {
    std::vector<Column> columns;
    columns.reserve(cells.size());
    for (const auto& cell : cells) {
        columns.push_back({cell.x, cell.y});
    }
    std::vector<Column> spare(columns.size());
    std::vector<std::uint8_t> prism;
    if (encode_node(columns, spare, {root.origin.x, root.origin.y}, root.edge, prism)) {
        prism.push_back(0x55); // the root is always written
    }
    return prism;
}

} // namespace zonegrid::reference
