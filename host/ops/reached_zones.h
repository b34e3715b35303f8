#pragma once

#include "model/rays.h"

#include <cstdint>
#include <vector>

namespace zonegrid::ops {

/// Places in the window of all zones that rays can enter, ascending; and a few more, since groups
/// of rays are bounded by boxes. A device must know before it draws which zones to hold.
[[nodiscard]] std::vector<std::uint32_t> reached_zones(const ImageRays& rays, const Window& window);
[[nodiscard]] std::vector<std::uint32_t> reached_zones(const ScanRays& scan, const Window& window);

} // namespace zonegrid::ops
