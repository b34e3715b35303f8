#include "io/profile_perspective_view.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace zonegrid {
namespace {

constexpr double rad_per_deg = 0.017453292519943295;

/// Share of the tiles whose tops are seen from a direction, from a sample of at most 40 x 40, each
/// followed towards the camera in steps of a tile until it is clear of everything.
double seen_share(const TileGrid& tiles, const SceneBox& box, double azimuth_deg,
                  double elevation_deg) {
    const double rise = std::tan(elevation_deg * rad_per_deg) / box.exaggeration;
    const double to_north = std::cos(azimuth_deg * rad_per_deg);
    const double to_east = std::sin(azimuth_deg * rad_per_deg);
    const int stride = std::max(1, std::max(tiles.north_count(), tiles.east_count()) / 40);
    const double longest_m = tiles.tile_m() * std::hypot(tiles.north_count(), tiles.east_count());
    int seen = 0;
    int all = 0;
    for (int i = stride / 2; i < tiles.north_count(); i += stride) {
        for (int j = stride / 2; j < tiles.east_count(); j += stride) {
            const double own_m = tiles.top_m(i, j);
            if (std::isnan(own_m)) {
                continue;
            }
            const double north_m = tiles.north_m(i) + 0.5 * tiles.tile_m();
            const double east_m = tiles.east_m(j) + 0.5 * tiles.tile_m();
            const double step_m = tiles.tile_m() * std::max(1.0, 0.25 * stride);
            bool hidden = false;
            for (double way_m = step_m;
                 way_m < longest_m && own_m + way_m * rise < box.top_m && !hidden;
                 way_m += step_m) {
                // Comparisons with NaN are false: unknown tiles hide nothing.
                hidden = tiles.top_at_m(north_m + way_m * to_north, east_m + way_m * to_east) >
                         own_m + way_m * rise;
            }
            ++all;
            seen += hidden ? 0 : 1;
        }
    }
    return all == 0 ? 1.0 : static_cast<double>(seen) / all;
}

} // namespace

PerspectiveView::PerspectiveView(const SceneBox& box, const PictureFrame& frame, double azimuth_deg,
                                 double elevation_deg)
    : exaggeration_(box.exaggeration), azimuth_deg_(azimuth_deg), elevation_deg_(elevation_deg) {
    const double azimuth = azimuth_deg * rad_per_deg;
    const double elevation = elevation_deg * rad_per_deg;
    const Eigen::Vector3d least(box.plan.north_min_m, box.plan.east_min_m,
                                box.base_m * exaggeration_);
    const Eigen::Vector3d most(box.plan.north_max_m, box.plan.east_max_m,
                               box.top_m * exaggeration_);
    const Eigen::Vector3d middle = 0.5 * (least + most);
    const Eigen::Vector3d to_eye(std::cos(azimuth) * std::cos(elevation),
                                 std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
    // Far enough that verticals stay nearly parallel, near enough to look like a view.
    distance_m_ = 2.4 * (most - least).norm();
    drawn_eye_m_ = middle + distance_m_ * to_eye;
    eye_m_ = drawn_eye_m_;
    eye_m_.z() /= exaggeration_;
    forward_ = -to_eye;
    right_ = Eigen::Vector3d(std::sin(azimuth), -std::cos(azimuth), 0.0);
    // In (north, east, up), a left-handed triple, up is forward x right.
    up_ = forward_.cross(right_);

    Eigen::AlignedBox2d seen;
    for (int corner = 0; corner < 8; ++corner) {
        const auto pick = [&](int axis) {
            return (corner >> axis) % 2 == 0 ? least[axis] : most[axis];
        };
        const SeenPoint place = project(pick(0), pick(1), pick(2) / exaggeration_);
        seen.extend(Eigen::Vector2d(place.x_px, place.y_px));
    }
    const double unit = frame.top_px / 78.0;
    const double room_px = 46.0 * unit; // for the axes' numbers and labels
    scale_px_ = std::min((frame.width_px - 2.0 * room_px) / seen.sizes().x(),
                         (frame.height_px - 1.4 * room_px) / seen.sizes().y());
    offset_px_ = Eigen::Vector2d(frame.left_px + 0.5 * frame.width_px,
                                 frame.top_px + 0.5 * frame.height_px - 0.3 * room_px) -
                 scale_px_ * seen.center();
    px_per_m_ = scale_px_ / distance_m_;
}

SeenPoint PerspectiveView::project(double north_m, double east_m, double height_m) const {
    const Eigen::Vector3d ray =
        Eigen::Vector3d(north_m, east_m, height_m * exaggeration_) - drawn_eye_m_;
    const double inverse_depth = 1.0 / forward_.dot(ray);
    return {offset_px_.x() + scale_px_ * right_.dot(ray) * inverse_depth,
            offset_px_.y() - scale_px_ * up_.dot(ray) * inverse_depth, inverse_depth};
}

PerspectiveView choose_view(const SceneBox& box, const PictureFrame& frame, const TileGrid& tiles) {
    std::optional<PerspectiveView> best;
    double best_score = 0.0;
    // From the south-west first; views straight along an axis would hide two sides of each block.
    for (const double elevation_deg : {35.0, 45.0, 55.0}) {
        for (const double azimuth_deg :
             {215.0, 235.0, 205.0, 245.0, 145.0, 125.0, 155.0, 115.0, 305.0, 325.0, 35.0, 55.0}) {
            const PerspectiveView view(box, frame, azimuth_deg, elevation_deg);
            // All else equal, east lies to the right and north at the back, as on a map.
            const double like_map = 1.0 + 0.12 * std::cos((azimuth_deg - 205.0) * rad_per_deg);
            const double seen = seen_share(tiles, box, azimuth_deg, elevation_deg);
            const double score =
                seen * std::sqrt(view.px_per_m()) * like_map * (1.35 - 0.01 * elevation_deg);
            if (!best || score > 1.01 * best_score) {
                best = view;
                best_score = score;
            }
        }
    }
    return *best;
}

} // namespace zonegrid
