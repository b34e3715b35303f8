#pragma once

#include "io/seeded_numbers.h"
#include "simulation/shape.h"

namespace zonegrid {

enum class Species { broadleaf, conifer };

/// How finely a plant is made: near ones are looked at, forests are counted in thousands.
enum class Detail { coarse, fine };

struct TreeSize {
    Species species = Species::broadleaf;
    double height_m = 8.0;
    double crown_diameter_m = 4.5; ///< nowhere is the crown wider
    double crown_base_m = 2.4;     ///< height of the crown's lowest point, below height_m
    double trunk_diameter_m = 0.35;
};

/// A trunk and a crown of irregular outline. The trunk reaches 0.3 m into the ground.
[[nodiscard]] Shape tree_shape(const TreeSize& size, Detail detail, SeededNumbers& numbers);

/// An irregular round bush that reaches 0.1 m into the ground.
[[nodiscard]] Shape bush_shape(double height_m, double diameter_m, SeededNumbers& numbers);

} // namespace zonegrid
