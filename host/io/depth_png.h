#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace zonegrid {

/// The largest width and height of a depth image, in pixels.
inline constexpr int largest_image_px = 16384;

struct ImageSize {
    int width_px = 0;
    int height_px = 0;

    friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// A 16-bit grey image as it lies in the file, `[v][u]`.
struct DepthPng {
    ImageSize size;
    std::vector<std::uint16_t> values;
};

/// Decodes a PNG. Throws InputError naming the file if it is no PNG, not 16-bit grey (8-bit, RGB,
/// palette), larger than 16384 pixels a side, truncated or damaged anywhere.
[[nodiscard]] DepthPng read_depth_png(const std::filesystem::path& file);

/// The same checks for the header alone: the size without decoding pixels.
[[nodiscard]] ImageSize read_depth_png_size(const std::filesystem::path& file);

} // namespace zonegrid
