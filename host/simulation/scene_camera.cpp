#include "io/plain_description.h"
#include "simulation/scene_keys.h"
#include "simulation/scene_tables.h"

#include <cmath>
#include <numbers>

namespace zonegrid {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;
constexpr double half_width_rad = 25.5 * rad_per_deg;
constexpr double half_height_rad = 20.0 * rad_per_deg;
constexpr Span focal_limits{1.0, 1e5};
constexpr Span middle_limits{-1e5, 1e5};
constexpr Span angle_limits{-360.0, 360.0};

} // namespace

void read_camera(DescriptionTable& root, Scene& scene) {
    const toml::table nothing;
    DescriptionTable table = root.table("camera").value_or(
        DescriptionTable(nothing, {}, "camera", "docs/simulation.md"));
    Camera& camera = scene.camera;
    camera.width_px = table.number("width_px") ? table.needed_size("width_px") : 640;
    camera.height_px = table.number("height_px") ? table.needed_size("height_px") : 480;
    camera.fx_px =
        read_number(table, "fx_px", focal_limits, 0.5 * camera.width_px / std::tan(half_width_rad));
    camera.fy_px = read_number(table, "fy_px", focal_limits,
                               0.5 * camera.height_px / std::tan(half_height_rad));
    camera.cx_px = read_number(table, "cx_px", middle_limits, 0.5 * (camera.width_px - 1));
    camera.cy_px = read_number(table, "cy_px", middle_limits, 0.5 * (camera.height_px - 1));
    camera.stereo = StereoNoise{read_number(table, "baseline_m", {0.001, 100.0}, 0.30),
                                read_number(table, "disparity_sigma_px", {0.001, 100.0}, 0.25)};
    const double roll_deg = read_number(table, "roll_deg", angle_limits, 0.0);
    const double pitch_deg = read_number(table, "pitch_deg", angle_limits, 0.0);
    const double yaw_deg = read_number(table, "yaw_deg", angle_limits, 0.0);
    camera.body_from_camera.linear() =
        mounted_rotation(roll_deg, pitch_deg, yaw_deg, body_from_forward_camera());
    if (table.numbers("position_m")) {
        camera.body_from_camera.translation() =
            read_point<3>(table, "position_m", "[forward, right, down] in m");
    }
    scene.image_rate_hz = read_number(table, "image_rate_hz", {0.1, 1000.0}, scene.image_rate_hz);
    table.require_all_read();
}

} // namespace zonegrid
