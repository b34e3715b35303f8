#include "truth/ray_caster.h"

#include "truth/triangle_scene.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace zonegrid {
namespace {

constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

/// The plane of a triangle, both sides.
struct Plane {
    Eigen::Vector3d point_m;
    Eigen::Vector3d normal; ///< unit
};

/// A ray in doubles: start + t * step.
struct Line {
    Eigen::Vector3d start_m;
    Eigen::Vector3d step;
};

/// Where the line meets the plane. Embree finds which triangle is hit in floats; the distance is
/// taken again in doubles, so that it holds nothing of the processor's way to compute. Along a
/// plane it is not defined, and Embree's is as good.
double meet(const Line& line, const Plane& plane, double embree) {
    const double along = plane.normal.dot(line.step);
    const double exact = plane.normal.dot(plane.point_m - line.start_m) / along;
    const double doubt = 1e-3 * (1.0 + std::abs(embree));
    return std::abs(exact - embree) <= doubt ? exact : embree;
}

/// Embree ends the program at rays that single precision cannot hold.
void require_castable(const Line& line) {
    constexpr double most = 1e15; // its own limit is 2e18
    if (!(line.start_m.cwiseAbs().maxCoeff() < most && line.step.cwiseAbs().maxCoeff() < most)) {
        throw UsageError(
            "a ray begins too far away or its direction is too long: give places and "
            "slopes that single precision can hold");
    }
}

/// Where the ray of a pixel begins and a step that is a metre along the optical axis.
Line line_of(const Camera& camera, const Eigen::Isometry3d& world_from_camera, std::size_t u,
             std::size_t v) {
    return {world_from_camera.translation(),
            world_from_camera.linear() *
                Eigen::Vector3d((static_cast<double>(u) - camera.cx_px) / camera.fx_px,
                                (static_cast<double>(v) - camera.cy_px) / camera.fy_px, 1.0)};
}

} // namespace

/// What the rays are cast at.
class RayCaster::Implementation {
public:
    Implementation(const Surfaces& surfaces, std::span<const ObstacleMotion> motions)
        : surfaces_(surfaces), owners_(surfaces.obstacle_of_triangles()) {
        check_motions(motions);
        std::vector<std::uint32_t> still;
        for (std::uint32_t i = 0; i < owners_.size(); ++i) {
            if (!surfaces.obstacles[owners_[i]].moving) {
                still.push_back(i);
            }
        }
        scene_.add_triangles(surfaces, std::move(still));
        for (const ObstacleMotion& motion : motions) {
            add_moving(motion);
        }
        scene_.commit();
        move_to(0.0);
    }

    void move_to(double time_s) {
        for (std::size_t i = 0; i < motions_.size(); ++i) {
            poses_[i] = motions_[i].at(time_s);
            scene_.place(i, poses_[i]);
        }
        if (!motions_.empty()) {
            scene_.commit();
        }
    }

    /// The distance in `line`'s steps and what is hit, after Embree found it.
    [[nodiscard]] SurfaceHit hit_of(const Line& line, const TriangleHit& found) const {
        const std::uint32_t triangle = scene_.triangle_of(found);
        Line local = line;
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        if (found.part != TriangleScene::still_part) {
            const Eigen::Isometry3d& pose = poses_[found.part - 1];
            local.start_m = pose.inverse() * line.start_m;
            local.step = pose.linear().transpose() * line.step;
            turn = pose.linear();
        }
        const Plane plane = plane_of(triangle);
        SurfaceHit hit;
        hit.distance_m = meet(local, plane, static_cast<double>(found.distance));
        hit.obstacle = owners_[triangle];
        hit.normal = (turn * plane.normal).cast<float>();
        return hit;
    }

    [[nodiscard]] const TriangleScene& scene() const { return scene_; }

private:
    void check_motions(std::span<const ObstacleMotion> motions) const {
        std::vector<int> moved(surfaces_.obstacles.size(), 0);
        for (const ObstacleMotion& motion : motions) {
            if (motion.obstacle >= moved.size() || motion.poses.empty() ||
                !surfaces_.obstacles[motion.obstacle].moving) {
                throw UsageError(fmt::format(
                    "a motion names obstacle {}, which does not move, or it has no pose",
                    motion.obstacle));
            }
            ++moved[motion.obstacle];
        }
        for (std::size_t i = 0; i < moved.size(); ++i) {
            if (surfaces_.obstacles[i].moving && moved[i] != 1) {
                throw UsageError(
                    fmt::format("the moving obstacle '{}' has {} motions: give it exactly one",
                                surfaces_.obstacles[i].name, moved[i]));
            }
        }
    }

