#include "evaluation/true_view.h"

#include "truth/ray_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace zonegrid {
namespace {

/// Rays that are followed for each surface point looked at, an axis: surfaces seen at a slant need
/// denser rays than free space does.
constexpr int surface_rays = 4;

constexpr double most_steps = 2e9;  ///< of rays through cells, all images together
constexpr double least_images = 40; ///< whatever that takes
constexpr double most_images = 600;

/// The camera with only every `stride`-th pixel an axis, from the middle of the first stride on.
Camera thinned(const Camera& camera, int stride) {
    Camera thin = camera;
    const double offset = 0.5 * (stride - 1);
    thin.width_px = std::max(1, camera.width_px / stride);
    thin.height_px = std::max(1, camera.height_px / stride);
    thin.fx_px = camera.fx_px / stride;
    thin.fy_px = camera.fy_px / stride;
    thin.cx_px = (camera.cx_px - offset) / stride;
    thin.cy_px = (camera.cy_px - offset) / stride;
    return thin;
}

/// Calls `visit` for each cell on the straight way from `start` to `end`, in cells, both included.
///
/// Source: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
/// Eurographics 1987; in double, so not the mapper's own lattice.
template <class Visit>
void follow(const Eigen::Vector3d& start, const Eigen::Vector3d& end, Visit&& visit) {
    std::array<std::int32_t, 3> cell{};
    std::array<std::int32_t, 3> step{};
    std::array<double, 3> next{};  ///< share of the way at which the next border lies
    std::array<double, 3> width{}; ///< share of the way from border to border
    std::int64_t steps = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const double way = end[i] - start[i];
        const double first = std::floor(start[i]);
        cell[axis] = static_cast<std::int32_t>(first);
        steps += std::abs(static_cast<std::int64_t>(std::floor(end[i])) - cell[axis]);
        step[axis] = way > 0.0 ? 1 : -1;
        width[axis] = way == 0.0 ? std::numeric_limits<double>::infinity() : 1.0 / std::abs(way);
        next[axis] = way == 0.0
                         ? std::numeric_limits<double>::infinity()
                         : (way > 0.0 ? first + 1.0 - start[i] : start[i] - first) * width[axis];
    }
    visit(CellIndex{cell[0], cell[1], cell[2]});
    for (; steps > 0; --steps) {
        const std::size_t axis =
            next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
        cell[axis] += step[axis];
        next[axis] += width[axis];
        visit(CellIndex{cell[0], cell[1], cell[2]});
    }
}

class Look {
public:
    Look(const Truth& truth, const TouchedCells& touched, const TrueImageDrawer& draw,
         const TrueViewOptions& options)
        : truth_(truth),
          touched_(touched),
          draw_(draw),
          options_(options),
          stride_(pixel_stride(truth.camera, options.cell_m, options.range_m)),
          surface_stride_(std::max(1, stride_ / surface_rays)),
          camera_(thinned(truth.camera, surface_stride_)),
          depth_m_(static_cast<std::size_t>(camera_.width_px) *
                   static_cast<std::size_t>(camera_.height_px)),
          obstacles_(depth_m_.size()) {
        view_.surface_of.resize(truth.surfaces.obstacles.size());
        view_.first_sight.resize(truth.surfaces.obstacles.size());
    }

    void draw(std::size_t image) { draw_(camera_, truth_.images[image], depth_m_, obstacles_); }

    /// Follows the rays of the image that was drawn last.
    void look_from(std::size_t image) {
        const TrueImage& from = truth_.images[image];
        const Eigen::Vector3d start = from.world_from_camera.translation() / options_.cell_m;
        const int every_ray = stride_ / surface_stride_;
        for (int v = 0; v < camera_.height_px; ++v) {
            for (int u = 0; u < camera_.width_px; ++u) {
                const bool followed =
                    u % every_ray == every_ray / 2 && v % every_ray == every_ray / 2;
                take_ray(from, start, u, v, followed);
            }
        }
        ++view_.images;
    }

    /// Notes which obstacles the image that was drawn last is the first to show; returns whether
    /// there were any.
    bool note_sights(std::size_t image) {
        bool any = false;
        for (std::size_t pixel = 0; pixel < depth_m_.size(); ++pixel) {
            const std::uint32_t obstacle = obstacles_[pixel];
            if (obstacle == sky_obstacle) {
                continue;
            }
            const double distance_m = distance_of(pixel);
            if (distance_m > options_.range_m) {
                continue;
            }
            auto& sight = view_.first_sight[obstacle];
            if (!sight || image < sight->image) {
                sight = FirstSight{image, distance_m};
                any = true;
            } else if (image == sight->image) {
                sight->distance_m = std::min(sight->distance_m, distance_m);
            }
        }
        return any;
    }

