#include "pipeline/object_tracker.h"

#include "reference/encode_octree.h"
#include "reference/encode_prism.h"
#include "reference/measure_objects.h"

#include <algorithm>

namespace zonegrid {

void ObjectTracker::set_zone(const ZoneIndex& zone, const ZoneBits& occupied) {
    stale_ = true;
    if (occupied.any()) {
        zones_[zone] = reference::label_zone(occupied, zone_edge_);
    } else {
        zones_.erase(zone);
    }
}

const std::vector<Object>& ObjectTracker::objects() {
    if (stale_) {
        objects_.clear();
        for (const auto& component : reference::join_pieces(zones_)) {
            objects_.push_back(describe(component));
        }
        std::ranges::sort(objects_, {}, &Object::id);
        stale_ = false;
    }
    return objects_;
}

Object ObjectTracker::describe(const std::vector<reference::PieceReference>& component) const {
    std::vector<CellIndex> cells;
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
