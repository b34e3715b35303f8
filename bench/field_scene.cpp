#include "field_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace zonegrid::bench {

namespace {

constexpr double camera_height_m = 8.0;
constexpr double pitch_down_deg = 10.0;
constexpr double never = std::numeric_limits<double>::infinity();

double radians(double angle_deg) {
    return angle_deg * std::numbers::pi / 180.0;
}

/// A trunk from the ground to the crown's centre, and the crown around its upper end.
struct Tree {
    double north_m;
    double east_m;
    double crown_height_m; ///< of the crown's centre above the ground
    double crown_radius_m;
    double trunk_radius_m;
};

constexpr std::array<Tree, 12> trees{{
    {9.0, -2.5, 4.0, 1.4, 0.15},
    {12.0, 3.0, 5.0, 1.8, 0.20},
    {14.5, -5.0, 6.5, 2.2, 0.25},
    {17.0, 1.0, 4.5, 1.5, 0.15},
    {19.5, 7.0, 7.5, 2.6, 0.30},
    {22.0, -8.0, 5.5, 2.0, 0.20},
    {24.5, -2.0, 8.0, 2.8, 0.35},
    {27.0, 4.5, 6.0, 2.1, 0.25},
    {30.0, -11.0, 9.0, 3.0, 0.35},
    {32.5, 12.0, 7.0, 2.4, 0.30},
    {35.5, -4.5, 10.0, 3.2, 0.40},
    {38.0, 6.0, 8.5, 2.9, 0.30},
}};

/// Least parameter above 0 at which a t^2 + 2 b t + c is 0, or `never`.
double first_root(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (a <= 0.0 || discriminant < 0.0) {
        return never;
    }
    const double t = (-b - std::sqrt(discriminant)) / a;
    return t > 0.0 ? t : never;
}

double meet_crown(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, const Tree& tree) {
    const Eigen::Vector3d away =
        from - Eigen::Vector3d(tree.north_m, tree.east_m, -tree.crown_height_m);
    return first_root(direction.squaredNorm(), away.dot(direction),
                      away.squaredNorm() - tree.crown_radius_m * tree.crown_radius_m);
}

double meet_trunk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, const Tree& tree) {
    const Eigen::Vector2d away = from.head<2>() - Eigen::Vector2d(tree.north_m, tree.east_m);
    const Eigen::Vector2d along = direction.head<2>();
    const double t = first_root(along.squaredNorm(), away.dot(along),
                                away.squaredNorm() - tree.trunk_radius_m * tree.trunk_radius_m);
    const double height_m = -(from.z() + t * direction.z());
    return height_m >= 0.0 && height_m <= tree.crown_height_m ? t : never;
}

/// Least t with from + t * direction on something; `never` if the ray sees sky.
double cast_ray(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    double t = direction.z() > 0.0 ? -from.z() / direction.z() : never;
    for (const auto& tree : trees) {
        t = std::min({t, meet_crown(from, direction, tree), meet_trunk(from, direction, tree)});
    }
    return t;
}

Camera make_camera() {
    Camera camera;
    camera.width_px = 640;
    camera.height_px = 480;
    camera.fx_px = 320.0 / std::tan(radians(51.0 / 2.0));
    camera.fy_px = 240.0 / std::tan(radians(40.0 / 2.0));
    camera.cx_px = 319.5;
    camera.cy_px = 239.5;
    camera.body_from_camera.linear() = body_from_forward_camera();
    return camera;
}

} // namespace

FieldScene make_field_scene() {
    FieldScene scene;
    scene.camera = make_camera();
    Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();
    world_from_body.linear() =
        attitude_from_euler(0.0, -radians(pitch_down_deg), 0.0).toRotationMatrix();
    world_from_body.translation() = Eigen::Vector3d(0.0, 0.0, -camera_height_m);
    scene.world_from_camera = world_from_body * scene.camera.body_from_camera;
    const auto& camera = scene.camera;
    scene.depth_m.reserve(static_cast<std::size_t>(camera.width_px) *
                          static_cast<std::size_t>(camera.height_px));
    for (int v_px = 0; v_px < camera.height_px; ++v_px) {
        for (int u_px = 0; u_px < camera.width_px; ++u_px) {
            // The optical axis has length 1 here, so the ray's parameter is the axial depth.
            const Eigen::Vector3d direction =
                scene.world_from_camera.linear() *
                Eigen::Vector3d((u_px - camera.cx_px) / camera.fx_px,
                                (v_px - camera.cy_px) / camera.fy_px, 1.0);
            scene.depth_m.push_back(
                static_cast<float>(cast_ray(scene.world_from_camera.translation(), direction)));
        }
    }
    return scene;
}

} // namespace zonegrid::bench
