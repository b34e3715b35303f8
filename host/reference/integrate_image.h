#pragma once

#include "model/local_map.h"
#include "model/rays.h"

namespace zonegrid::reference {

/// Draws one depth image into a local map (docs/model.md, section 5): each pixel's sub-rays are
/// walked alone, cell by cell, in 32-bit integers.
///
/// `local_map` is empty and stands on the window that `rays` is relative to; on return it holds
/// ZG_STATEMENT_FREE and ZG_STATEMENT_OCCUPIED, occupied wherever any ray says so.
/// Cost: one step for every cell of every ray.
void integrate_image(const ImageRays& rays, LocalMap& local_map);

} // namespace zonegrid::reference