    void add_moving(const ObstacleMotion& motion) {
        const TrueObstacle& obstacle = surfaces_.obstacles[motion.obstacle];
        std::vector<std::uint32_t> triangles(obstacle.triangles);
        for (std::uint32_t k = 0; k < obstacle.triangles; ++k) {
            triangles[k] = obstacle.first_triangle + k;
        }
        scene_.add_moving_triangles(surfaces_, std::move(triangles));
        motions_.push_back(motion);
        poses_.push_back(Eigen::Isometry3d::Identity());
    }

    [[nodiscard]] Plane plane_of(std::uint32_t triangle) const {
        const auto& corners = surfaces_.triangles[triangle];
        const Eigen::Vector3d a = surfaces_.vertices_m[corners[0]].cast<double>();
        const Eigen::Vector3d b = surfaces_.vertices_m[corners[1]].cast<double>();
        const Eigen::Vector3d c = surfaces_.vertices_m[corners[2]].cast<double>();
        return {a, (b - a).cross(c - a).normalized()};
    }

    const Surfaces& surfaces_;
    std::vector<std::uint32_t> owners_; ///< obstacle of each triangle
    std::vector<ObstacleMotion> motions_;
    std::vector<Eigen::Isometry3d> poses_; ///< of the moving obstacles now, as in motions_
    TriangleScene scene_;
};

RayCaster::RayCaster(const Surfaces& surfaces, std::span<const ObstacleMotion> motions)
    : implementation_(std::make_unique<Implementation>(surfaces, motions)) {}

RayCaster::~RayCaster() = default;

void RayCaster::move_to(double time_s) {
    implementation_->move_to(time_s);
}

std::optional<SurfaceHit> RayCaster::cast(const Eigen::Vector3d& start_m,
                                          const Eigen::Vector3d& direction) const {
    require_castable({start_m, direction});
    const auto found =
        implementation_->scene().cast(start_m.cast<float>(), direction.cast<float>());
    if (!found) {
        return std::nullopt;
    }
    return implementation_->hit_of({start_m, direction}, *found);
}

void RayCaster::draw(const Camera& camera, const Eigen::Isometry3d& world_from_camera,
                     std::span<float> depth_m, std::span<std::uint32_t> obstacles) const {
    const auto width = static_cast<std::size_t>(camera.width_px);
    const auto height = static_cast<std::size_t>(camera.height_px);
    if (depth_m.size() != width * height ||
        (!obstacles.empty() && obstacles.size() != depth_m.size())) {
        throw UsageError("the image does not have the camera's size");
    }
    for (const std::size_t u : {std::size_t{0}, width - 1}) { // slopes are greatest in a corner
        for (const std::size_t v : {std::size_t{0}, height - 1}) {
            require_castable(line_of(camera, world_from_camera, u, v));
        }
    }
    const Eigen::Vector3d start_m = world_from_camera.translation();
    const auto draw_row = [&](std::size_t v) {
        std::vector<Eigen::Vector3d> steps(width);
        std::vector<Eigen::Vector3f> directions(width);
        std::vector<TriangleHit> found(width);
        for (std::size_t u = 0; u < width; ++u) {
            steps[u] = line_of(camera, world_from_camera, u, v).step; // distances are depths
            directions[u] = steps[u].cast<float>();
        }
        implementation_->scene().cast_row(start_m.cast<float>(), directions, found);
        for (std::size_t u = 0; u < width; ++u) {
            const std::size_t pixel = v * width + u;
            const bool sky = found[u].triangle == nothing;
            const SurfaceHit hit =
                sky ? SurfaceHit{std::numeric_limits<double>::infinity(), sky_obstacle, {}}
                    : implementation_->hit_of({start_m, steps[u]}, found[u]);
            depth_m[pixel] = static_cast<float>(hit.distance_m);
            if (!obstacles.empty()) {
                obstacles[pixel] = hit.obstacle;
            }
        }
    };
    std::atomic<std::size_t> next{0};
    const auto draw_rows = [&] {
        for (std::size_t v = next++; v < height; v = next++) {
            draw_row(v);
        }
    };
    std::vector<std::jthread> others;
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    for (std::size_t i = 1; i < std::min(cores, height); ++i) {
        others.emplace_back(draw_rows);
    }
    draw_rows();
}

} // namespace zonegrid
