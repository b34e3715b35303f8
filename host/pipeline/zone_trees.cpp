#include "pipeline/zone_trees.h"

#include "model/tree_root.h"

#include <algorithm>
#include <cassert>

namespace zonegrid {

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Nodes as section 8.4 writes them: two bits a child, eight children in two bytes or four in one.
template <std::size_t axes>
struct Node {
    static constexpr std::uint32_t children = 1U << axes;
    static constexpr std::size_t bytes = children / 4;
    static constexpr std::uint32_t full = axes == 3 ? 0x5555 : 0x55;

    static std::uint32_t read(std::span<const std::uint8_t> tree, std::size_t at) {
        std::uint32_t node = 0;
        for (std::size_t i = 0; i < bytes; ++i) {
            node |= std::uint32_t{tree[at + i]} << (8 * i);
        }
        return node;
    }
    static void write(Bytes& tree, std::size_t at, std::uint32_t node) {
        for (std::size_t i = 0; i < bytes; ++i) {
            tree[at + i] = static_cast<std::uint8_t>(node >> (8 * i));
        }
    }
    static ChildState state(std::uint32_t node, std::uint32_t child) {
        return static_cast<ChildState>(node >> (2 * child) & 3U);
    }
    static std::uint32_t with(ChildState state, std::uint32_t child) {
        return static_cast<std::uint32_t>(state) << (2 * child);
    }
};

/// A place in a tree that is read from its beginning on.
struct Reader {
    std::span<const std::uint8_t> tree;
    std::size_t at = 0;
};

/// Goes past a subtree; copies it to `copy` if there is one.
template <std::size_t axes>
void pass(Reader& reader, Bytes* copy) {
    const std::uint32_t node = Node<axes>::read(reader.tree, reader.at);
    if (copy != nullptr) {
        const auto first = reader.tree.begin() + static_cast<std::ptrdiff_t>(reader.at);
        copy->insert(copy->end(), first, first + static_cast<std::ptrdiff_t>(Node<axes>::bytes));
    }
    reader.at += Node<axes>::bytes;
    for (std::uint32_t child = 0; child < Node<axes>::children; ++child) {
        if (Node<axes>::state(node, child) == ChildState::some) {
            pass<axes>(reader, copy);
        }
    }
}

/// Appends the union of two subtrees of one cube. True if it fills the cube: then only its node is
/// written.
template <std::size_t axes>
bool unite(Reader& a, Reader& b, Bytes& result) {
    using N = Node<axes>;
    const std::uint32_t node_a = N::read(a.tree, a.at);
    const std::uint32_t node_b = N::read(b.tree, b.at);
    a.at += N::bytes;
    b.at += N::bytes;
    const std::size_t place = result.size();
    result.resize(place + N::bytes);
    std::uint32_t node = 0;
    for (std::uint32_t child = 0; child < N::children; ++child) {
        const ChildState of_a = N::state(node_a, child);
        const ChildState of_b = N::state(node_b, child);
        ChildState state = std::max(of_a, of_b); // none < all < some
        if (of_a == ChildState::all || of_b == ChildState::all) {
            state = ChildState::all;
            if (of_a == ChildState::some) {
                pass<axes>(a, nullptr);
            }
            if (of_b == ChildState::some) {
                pass<axes>(b, nullptr);
            }
        } else if (of_a == ChildState::some && of_b == ChildState::some) {
            const std::size_t before = result.size();
            if (unite<axes>(a, b, result)) {
                state = ChildState::all;
                result.resize(before);
            }
        } else if (state == ChildState::some) {
            pass<axes>(of_a == ChildState::some ? a : b, &result);
        }
        node |= N::with(state, child);
    }
    N::write(result, place, node);
    return node == N::full;
}

template <std::size_t axes>
class ZoneTreeBuilder {
public:
    /// Appends the tree over a cube of zones. True if it fills the cube: then only its node is
    /// written.
    bool build(std::span<ZoneTree<axes>> trees, const std::array<std::int32_t, axes>& origin,
               std::int32_t edge_zones, Bytes& result) {
        using N = Node<axes>;
        if (edge_zones == 1) {
            return build_zone(trees, result);
        }
        const std::int32_t half = edge_zones / 2;
        const auto child_of = [&](const ZoneTree<axes>& tree) {
            std::uint32_t child = 0;
            for (std::size_t axis = 0; axis < axes; ++axis) {
                child |= (tree.zone[axis] - origin[axis] >= half ? 1U : 0U) << axis;
            }
            return child;
        };
        std::ranges::sort(trees, {}, child_of);
        const std::size_t place = result.size();
        result.resize(place + N::bytes);
        std::uint32_t node = 0;
        for (auto first = trees.begin(); first != trees.end();) {
            const std::uint32_t child = child_of(*first);
            const auto end = std::find_if(
                first, trees.end(), [&](const auto& tree) { return child_of(tree) != child; });
            auto child_origin = origin;
            for (std::size_t axis = 0; axis < axes; ++axis) {
                child_origin[axis] += (child >> axis & 1U) != 0 ? half : 0;
            }
            const std::size_t before = result.size();
            const bool full = build({first, end}, child_origin, half, result);
            if (full) {
                result.resize(before);
            }
            node |= N::with(full ? ChildState::all : ChildState::some, child);
            first = end;
        }
        N::write(result, place, node);
        if (node == N::full) {
            result.resize(place + N::bytes);
            return true;
        }
        return false;
    }

private:
    static bool build_zone(std::span<const ZoneTree<axes>> trees, Bytes& result) {
        Bytes united(trees.front().bytes.begin(), trees.front().bytes.end());
        for (const auto& tree : trees.subspan(1)) {
            Bytes next;
            Reader a{united};
            Reader b{tree.bytes};
            if (unite<axes>(a, b, next)) {
                next.resize(Node<axes>::bytes);
            }
            united = std::move(next);
        }
        result.insert(result.end(), united.begin(), united.end());
        return Node<axes>::read(united, 0) == Node<axes>::full;
    }
};

} // namespace

template <std::size_t axes>
std::vector<std::uint8_t> unite_zone_trees(std::vector<ZoneTree<axes>> trees,
                                           const std::array<std::int32_t, axes>& origin,
                                           std::int32_t edge_zones) {
    assert(!trees.empty());
    Bytes result;
    ZoneTreeBuilder<axes>().build(trees, origin, edge_zones, result);
    return result;
}

template std::vector<std::uint8_t> unite_zone_trees<2>(std::vector<ZoneTree<2>>,
                                                       const std::array<std::int32_t, 2>&,
                                                       std::int32_t);
template std::vector<std::uint8_t> unite_zone_trees<3>(std::vector<ZoneTree<3>>,
                                                       const std::array<std::int32_t, 3>&,
                                                       std::int32_t);

} // namespace zonegrid
