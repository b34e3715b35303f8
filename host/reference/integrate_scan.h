#pragma once

#include "model/local_map.h"
#include "model/rays.h"

namespace zonegrid::reference {

/// Draws one scan into a local map (docs/model.md, section 5): every ray frees its cells, and
/// occupies the cell of its end if it hit something.
///
/// `local_map` is empty and stands on the window that `scan` is relative to.
void integrate_scan(const ScanRays& scan, LocalMap& local_map);

} // namespace zonegrid::reference
