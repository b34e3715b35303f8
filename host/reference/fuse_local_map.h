#pragma once

#include "model/fusion.h"
#include "model/local_map.h"
#include "model/zoned_cells.h"

#include <cstdint>
#include <vector>

namespace zonegrid::reference {

struct FusionResult {
    std::uint64_t cells_changed = 0;
    /// Places of zones in which a cell became occupied or ceased to be, ascending.
    std::vector<std::uint32_t> occupancy_changed;
};

/// Adds a local map to the grid, saturating (docs/model.md, section 7). Both stand on the same
/// window. Cost: one pass over the zones that the image says something of.
FusionResult fuse_local_map(const LocalMap& local_map, const FusionRule& rule, Grid& grid);

} // namespace zonegrid::reference
