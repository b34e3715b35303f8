#include "pipeline/object_tracker.h"

#include "reference/encode_octree.h"
#include "reference/encode_prism.h"
#include "reference/measure_objects.h"

#include <algorithm>
#include <utility>

namespace zonegrid {

void ObjectTracker::set_zone(const ZoneIndex& zone, const ZoneBits& occupied) {
    changed_.insert(zone);
    if (occupied.any()) {
        zones_[zone] = reference::label_zone(occupied, zone_edge_);
    } else {
        zones_.erase(zone);
    }
}

const std::vector<Object>& ObjectTracker::objects() {
    if (changed_.empty()) {
        return objects_;
    }
    objects_.clear();
    std::map<Component, Object> described;
    for (auto& component : reference::join_pieces(zones_)) {
        // The same pieces of unchanged zones are the same cells.
        const auto known = is_unchanged(component) ? described_.find(component) : described_.end();
        Object object = known != described_.end() ? std::move(known->second) : describe(component);
        objects_.push_back(object);
        described.emplace(std::move(component), std::move(object));
    }
    described_ = std::move(described);
    std::ranges::sort(objects_, {}, &Object::id);
    changed_.clear();
    return objects_;
}

bool ObjectTracker::is_unchanged(const Component& component) const {
    return std::ranges::none_of(
        component, [this](const auto& piece) { return changed_.contains(piece.zone); });
}

Object ObjectTracker::describe(const Component& component) const {
    std::size_t cell_count = 0;
    for (const auto& [zone, piece] : component) {
        cell_count += zones_.at(zone).pieces[piece].size();
    }
    std::vector<CellIndex> cells;
    cells.reserve(cell_count);
    for (const auto& [zone, piece] : component) {
        for (const auto index : zones_.at(zone).pieces[piece]) {
            cells.push_back(cell_at(zone, index, zone_edge_));
        }
    }
    Object object = reference::measure_object(cells);
    object.octree =
        reference::encode_octree(cells, octree_root(object.box_min, object.box_max, zone_edge_));
    object.prism =
        reference::encode_prism(cells, prism_root(object.box_min, object.box_max, zone_edge_));
    return object;
}

} // namespace zonegrid
