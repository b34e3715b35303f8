#include "pipeline/piece_tracker.h"

#include "model/tree_root.h"
#include "pipeline/zone_trees.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace zonegrid {

namespace {

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }
    std::size_t root_of(std::size_t member) {
        while (parents_[member] != member) {
            parents_[member] = parents_[parents_[member]];
            member = parents_[member];
        }
        return member;
    }
    void join(std::size_t a, std::size_t b) {
        a = root_of(a);
        b = root_of(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parents_;
};

CellIndex least_of(const CellIndex& a, const CellIndex& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

CellIndex greatest_of(const CellIndex& a, const CellIndex& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// Calls `visit(piece, next_piece)` for each pair of cells that share a face, one in either layer.
template <class Visit>
void for_each_contact(const BorderLayer& layer, const BorderLayer& next_layer, Visit&& visit) {
    auto cell = layer.begin();
    auto next = next_layer.begin();
    while (cell != layer.end() && next != next_layer.end()) {
        if (cell->place == next->place) {
            visit((cell++)->piece, (next++)->piece);
        } else if (cell->place < next->place) {
            ++cell;
        } else {
            ++next;
        }
    }
}

} // namespace

BorderLayer border_layer(std::span<const std::uint16_t> numbers) {
    BorderLayer layer;
    layer.reserve(numbers.size() -
                  static_cast<std::size_t>(std::ranges::count(numbers, std::uint16_t{0})));
    for (std::size_t place = 0; place < numbers.size(); ++place) {
        if (numbers[place] != 0) {
            layer.push_back({static_cast<std::uint16_t>(place), numbers[place]});
        }
    }
    return layer;
}

void PieceTracker::set_zone(const ZoneIndex& zone, ZoneSummary summary) {
    outdated_ = true;
    if (summary.pieces.empty()) {
        zones_.erase(zone);
    } else {
        zones_[zone] = std::move(summary);
    }
}

const std::vector<Object>& PieceTracker::objects() {
    if (!outdated_) {
        return objects_;
    }
    objects_.clear();
    for (const auto& component : components()) {
        objects_.push_back(describe(component));
    }
    std::ranges::sort(objects_, {}, &Object::id);
    outdated_ = false;
    return objects_;
}

std::vector<std::vector<PieceTracker::Member>> PieceTracker::components() const {
    std::map<ZoneIndex, std::size_t> first_piece;
    std::size_t count = 0;
    for (const auto& [zone, summary] : zones_) {
        first_piece.emplace_hint(first_piece.end(), zone, count);
        count += summary.pieces.size();
    }
    DisjointSets sets(count);
    for (const auto& [zone, summary] : zones_) {
        const std::array<ZoneIndex, 3> nexts{ZoneIndex{zone.x + 1, zone.y, zone.z},
                                             ZoneIndex{zone.x, zone.y + 1, zone.z},
                                             ZoneIndex{zone.x, zone.y, zone.z + 1}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto next = zones_.find(nexts[axis]);
            if (next == zones_.end()) {
                continue;
            }
            std::pair<std::uint16_t, std::uint16_t> joined{0, 0};
            for_each_contact(summary.last_layer[axis], next->second.first_layer[axis],
                             [&](std::uint16_t piece, std::uint16_t next_piece) {
                                 const std::pair both{piece, next_piece};
                                 if (both != joined) {
                                     sets.join(first_piece.at(zone) + piece - 1,
                                               first_piece.at(next->first) + next_piece - 1);
                                     joined = both;
                                 }
                             });
        }
    }
    std::map<std::size_t, std::vector<Member>> by_root;
    std::size_t number = 0;
    for (const auto& [zone, summary] : zones_) {
        for (const auto& piece : summary.pieces) {
            by_root[sets.root_of(number)].push_back({zone, &piece});
            ++number;
        }
    }
    std::vector<std::vector<Member>> components;
    components.reserve(by_root.size());
    for (auto& [root, members] : by_root) {
        components.push_back(std::move(members));
    }
    return components;
}

Object PieceTracker::describe(const std::vector<Member>& component) const {
    Object object = *component.front().piece;
    object.cell_count = 0;
    object.cell_sum = {};
    std::vector<ZoneTree<3>> octrees;
    std::vector<ZoneTree<2>> prisms;
    for (const auto& [zone, piece] : component) {
        object.id = std::min(object.id, piece->id);
        object.cell_count += piece->cell_count;
        object.box_min = least_of(object.box_min, piece->box_min);
        object.box_max = greatest_of(object.box_max, piece->box_max);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            object.cell_sum[axis] += piece->cell_sum[axis];
        }
        octrees.push_back({{zone.x, zone.y, zone.z}, piece->octree});
        prisms.push_back({{zone.x, zone.y}, piece->prism});
    }
    const TreeRoot octree = octree_root(object.box_min, object.box_max, zone_edge_);
    const TreeRoot prism = prism_root(object.box_min, object.box_max, zone_edge_);
    const ZoneIndex origin = zone_of(object.box_min, zone_edge_);
    object.octree = unite_zone_trees<3>(std::move(octrees), {origin.x, origin.y, origin.z},
                                        octree.edge / zone_edge_);
    object.prism =
        unite_zone_trees<2>(std::move(prisms), {origin.x, origin.y}, prism.edge / zone_edge_);
    return object;
}

} // namespace zonegrid
