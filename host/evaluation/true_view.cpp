#include "evaluation/true_view.h"

#include "truth/ray_caster.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace zonegrid {
namespace {

/// Rays that are followed for each surface point looked at, an axis: surfaces seen at a slant need
/// denser rays than free space does.
constexpr int surface_rays = 4;

/// Within so many cells of a border a hit lies on it: what touches from there, and rounding.
constexpr double border_reach = 2.0 * touch_slack;

/// Rays 2^this farther apart than the closest are followed from the camera on.
constexpr int top_level = 5;

constexpr double most_steps = 1e9;  ///< of rays through cells, all images together
constexpr double least_images = 20; ///< whatever that takes
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

/// One axis of a way through cells.
struct AxisWalk {
    std::int32_t cell = 0;
    std::int32_t step = 0;
    double next = 0.0;  ///< share of the way at which the next border lies
    double width = 0.0; ///< share of the way from border to border
    std::int64_t borders = 0;

    AxisWalk(double start, double end)
        : cell(static_cast<std::int32_t>(std::floor(start))),
          step(end > start ? 1 : -1),
          width(1.0 / std::abs(end - start)),
          borders(std::abs(static_cast<std::int64_t>(std::floor(end)) - cell)) {
        const double to_border = end > start ? cell + 1.0 - start : start - cell;
        // Infinite where there is no border to come, so that rounding cannot bring one.
        next = borders == 0 ? std::numeric_limits<double>::infinity() : to_border * width;
    }

    void advance() {
        cell += step;
        next += width;
    }
};

/// Calls `visit` for each cell on the straight way from `start` to `end`, in cells, both included.
///
/// Source: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
/// Eurographics 1987; in double, so not the mapper's own lattice.
template <class Visit>
void follow(const Eigen::Vector3d& start, const Eigen::Vector3d& end, Visit&& visit) {
    AxisWalk x(start.x(), end.x());
    AxisWalk y(start.y(), end.y());
    AxisWalk z(start.z(), end.z());
    visit(CellIndex{x.cell, y.cell, z.cell});
    for (std::int64_t left = x.borders + y.borders + z.borders; left > 0; --left) {
        if (x.next < y.next && x.next < z.next) {
            x.advance();
        } else if (y.next < z.next) {
            y.advance();
        } else {
            z.advance();
        }
        visit(CellIndex{x.cell, y.cell, z.cell});
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
        for (int v = 0; v < camera_.height_px; ++v) {
            for (int u = 0; u < camera_.width_px; ++u) {
                take_ray(from, start, u, v);
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

    /// Depth from which on a ray is needed: before it, rays farther apart lie closely enough.
    /// Infinite for rays that are not followed.
    [[nodiscard]] double needed_from_m(int u, int v) const {
        const int every_ray = stride_ / surface_stride_;
        if (u % every_ray != every_ray / 2 || v % every_ray != every_ray / 2) {
            return std::numeric_limits<double>::infinity();
        }
        const auto column = static_cast<unsigned>(u / every_ray);
        const auto row = static_cast<unsigned>(v / every_ray);
        const int level = std::min({std::countr_zero(column), std::countr_zero(row), top_level});
        if (level == top_level) {
            return 0.0;
        }
        // Up to here the rays twice as far apart as this one's are closer than half a cell.
        const double focal_px = std::min(truth_.camera.fx_px, truth_.camera.fy_px);
        return 0.5 * options_.cell_m * focal_px / (stride_ * std::ldexp(2.0, level));
    }

    void take_ray(const TrueImage& from, const Eigen::Vector3d& start, int u, int v) {
        const auto pixel =
            static_cast<std::size_t>(v) * static_cast<std::size_t>(camera_.width_px) +
            static_cast<std::size_t>(u);
        const Eigen::Vector3d slope = slope_of(u, v);
        const double most_depth_m = options_.range_m / slope.norm();
        const bool ends = obstacles_[pixel] != sky_obstacle &&
                          static_cast<double>(depth_m_[pixel]) <= most_depth_m;
        const double depth_m = ends ? static_cast<double>(depth_m_[pixel]) : most_depth_m;
        const auto place_at = [&](double at_m) -> Eigen::Vector3d {
            return from.world_from_camera * (slope * at_m) / options_.cell_m;
        };
        const Eigen::Vector3d end = place_at(depth_m);
        const double needed_m = needed_from_m(u, v);
        if (needed_m < depth_m) {
            const CellIndex last = cell_at_m(end, 1.0);
            follow(needed_m > 0.0 ? place_at(needed_m) : start, end, [&](const CellIndex& cell) {
                if (!ends || cell != last) {
                    view_.free.insert(cell);
                }
            });
        }
        if (ends) {
            take_hit(obstacles_[pixel], end);
        }
    }

    /// Notes the cell of a hit; on a border the greatest of those that touch there, and by which
    /// others it may be replaced.
    void take_hit(std::uint32_t obstacle, const Eigen::Vector3d& end) {
        if (truth_.surfaces.obstacles[obstacle].moving) {
            return;
        }
        ++view_.hits;
        const Eigen::Vector3d reach = Eigen::Vector3d::Constant(border_reach);
        const CellIndex high = cell_at_m(end + reach, 1.0);
        const CellIndex low = cell_at_m(end - reach, 1.0);
        std::optional<CellIndex> chosen;
        for (unsigned steps = 0; steps < 8; ++steps) {
            const CellIndex cell{(steps & 1U) != 0 ? low.x : high.x,
                                 (steps & 2U) != 0 ? low.y : high.y,
                                 (steps & 4U) != 0 ? low.z : high.z};
            if (!touched_.of(obstacle).contains(cell)) {
                continue;
            }
            if (!chosen) {
                chosen = cell;
                view_.surface.insert(cell);
                view_.surface_of[obstacle].insert(cell);
            } else if (cell != *chosen) {
                const unsigned other = (cell.x < chosen->x ? 1U : 0U) |
                                       (cell.y < chosen->y ? 2U : 0U) |
                                       (cell.z < chosen->z ? 4U : 0U);
                if (CellIndex{chosen->x - (other & 1U ? 1 : 0), chosen->y - (other & 2U ? 1 : 0),
                              chosen->z - (other & 4U ? 1 : 0)} == cell) {
                    view_.surface_or[other].insert(*chosen);
                }
            }
        }
        view_.unplaced_hits += chosen ? 0U : 1U;
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

std::vector<CellIndex> alternatives(const TrueView& view, const CellIndex& cell) {
    std::vector<CellIndex> cells{cell};
    for (unsigned steps = 1; steps < view.surface_or.size(); ++steps) {
        if (view.surface_or[steps].contains(cell)) {
            cells.push_back({cell.x - ((steps & 1U) != 0 ? 1 : 0),
                             cell.y - ((steps & 2U) != 0 ? 1 : 0),
                             cell.z - ((steps & 4U) != 0 ? 1 : 0)});
        }
    }
    return cells;
}

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
    const int columns = camera.width_px / stride;
    const int rows = camera.height_px / stride;
    const double rays = static_cast<double>(columns) * static_cast<double>(rows);
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
