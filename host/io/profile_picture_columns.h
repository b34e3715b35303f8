#pragma once

#include "io/profile_picture_canvas.h"
#include "io/profile_picture_layout.h"

namespace zonegrid {

/// Colours the frame's pixels with the columns as seen from above, lit from the north-west. Pixels
/// without a column keep what they had. Cost: linear in columns and pixels.
void draw_columns(Canvas& canvas, const ProfileLayout& layout, const HeightProfile& profile,
                  const HeightRange& range);

} // namespace zonegrid
