#include "model/rays.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace zonegrid {

namespace {

constexpr double greatest_direction = 4.0; // |D| stays below 2^30
constexpr int most_pixels_an_axis = 16384;

std::int32_t round_to_direction(double value) {
    return static_cast<std::int32_t>(std::floor(value * (1 << ZG_DIRECTION_BITS) + 0.5));
}

/// R * w, summed in the order docs/model.md gives.
Eigen::Vector3d rotate(const Eigen::Matrix3d& rotation, double x, double y, double z) {
    Eigen::Vector3d result;
    for (int i = 0; i < 3; ++i) {
        result[i] = (rotation(i, 0) * x + rotation(i, 1) * y) + rotation(i, 2) * z;
    }
    return result;
}

Direction fixed_direction(const Eigen::Matrix3d& rotation, double x, double y, double z) {
    const Eigen::Vector3d direction = rotate(rotation, x, y, z);
    return {round_to_direction(direction.x()), round_to_direction(direction.y()),
            round_to_direction(direction.z())};
}

/// (x/z, y/z) of a pixel's direction.
std::pair<double, double> slope(const Camera& camera, int u_px, int v_px) {
    if (!camera.directions.empty()) {
        const auto& entry = camera.directions[static_cast<std::size_t>(v_px) *
                                                  static_cast<std::size_t>(camera.width_px) +
                                              static_cast<std::size_t>(u_px)];
        return {double{entry.x()}, double{entry.y()}};
    }
    return {(u_px - camera.cx_px) / camera.fx_px, (v_px - camera.cy_px) / camera.fy_px};
}

double length(double x, double y) {
    return std::sqrt((x * x + y * y) + 1.0);
}

[[noreturn]] void refuse(const char* field, const std::string& problem) {
    throw UsageError(fmt::format("camera {}: {}", field, problem));
}

/// Depth at which the ray of each pixel reaches the range; checks the directions on the way.
std::vector<std::int32_t> range_limits(const Camera& camera, double range_sub) {
    std::vector<std::int32_t> limits;
    limits.reserve(static_cast<std::size_t>(camera.width_px) *
                   static_cast<std::size_t>(camera.height_px));
    for (int v_px = 0; v_px < camera.height_px; ++v_px) {
        for (int u_px = 0; u_px < camera.width_px; ++u_px) {
            const auto [x, y] = slope(camera, u_px, v_px);
            const double corner =
                length(std::abs(x) + 0.5 / camera.fx_px, std::abs(y) + 0.5 / camera.fy_px);
            if (!(corner < greatest_direction)) {
                refuse("directions",
                       fmt::format("pixel ({}, {}) looks more than 75 degrees off the axis; check "
                                   "focal lengths and principal point, or crop the image",
                                   u_px, v_px));
            }
            limits.push_back(static_cast<std::int32_t>(std::floor(range_sub / length(x, y))));
        }
    }
    return limits;
}

/// A side of the view through the camera's centre: of length 1, in the world, rounded.
View::Vector side(const Eigen::Matrix3d& rotation, double x, double y, double z) {
    const double length = std::sqrt((x * x + y * y) + z * z);
    const Eigen::Vector3d normal = rotate(rotation, x / length, y / length, z / length);
    const auto round = [](double value) {
        return static_cast<std::int32_t>(std::floor(value * (1 << ZG_VIEW_NORMAL_BITS) + 0.5));
    };
    return {round(normal.x()), round(normal.y()), round(normal.z())};
}

struct PixelBox {
    int left;
    int right; ///< inclusive, as bottom; less than left if there is no pixel
    int top;
    int bottom;
};

/// The least box that holds all pixels that are not missing.
PixelBox present_pixels(const ImageRays& rays) {
    PixelBox box{rays.width_px, -1, rays.height_px, -1};
    std::size_t pixel = 0;
    for (int v_px = 0; v_px < rays.height_px; ++v_px) {
        for (int u_px = 0; u_px < rays.width_px; ++u_px, ++pixel) {
            if (rays.depths[pixel].near >= 0) {
                box.left = std::min(box.left, u_px);
                box.right = std::max(box.right, u_px);
                box.top = std::min(box.top, v_px);
                box.bottom = v_px;
            }
        }
    }
    return box;
}

/// A mounting that scales would draw beyond the window.
void check_mounting(const Eigen::Isometry3d& body_from_camera) {
    constexpr double greatest_error = 1e-4;
    const Eigen::Matrix3d rotation = body_from_camera.linear();
    const double error =
        (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(error <= greatest_error) || rotation.determinant() < 0.0 ||
        !body_from_camera.translation().allFinite()) {
        refuse("mounting",
               "body_from_camera is no rotation and finite translation; check its axes");
    }
}

} // namespace

void check_camera(const Camera& camera) {
    const auto check_size = [](const char* field, int pixels) {
        if (pixels < 1 || pixels > most_pixels_an_axis) {
            refuse(field,
                   fmt::format("{} pixels; it must be 1 .. {}", pixels, most_pixels_an_axis));
        }
    };
    check_size("width", camera.width_px);
    check_size("height", camera.height_px);
    const auto check_focal = [](const char* field, double focal_px) {
        if (!std::isfinite(focal_px) || focal_px <= 0.0) {
            refuse(field, fmt::format("{}; a focal length in pixels must be above 0", focal_px));
        }
    };
    check_focal("fx", camera.fx_px);
    check_focal("fy", camera.fy_px);
    if (!std::isfinite(camera.cx_px) || !std::isfinite(camera.cy_px)) {
        refuse("cx, cy", "not finite");
    }
    const auto pixels =
        static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
    if (!camera.directions.empty() && camera.directions.size() != pixels) {
        refuse("directions",
               fmt::format("{} entries for {} pixels", camera.directions.size(), pixels));
    }
    check_mounting(camera.body_from_camera);
    if (camera.stereo) {
        const auto& stereo = *camera.stereo;
        if (!std::isfinite(stereo.baseline_m) || stereo.baseline_m <= 0.0) {
            refuse("baseline", fmt::format("{} m; it must be above 0", stereo.baseline_m));
        }
        if (!std::isfinite(stereo.disparity_sigma_px) || stereo.disparity_sigma_px < 0.0) {
            refuse("disparity sigma",
                   fmt::format("{} pixels; it must be 0 or more", stereo.disparity_sigma_px));
        }
    }
}

