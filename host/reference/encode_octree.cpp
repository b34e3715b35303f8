#include "reference/encode_octree.h"

#include "zonegrid/errors.h"

#include <algorithm>
#include <array>

namespace zonegrid::reference {

namespace {

CellIndex child_origin(const CellIndex& origin, std::uint32_t child, std::int32_t half) {
    return {origin.x + ((child & 1U) != 0 ? half : 0), origin.y + ((child & 2U) != 0 ? half : 0),
            origin.z + ((child & 4U) != 0 ? half : 0)};
}

/// Writes the node that covers `cells` and, after it, its subtrees. `spare` is as long as `cells`;
/// both are overwritten.
void encode_node(std::span<CellIndex> cells, std::span<CellIndex> spare, const CellIndex& origin,
                 std::int32_t edge, std::vector<std::uint8_t>& octree) {
    const std::int32_t half = edge / 2;
    const auto child_of = [&](const CellIndex& cell) {
        return (cell.x - origin.x >= half ? 1U : 0U) | (cell.y - origin.y >= half ? 2U : 0U) |
               (cell.z - origin.z >= half ? 4U : 0U);
    };
    // 1. Move the cells to `spare`, child by child.
    std::array<std::size_t, 9> begin{};
    for (const auto& cell : cells) {
        ++begin[child_of(cell) + 1];
    }
    for (std::size_t child = 0; child < 8; ++child) {
        begin[child + 1] += begin[child];
    }
    auto next = begin;
    for (const auto& cell : cells) {
        spare[next[child_of(cell)]++] = cell;
    }
    // 2. Write the node.
    const auto full = static_cast<std::size_t>(half) * static_cast<std::size_t>(half) *
                      static_cast<std::size_t>(half);
    std::array<ChildState, 8> states{};
    std::uint32_t node = 0;
    for (std::size_t child = 0; child < 8; ++child) {
        const std::size_t count = begin[child + 1] - begin[child];
        states[child] = count == 0      ? ChildState::none
                        : count == full ? ChildState::all
                                        : ChildState::some;
        node |= static_cast<std::uint32_t>(states[child]) << (2 * child);
    }
    octree.push_back(static_cast<std::uint8_t>(node & 0xFFU));
    octree.push_back(static_cast<std::uint8_t>(node >> 8U));
    // 3. Descend.
    for (std::uint32_t child = 0; child < 8; ++child) {
        if (states[child] == ChildState::some) {
            const std::size_t count = begin[child + 1] - begin[child];
            encode_node(spare.subspan(begin[child], count), cells.subspan(begin[child], count),
                        child_origin(origin, child, half), half, octree);
        }
    }
}

class OctreeDecoder {
public:
    explicit OctreeDecoder(std::span<const std::uint8_t> octree) : octree_(octree) {}

    std::vector<CellIndex> decode(const TreeRoot& root) {
        decode_node(root.origin, root.edge);
        if (next_ != octree_.size()) {
            refuse("bytes are left over after its last node");
        }
        std::ranges::sort(cells_);
        return std::move(cells_);
    }

private:
    [[noreturn]] static void refuse(const char* problem) {
        throw InputError("octree", problem, "the object is damaged; store it again");
    }

    void decode_node(const CellIndex& origin, std::int32_t edge) {
        if (octree_.size() - next_ < 2) {
            refuse("it ends in the middle of a node");
        }
        if (edge < 2) {
            refuse("it divides a single cell");
        }
        const std::uint32_t node = octree_[next_] | static_cast<std::uint32_t>(octree_[next_ + 1])
                                                        << 8U;
        next_ += 2;
        const std::int32_t half = edge / 2;
        for (std::uint32_t child = 0; child < 8; ++child) {
            const auto child_first = child_origin(origin, child, half);
            switch (node >> (2 * child) & 3U) {
                case 0:
                    break;
                case 1:
                    fill(child_first, half);
                    break;
                case 2:
                    decode_node(child_first, half);
                    break;
                default:
                    refuse("a child has the state 3");
            }
        }
    }

    void fill(const CellIndex& origin, std::int32_t edge) {
        for (std::int32_t z = 0; z < edge; ++z) {
            for (std::int32_t y = 0; y < edge; ++y) {
                for (std::int32_t x = 0; x < edge; ++x) {
                    cells_.push_back({origin.x + x, origin.y + y, origin.z + z});
                }
            }
        }
    }

    std::span<const std::uint8_t> octree_;
    std::size_t next_ = 0;
    std::vector<CellIndex> cells_;
};

} // namespace

std::vector<std::uint8_t> encode_octree(std::span<const CellIndex> cells, const TreeRoot& root) {
    std::vector<CellIndex> sorted(cells.begin(), cells.end());
    std::vector<CellIndex> spare(cells.size());
    std::vector<std::uint8_t> octree;
    encode_node(sorted, spare, root.origin, root.edge, octree);
    return octree;
}

std::vector<CellIndex> decode_octree(std::span<const std::uint8_t> octree, const TreeRoot& root) {
    return OctreeDecoder(octree).decode(root);
}

} // namespace zonegrid::reference
