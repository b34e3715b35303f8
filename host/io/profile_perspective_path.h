#pragma once

#include "io/profile_perspective_grid.h"
#include "io/profile_perspective_raster.h"
#include "io/profile_perspective_view.h"
#include "io/profile_picture_canvas.h"

#include <Eigen/Core>

#include <span>

namespace zonegrid {

/// Draws the trajectory at its true height, faint where the raster hides it, with lines dropped
/// from start and end to the column or floor below, and the heights written beside. Nothing if no
/// point is drawable.
void draw_path(Canvas& canvas, const PerspectiveView& view, const BlockRaster& raster,
               const TileGrid& tiles, const SceneBox& box,
               std::span<const Eigen::Vector3d> trajectory_m);

} // namespace zonegrid
