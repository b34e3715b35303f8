#pragma once

#include "model/lattice.h"

#include <cstdint>

namespace zonegrid {

/// Root of an object's octree or quadtree (docs/model.md, sections 8.4 and 8.5): a cube at a zone's
/// first cell, its edge the zone's times a power of two.
struct TreeRoot {
    CellIndex origin;
    std::int32_t edge = 0;
};

/// Root of the octree over the box `box_min` .. `box_max` (inclusive).
[[nodiscard]] inline TreeRoot octree_root(const CellIndex& box_min, const CellIndex& box_max,
                                          std::int32_t zone_edge) {
    TreeRoot root{first_cell_of(zone_of(box_min, zone_edge), zone_edge), zone_edge};
    while (box_max.x - root.origin.x >= root.edge || box_max.y - root.origin.y >= root.edge ||
           box_max.z - root.origin.z >= root.edge) {
        root.edge *= 2;
    }
    return root;
}

/// Root of the quadtree of the ground plan; its z is not used.
[[nodiscard]] inline TreeRoot prism_root(const CellIndex& box_min, const CellIndex& box_max,
                                         std::int32_t zone_edge) {
    return octree_root({box_min.x, box_min.y, 0}, {box_max.x, box_max.y, 0}, zone_edge);
}

/// Two bits a child: how much of it belongs to the object.
enum class ChildState : std::uint8_t { none = 0, all = 1, some = 2 };

} // namespace zonegrid
