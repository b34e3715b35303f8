#pragma once

#include "simulation/shape.h"

#include <filesystem>

namespace zonegrid {

/// Which way a file's axes point; each is turned to forward, right, down.
enum class MeshAxes {
    z_up, ///< x forward, y left, z up
    y_up, ///< x right, y up, z backward
    forward_right_down
};

/// Reads the triangles of a mesh (PLY, OBJ; polygons are cut into triangles), in metres.
/// Throws InputError naming the file if it cannot be read or holds no triangle.
[[nodiscard]] Shape read_mesh_file(const std::filesystem::path& file, MeshAxes axes);

} // namespace zonegrid
