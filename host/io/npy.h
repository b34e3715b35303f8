#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace zonegrid {

/// An array of float32 in C order: the last index runs fastest.
struct NpyArray {
    std::vector<std::size_t> shape;
    std::vector<float> values;
};

/// Reads NumPy's format, version 1 or 2: float32, little-endian, C order.
/// Throws InputError naming the file if it is another type, order or version, or if its length
/// does not fit its shape.
[[nodiscard]] NpyArray read_npy(const std::filesystem::path& file);

/// Writes the same, version 1. Throws OutputError if it cannot, UsageError if `values` do not fill
/// `shape`.
void write_npy(const std::filesystem::path& file, const NpyArray& array);

} // namespace zonegrid