ImageQuantizer::ImageQuantizer(const Camera& camera, const MapperOptions& options)
    : camera_(camera),
      cell_m_(options.cell_m),
      spanned_(options.model == SensorModel::span),
      sub_per_m_(ZG_SUB_PER_CELL / options.cell_m),
      range_cells_(options.range_m / options.cell_m) {
    check_camera(camera);
    if (spanned_ && camera.stereo) {
        spread_per_m2_ = options.span_sigmas * camera.stereo->disparity_sigma_px /
                         (camera.fx_px * camera.stereo->baseline_m) * sub_per_m_;
    }
    limits_ = range_limits(camera, options.range_m * sub_per_m_);
}

PixelDepth ImageQuantizer::quantize_depth(float depth_m, std::int32_t limit) const {
    if (!(depth_m > 0.0F)) { // NaN too
        return {};
    }
    const double z = double{depth_m};
    const double depth_sub = z * sub_per_m_ + 0.5;
    if (depth_sub >= limit + 1.0) {
        return {limit, -1};
    }
    const auto depth = static_cast<std::int32_t>(depth_sub);
    const double spread_sub = std::floor(z * z * spread_per_m2_ + 0.5);
    const auto spread = static_cast<std::int32_t>(std::min(spread_sub, static_cast<double>(limit)));
    return {std::max(depth - spread, 0), std::min(depth + spread, limit)};
}

void ImageQuantizer::place_camera(const Eigen::Isometry3d& world_from_camera, const Window& window,
                                  ImageRays& rays) const {
    const Eigen::Matrix3d& rotation = world_from_camera.linear();
    rays.a = {};
    if (camera_.directions.empty()) {
        rays.a = fixed_direction(rotation, -camera_.cx_px / camera_.fx_px,
                                 -camera_.cy_px / camera_.fy_px, 1.0);
    }
    rays.u = fixed_direction(rotation, 1.0 / camera_.fx_px, 0.0, 0.0);
    rays.v = fixed_direction(rotation, 0.0, 1.0 / camera_.fy_px, 0.0);
    rays.directions.clear();
    if (!camera_.directions.empty()) {
        for (const auto& entry : camera_.directions) {
            rays.directions.push_back(
                fixed_direction(rotation, double{entry.x()}, double{entry.y()}, 1.0));
        }
    }
    const auto origin = window_relative(world_from_camera.translation(), cell_m_, window);
    assert(origin.has_value());
    rays.origin = *origin;
    rays.spacing = static_cast<std::int32_t>(
        std::min(std::floor(ZG_SUB_PER_CELL * std::min(camera_.fx_px, camera_.fy_px)),
                 double{ZG_MAX_SPACING}));
}

void ImageQuantizer::quantize(std::span<const float> depth_m,
                              const Eigen::Isometry3d& world_from_camera, const Window& window,
                              ImageRays& rays) const {
    assert(depth_m.size() == limits_.size());
    rays.width_px = camera_.width_px;
    rays.height_px = camera_.height_px;
    rays.spanned = spanned_;
    place_camera(world_from_camera, window, rays);
    rays.depths.resize(limits_.size());
    for (std::size_t i = 0; i < limits_.size(); ++i) {
        rays.depths[i] = quantize_depth(depth_m[i], limits_[i]);
    }
    rays.view = view(world_from_camera.linear(), rays);
}

View ImageQuantizer::view(const Eigen::Matrix3d& rotation, const ImageRays& rays) const {
    View view;
    view.bounded = true;
    const PixelBox box = present_pixels(rays);
    if (box.left > box.right) {
        return view;
    }
    double left = -greatest_direction;
    double right = greatest_direction;
    double top = -greatest_direction;
    double bottom = greatest_direction;
    for (int v_px = box.top; v_px <= box.bottom; ++v_px) {
        left = std::max(left, slope(camera_, box.left, v_px).first);
        right = std::min(right, slope(camera_, box.right, v_px).first);
    }
    for (int u_px = box.left; u_px <= box.right; ++u_px) {
        top = std::max(top, slope(camera_, u_px, box.top).second);
        bottom = std::min(bottom, slope(camera_, u_px, box.bottom).second);
    }
    view.sides = {side(rotation, 1.0, 0.0, -left), side(rotation, -1.0, 0.0, right),
                  side(rotation, 0.0, 1.0, -top), side(rotation, 0.0, -1.0, bottom)};
    const auto coarse = [](std::int32_t sub) {
        return floor_div(sub, ZG_SUB_PER_CELL / ZG_VIEW_PER_CELL);
    };
    view.centre = {coarse(rays.origin.x), coarse(rays.origin.y), coarse(rays.origin.z)};
    view.radius = static_cast<std::int32_t>(std::floor(range_cells_ * ZG_VIEW_PER_CELL));
    return view;
}

} // namespace zonegrid
