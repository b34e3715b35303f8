#pragma once

#include "io/profile_perspective_view.h"
#include "io/profile_picture_canvas.h"

namespace zonegrid {

/// The floor at the base height with a grid at the ticks; drawn before the blocks.
void draw_floor(Canvas& canvas, const PerspectiveView& view, const SceneBox& box);

/// Ticks and labels along the two near edges of the floor and up one corner; drawn last.
void draw_box_axes(Canvas& canvas, const PerspectiveView& view, const SceneBox& box);

} // namespace zonegrid
