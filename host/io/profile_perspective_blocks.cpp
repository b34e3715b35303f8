#include "io/profile_perspective_blocks.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

/// Enters the faces of blocks, as one view sees and one light lights them.
class BlockFiller {
public:
    BlockFiller(BlockRaster& raster, const TileGrid& tiles, const PerspectiveView& view,
                const SceneBox& box)
        : raster_(raster), tiles_(tiles), view_(view), exaggeration_(box.exaggeration) {
        // From above, over the viewer's left shoulder.
        const Eigen::Vector3d toward_eye(
            view.eye_m().x() - 0.5 * (box.plan.north_min_m + box.plan.north_max_m),
            view.eye_m().y() - 0.5 * (box.plan.east_min_m + box.plan.east_max_m), 0.0);
        light_ = (-0.55 * view.right() + 0.80 * toward_eye.normalized() +
                  1.25 * Eigen::Vector3d::UnitZ())
                     .normalized();
    }

    void fill(int i, int j) {
        const double own_m = tiles_.top_m(i, j);
        if (std::isnan(own_m)) {
            return;
        }
        const double south_m = tiles_.north_m(i);
        const double north_m = tiles_.north_m(i + 1);
        const double west_m = tiles_.east_m(j);
        const double east_m = tiles_.east_m(j + 1);
        raster_.fill_quad({corner(south_m, west_m, own_m), corner(south_m, east_m, own_m),
                           corner(north_m, east_m, own_m), corner(north_m, west_m, own_m)},
                          top_brightness(i, j, own_m));
        const Eigen::Vector3d& eye_m = view_.eye_m();
        if (eye_m.x() < south_m) {
            fill_side(south_m, west_m, south_m, east_m, own_m, foot_m(i, j, i - 1, j, own_m),
                      brightness(-Eigen::Vector3d::UnitX()));
        } else if (eye_m.x() > north_m) {
            fill_side(north_m, west_m, north_m, east_m, own_m, foot_m(i, j, i + 1, j, own_m),
                      brightness(Eigen::Vector3d::UnitX()));
        }
        if (eye_m.y() < west_m) {
            fill_side(south_m, west_m, north_m, west_m, own_m, foot_m(i, j, i, j - 1, own_m),
                      brightness(-Eigen::Vector3d::UnitY()));
        } else if (eye_m.y() > east_m) {
            fill_side(south_m, east_m, north_m, east_m, own_m, foot_m(i, j, i, j + 1, own_m),
                      brightness(Eigen::Vector3d::UnitY()));
        }
    }

private:
    [[nodiscard]] RasterCorner corner(double north_m, double east_m, double height_m) const {
        const SeenPoint seen = view_.project(north_m, east_m, height_m);
        return {seen.x_px * raster_.samples(), seen.y_px * raster_.samples(), seen.inverse_depth,
                height_m};
    }

    void fill_side(double north0_m, double east0_m, double north1_m, double east1_m, double own_m,
                   double foot_m, double side_brightness) {
        if (foot_m < own_m) {
            raster_.fill_quad(
                {corner(north0_m, east0_m, own_m), corner(north1_m, east1_m, own_m),
                 corner(north1_m, east1_m, foot_m), corner(north0_m, east0_m, foot_m)},
                side_brightness);
        }
    }

    /// How far the side towards a neighbour reaches down.
    [[nodiscard]] double foot_m(int i, int j, int there_i, int there_j, double own_m) const {
        const double there_m = tiles_.top_m(there_i, there_j);
        return std::isnan(there_m) ? std::min(tiles_.ground_m(i, j), own_m - tiles_.tile_m())
                                   : there_m;
    }

    /// 1 for a face square to the light's fall on level ground, less for others.
    [[nodiscard]] double brightness(const Eigen::Vector3d& normal) const {
        constexpr double ambient = 0.52;
        return ambient + (1.0 - ambient) * std::max(0.0, normal.dot(light_)) / light_.z();
    }

    /// Tops are lit as a surface through their neighbours, so that slopes and crowns show.
    [[nodiscard]] double top_brightness(int i, int j, double own_m) const {
        const auto known = [&](int there_i, int there_j) {
            const double there_m = tiles_.top_m(there_i, there_j);
            return std::isnan(there_m) ? own_m : there_m;
        };
        const double per_m = exaggeration_ / (2.0 * tiles_.tile_m());
        const double rise_north = (known(i + 1, j) - known(i - 1, j)) * per_m;
        const double rise_east = (known(i, j + 1) - known(i, j - 1)) * per_m;
        // Steps of one cell are steep at any cell size; damped, they leave room for true slopes.
        const double damping = 0.5 / (1.0 + 0.5 * std::hypot(rise_north, rise_east));
        const Eigen::Vector3d normal(-damping * rise_north, -damping * rise_east, 1.0);
        return std::min(1.15, brightness(normal.normalized()));
    }

    BlockRaster& raster_;
    const TileGrid& tiles_;
    const PerspectiveView& view_;
    double exaggeration_;
    Eigen::Vector3d light_;
};

} // namespace

void fill_blocks(BlockRaster& raster, const TileGrid& tiles, const PerspectiveView& view,
                 const SceneBox& box) {
    BlockFiller filler(raster, tiles, view, box);
    for (int i = 0; i < tiles.north_count(); ++i) {
        for (int j = 0; j < tiles.east_count(); ++j) {
            filler.fill(i, j);
        }
    }
}

} // namespace zonegrid
