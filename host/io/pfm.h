#pragma once

#include "io/depth_png.h"

#include <filesystem>
#include <vector>

namespace zonegrid {

/// A grey float image, `[v][u]` with the top row first.
struct PfmImage {
    ImageSize size;
    std::vector<float> values;
};

/// Reads a portable float map ("Pf"), little- or big-endian. Of its scale only the sign counts,
/// which gives the byte order. Throws InputError naming the file if it is a colour map, malformed,
/// larger than 16384 pixels a side, or of a length that does not fit its size.
[[nodiscard]] PfmImage read_pfm(const std::filesystem::path& file);

} // namespace zonegrid
