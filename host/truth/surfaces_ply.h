#pragma once

#include "truth/surfaces.h"

#include <filesystem>

namespace zonegrid {

/// Writes vertices and triangles, in their order, as binary little-endian PLY, which MeshLab and
/// CloudCompare open. The obstacles are not in it. Throws OutputError.
void write_surfaces_ply(const std::filesystem::path& file, const Surfaces& surfaces);

/// Reads exactly what `write_surfaces_ply` writes, bit for bit; `obstacles` stays empty. General
/// readers of PLY may merge or reorder vertices and triangles, which would lose the obstacles.
/// Throws InputError naming the file if its header, its size or a face is different.
[[nodiscard]] Surfaces read_surfaces_ply(const std::filesystem::path& file);

} // namespace zonegrid
