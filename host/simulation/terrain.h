#pragma once

#include "simulation/shape.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace zonegrid {

/// Hills from noise: octaves of smooth noise, each of half the wavelength and half the height.
struct HillNoise {
    double relief_m = 10.0; ///< all heights are within +- relief_m / 2
    double wavelength_m = 200.0;
    int octaves = 3;
    std::uint64_t seed = 0;
};

/// Heights over a rectangle, `[row][column]`, rows to the north, columns to the east.
struct HeightGrid {
    Eigen::Vector2d least_m = Eigen::Vector2d::Zero(); ///< north and east of the first value
    Eigen::Vector2d most_m = Eigen::Vector2d::Zero();  ///< and of the last
    std::size_t rows = 0;                              ///< at least 2
    std::size_t columns = 0;                           ///< at least 2
    std::vector<float> heights_m;                      ///< up
};

/// The ground's surface as a function of the place: triangles over a grid of nodes.
class Terrain {
public:
    /// Flat, at height 0. The nodes' distance is that of the triangles it is drawn with.
    explicit Terrain(double spacing_m);
    /// Nodes at multiples of `spacing_m`, without end.
    Terrain(double spacing_m, const HillNoise& noise);
    /// The grid's values are the nodes; beyond its edge the height is that of the edge.
    explicit Terrain(HeightGrid grid);

    /// Height above 0, up, of the very triangle that `ground_shape` draws at this place.
    [[nodiscard]] double height_m(double north_m, double east_m) const;

    /// The triangles, which face up, of the smallest grid of nodes that covers the rectangle; of
    /// given heights the whole grid. World frame. One sheet, not closed.
    [[nodiscard]] Shape ground_shape(const Eigen::Vector2d& least_m,
                                     const Eigen::Vector2d& most_m) const;

    /// About how many nodes `ground_shape` draws.
    [[nodiscard]] double nodes_over(const Eigen::Vector2d& least_m,
                                    const Eigen::Vector2d& most_m) const;

private:
    [[nodiscard]] double node_height_m(long row, long column) const;

    Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero(); ///< of node (0, 0)
    Eigen::Vector2d spacing_m_;
    std::optional<HillNoise> noise_;
    std::optional<HeightGrid> grid_;
};

} // namespace zonegrid
