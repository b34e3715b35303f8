#include "pipeline/feature_map.h"

#include "reference/encode_octree.h"

namespace zonegrid {

void FeatureMap::remember(const ZoneIndex& zone, std::span<const CellIndex> cells) {
    if (cells.empty()) {
        zones_.erase(zone);
        return;
    }
    const TreeRoot root{first_cell_of(zone, zone_edge_), zone_edge_};
    zones_[zone] = reference::encode_octree(cells, root);
}

std::vector<CellIndex> FeatureMap::take(const ZoneIndex& zone) {
    auto known = cells(zone);
    zones_.erase(zone);
    return known;
}

std::vector<ZoneIndex> FeatureMap::zones_in(const Window& window) const {
    std::vector<ZoneIndex> found;
    for (const auto& [zone, octree] : zones_) {
        if (window.holds(zone)) {
            found.push_back(zone);
        }
    }
    return found;
}

std::vector<CellIndex> FeatureMap::cells(const ZoneIndex& zone) const {
    const auto known = zones_.find(zone);
    if (known == zones_.end()) {
        return {};
    }
    const TreeRoot root{first_cell_of(zone, zone_edge_), zone_edge_};
    return reference::decode_octree(known->second, root);
}

} // namespace zonegrid
