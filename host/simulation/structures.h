#pragma once

#include "simulation/shape.h"

#include <span>

namespace zonegrid {

enum class Roof { flat, gable };

struct BuildingSize {
    double length_m = 12.0; ///< forward; the gable's ridge runs along it
    double width_m = 8.0;
    double eaves_m = 6.0; ///< height of the walls
    double ridge_m = 9.0; ///< height of a gable's ridge, above eaves_m
    Roof roof = Roof::flat;
    double foundation_m = 0.2; ///< how far the walls reach into the ground
};

[[nodiscard]] Shape building_shape(const BuildingSize& size);

/// A round pole that tapers to half its diameter.
[[nodiscard]] Shape pole_shape(double height_m, double diameter_m);

/// Four legs with cross-pieces and diagonals, square, each bar a closed box or tube of its own.
[[nodiscard]] Shape lattice_mast_shape(double height_m, double width_m);

/// A wire that hangs as a catenary between two points of any frame whose z is down. `sag_m`, above
/// 0, is how far it hangs below the straight line in the middle.
[[nodiscard]] Shape wire_shape(const Eigen::Vector3d& start_m, const Eigen::Vector3d& end_m,
                               double sag_m, double diameter_m);

/// A round tunnel of the given inner diameter and wall along a way of at least two points.
[[nodiscard]] Shape tunnel_shape(std::span<const Eigen::Vector3d> way_m, double diameter_m,
                                 double wall_m);

} // namespace zonegrid