    TrueView take() {
        CellSet free;
        view_.free.for_each([&](const CellIndex& cell) {
            if (!touched_.all().contains(cell)) {
                free.insert(cell);
            }
        });
        view_.free = std::move(free);
        return std::move(view_);
    }

private:
    /// In the camera frame, of length 1 along the optical axis.
    [[nodiscard]] Eigen::Vector3d slope_of(int u, int v) const {
        return {(u - camera_.cx_px) / camera_.fx_px, (v - camera_.cy_px) / camera_.fy_px, 1.0};
    }

    [[nodiscard]] double distance_of(std::size_t pixel) const {
        const auto width = static_cast<std::size_t>(camera_.width_px);
        return static_cast<double>(depth_m_[pixel]) *
               slope_of(static_cast<int>(pixel % width), static_cast<int>(pixel / width)).norm();
    }

    void take_ray(const TrueImage& from, const Eigen::Vector3d& start, int u, int v,
                  bool followed) {
        const auto pixel =
            static_cast<std::size_t>(v) * static_cast<std::size_t>(camera_.width_px) +
            static_cast<std::size_t>(u);
        const Eigen::Vector3d slope = slope_of(u, v);
        const double length = slope.norm();
        const double most_depth_m = options_.range_m / length;
        const bool ends = obstacles_[pixel] != sky_obstacle &&
                          static_cast<double>(depth_m_[pixel]) <= most_depth_m;
        if (!ends && !followed) {
            return;
        }
        const double depth_m = ends ? static_cast<double>(depth_m_[pixel]) : most_depth_m;
        const Eigen::Vector3d end = from.world_from_camera * (slope * depth_m) / options_.cell_m;
        if (followed) {
            const CellIndex last = cell_at_m(end, 1.0);
            follow(start, end, [&](const CellIndex& cell) {
                if (!ends || cell != last) {
                    view_.free.insert(cell);
                }
            });
        }
        if (ends) {
            take_hit(obstacles_[pixel], end);
        }
    }

    /// A hit may be a rounding error away from the cells of its surface, where that lies on a
    /// border.
    void take_hit(std::uint32_t obstacle, const Eigen::Vector3d& end) {
        if (truth_.surfaces.obstacles[obstacle].moving) {
            return;
        }
        ++view_.hits;
        const double slack = std::max(1e-3, 1e-3 / options_.cell_m);
        const CellSet& cells = touched_.of(obstacle);
        for (const double sign : {0.0, 1.0, -1.0}) {
            for (int axis = 0; axis < (sign == 0.0 ? 1 : 3); ++axis) {
                const CellIndex cell =
                    cell_at_m(end + sign * slack * Eigen::Vector3d::Unit(axis), 1.0);
                if (cells.contains(cell)) {
                    view_.surface.insert(cell);
                    view_.surface_of[obstacle].insert(cell);
                    return;
                }
            }
        }
        ++view_.unplaced_hits;
    }

    const Truth& truth_;
    const TouchedCells& touched_;
    const TrueImageDrawer& draw_;
    TrueViewOptions options_;
    int stride_;
    int surface_stride_;
    Camera camera_;
    std::vector<float> depth_m_;
    std::vector<std::uint32_t> obstacles_;
    TrueView view_;
};

} // namespace

int pixel_stride(const Camera& camera, double cell_m, double range_m) {
    const double focal_px = std::min(camera.fx_px, camera.fy_px);
    const double most = std::max(1, std::min(camera.width_px, camera.height_px) / surface_rays);
    const double stride = std::clamp(std::floor(0.5 * cell_m * focal_px / range_m), 1.0, most);
    // A multiple of the surface's rays, so that those followed are among them.
    const int whole = static_cast<int>(stride);
    return whole < surface_rays ? whole : whole - whole % surface_rays;
}

std::size_t choose_every(const Camera& camera, const TrueViewOptions& options) {
    const int stride = pixel_stride(camera, options.cell_m, options.range_m);
    const double rays = static_cast<double>(camera.width_px / stride) * (camera.height_px / stride);
    const double steps = std::max(rays * 1.5 * options.range_m / options.cell_m, 1.0);
    const double images = std::clamp(most_steps / steps, least_images, most_images);
    const auto given = static_cast<double>(options.last_image - options.first_image);
    return static_cast<std::size_t>(std::max(1.0, std::ceil(given / images)));
}

TrueView look_around(const Truth& truth, const TouchedCells& touched, const TrueImageDrawer& draw,
                     const TrueViewOptions& options,
                     const std::function<void(std::size_t)>& observer) {
    Look look(truth, touched, draw, options);
    std::size_t done = 0;
    for (std::size_t image = options.first_image; image < options.last_image;
         image += options.every) {
        observer(done++);
        look.draw(image);
        look.look_from(image);
        if (look.note_sights(image) && image > options.first_image) {
            for (std::size_t before = image - 1; before > image - options.every; --before) {
                look.draw(before);
                look.note_sights(before);
            }
        }
    }
    return look.take();
}

} // namespace zonegrid
