#pragma once

#include "support/scenes.h"

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

namespace zonegrid {

/// A camera that looks north at a wall 10 m ahead, and flies about. Cells of 1 m, range 12 m, zones
/// of 8 cells; the window is 6 zones wide (reach 14), at first zones -2 .. 3 on each axis.
///
/// The wall as seen from `home_m`: cell x = 10, y = -5 .. 5, z = -3 .. 3.
class WallFlight {
public:
    WallFlight() : mapper_(options(), camera()) {}

    static MapperOptions options() {
        MapperOptions options;
        options.range_m = 12.0;
        options.zone = 8;
        options.limit = 8; // so that values between threshold and limit can be told apart
        return options;
    }
    static Camera camera() { return scenes::forward_camera(16, 12, 16.0); }
    static std::vector<CellIndex> wall_cells() {
        return scenes::box_of_cells({10, -5, -3}, {10, 5, 3});
    }

    ImageResult see_wall() { return show(home_m, scenes::flat_image(camera(), 10.0F)); }
    /// A smaller wall in the middle of the image, so that from `home_m` the cells are seen whole:
    /// x = 10, y = -2 .. 2, z = -2 .. 2.
    ImageResult see_panel() {
        auto depth_m = scenes::flat_image(camera(), std::numeric_limits<float>::infinity());
        for (std::size_t v_px = 3; v_px < 9; ++v_px) {
            std::fill_n(depth_m.begin() + static_cast<std::ptrdiff_t>(16 * v_px + 4), 8, 10.0F);
        }
        return show(home_m, depth_m);
    }
    ImageResult see_sky(const Eigen::Vector3d& position_m) {
        return show(position_m,
                    scenes::flat_image(camera(), std::numeric_limits<float>::infinity()));
    }
    /// Moves without seeing anything.
    ImageResult fly_to(const Eigen::Vector3d& position_m) {
        return show(position_m, scenes::blind_image(camera()));
    }

    [[nodiscard]] Mapper& mapper() { return mapper_; }

    inline static const Eigen::Vector3d home_m{0.5, 0.5, 0.5};
    inline static const Eigen::Vector3d far_away_m{-300.0, 0.5, 0.5};
    /// The window's zones on y begin at 0 here: it holds the wall's right part only.
    inline static const Eigen::Vector3d beside_m{0.5, 26.5, 0.5};

private:
    ImageResult show(const Eigen::Vector3d& position_m, const std::vector<float>& depth_m) {
        time_s_ += 0.1;
        return scenes::show(mapper_, time_s_, position_m, depth_m);
    }

    double time_s_ = 0.0;
    Mapper mapper_;
};

} // namespace zonegrid
