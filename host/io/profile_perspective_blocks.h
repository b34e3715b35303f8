#pragma once

#include "io/profile_perspective_grid.h"
#include "io/profile_perspective_raster.h"
#include "io/profile_perspective_view.h"

namespace zonegrid {

/// Enters the visible faces of all tiles, each a block from its top down to its neighbours' tops.
/// Cost: linear in the tiles and in the samples they cover.
void fill_blocks(BlockRaster& raster, const TileGrid& tiles, const PerspectiveView& view,
                 const SceneBox& box);

} // namespace zonegrid
