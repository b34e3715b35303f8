#pragma once

#include "model/fusion.h"
#include "model/local_map.h"
#include "model/view.h"
#include "model/zoned_cells.h"

namespace zonegrid::reference {

/// Adds a local map to the grid, saturating (docs/model.md, section 7). Both stand on the same
/// window; `view` is of the local map's image. Cost: one pass over the zones that the image says
/// something of.
FusionResult fuse_local_map(const LocalMap& local_map, const View& view, const FusionRule& rule,
                            Grid& grid);

} // namespace zonegrid::reference
