#pragma once

#include "zonegrid/sensors.h"

#include <Eigen/Geometry>

#include <vector>

namespace zonegrid::bench {

/// What a camera sees of a field with trees: made by formula, the same on every machine.
struct FieldScene {
    Camera camera;              ///< 640 x 480 pixels, 51 x 40 degrees, ideal pinhole
    std::vector<float> depth_m; ///< `[v][u]`, metres along the optical axis; +infinity for sky
    Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
};

/// One image from 8 m over a level field with twelve trees between 9 and 39 m ahead, pitched 10
/// degrees down: ground, trunks, crowns, and sky in the upper quarter. Meant for a range of 40 m.
/// Every ray is cast against the plane, the trunks (upright cylinders) and the crowns (spheres).
[[nodiscard]] FieldScene make_field_scene();

} // namespace zonegrid::bench
