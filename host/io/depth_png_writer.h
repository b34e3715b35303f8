#pragma once

#include "io/depth_png.h"

#include <cstdint>
#include <vector>

namespace zonegrid {

/// Encodes a 16-bit grey image, quickly rather than small. Throws UsageError if `values` do not
/// fill the size.
[[nodiscard]] std::vector<std::uint8_t> encode_depth_png(const DepthPng& image);

} // namespace zonegrid
