#include "support/oracle_local_map.h"

#include "support/oracle_rounding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zonegrid::oracle {

namespace {

using Whole = std::array<std::int64_t, 3>;

constexpr double two_to_28 = 268435456.0;

Whole fixed_point(const Rotation& rotation, const Triple& vector) {
    const Triple turned = rotate(rotation, vector);
    return {floor_to_whole(two_to_28 * turned[0] + 0.5),
            floor_to_whole(two_to_28 * turned[1] + 0.5),
            floor_to_whole(two_to_28 * turned[2] + 0.5)};
}

void say_free(StatementMap& map, const SubCell& from, const SubCell& to) {
    for (const CellIndex& cell : segment_cells(from, to)) {
        map.try_emplace(cell, Statement::free);
    }
}

void say_occupied(StatementMap& map, const SubCell& from, const SubCell& to) {
    for (const CellIndex& cell : segment_cells(from, to)) {
        map[cell] = Statement::occupied;
    }
}

/// One pixel's distances along the optical axis in sub-cells; far is absent if nothing was hit.
struct Depth {
    std::int64_t near = 0;
    std::optional<std::int64_t> far;
};

/// Everything about an image that does not depend on the pixel.
class Picture {
public:
    Picture(const Camera& camera, const MapperOptions& options, const Pose& pose)
        : camera_(camera), options_(options), pose_(pose), scale_(256.0 / options.cell_m) {
        for (std::size_t i = 0; i < 3; ++i) {
            origin_[i] = sub_of(pose.position_m[i], options.cell_m).value();
        }
        step_u_ = fixed_point(pose.rotation, {1.0 / camera.fx_px, 0.0, 0.0});
        step_v_ = fixed_point(pose.rotation, {0.0, 1.0 / camera.fy_px, 0.0});
        corner_ = fixed_point(pose.rotation,
                              {-camera.cx_px / camera.fx_px, -camera.cy_px / camera.fy_px, 1.0});
    }

    /// Nothing for a missing pixel.
    [[nodiscard]] std::optional<Depth> depth(int u, int v, float depth_m) const {
        if (is_missing(depth_m)) {
            return {};
        }
        const auto z = static_cast<double>(depth_m);
        const Triple d = pixel_direction(camera_, u, v);
        const double length = std::sqrt((d[0] * d[0] + d[1] * d[1]) + 1.0);
        const double limit = std::floor(options_.range_m * scale_ / length);
        const double q = std::floor(z * scale_ + 0.5);
        if (std::isinf(z) || q > limit) {
            return Depth{floor_to_whole(limit), {}};
        }
        const double r = spread(z);
        return Depth{floor_to_whole(std::max(q - r, 0.0)), floor_to_whole(std::min(q + r, limit))};
    }

    /// The directions of a pixel's sub-rays, in 1/2^28.
    [[nodiscard]] std::vector<Whole> rays(int u, int v, const Depth& depth) const {
        const Whole middle = pixel_ray(u, v);
        const int level = split_level(depth.far.value_or(depth.near));
        if (level == 0) {
            return {middle};
        }
        const std::int64_t parts = std::int64_t{1} << level;
        std::vector<Whole> result;
        for (std::int64_t j = 0; j < parts; ++j) {
            for (std::int64_t i = 0; i < parts; ++i) {
                Whole ray = middle;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    ray[axis] += floor_divide(step_u_[axis] * (2 * i + 1 - parts), 2 * parts);
                    ray[axis] += floor_divide(step_v_[axis] * (2 * j + 1 - parts), 2 * parts);
                }
                result.push_back(ray);
            }
        }
        return result;
    }

    [[nodiscard]] SubCell point(const Whole& ray, std::int64_t depth) const {
        SubCell result = origin_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            result[axis] += floor_divide(ray[axis] * depth, std::int64_t{1} << 28);
        }
        return result;
    }

    [[nodiscard]] const SubCell& origin() const { return origin_; }

private:
    [[nodiscard]] Whole pixel_ray(int u, int v) const {
        if (!camera_.directions.empty()) {
            return fixed_point(pose_.rotation, pixel_direction(camera_, u, v));
        }
        Whole ray = corner_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            ray[axis] += u * step_u_[axis] + v * step_v_[axis];
        }
        return ray;
    }

    [[nodiscard]] double spread(double z) const {
        if (options_.model == SensorModel::line || !camera_.stereo) {
            return 0.0;
        }
        const double c = options_.span_sigmas * camera_.stereo->disparity_sigma_px /
                         (camera_.fx_px * camera_.stereo->baseline_m) * scale_;
        return std::floor((z * z) * c + 0.5);
    }

    [[nodiscard]] int split_level(std::int64_t depth) const {
        if (options_.model == SensorModel::line) {
            return 0;
        }
        const double focal_px = std::min(camera_.fx_px, camera_.fy_px);
        const std::int64_t spacing =
            floor_to_whole(std::min(std::floor(256.0 * focal_px), 67108864.0));
        for (int level = 0; level < 4; ++level) {
            if (spacing * (1 << level) >= depth) {
                return level;
            }
        }
        return 4;
    }

    const Camera& camera_;
    const MapperOptions& options_;
    const Pose& pose_;
    double scale_;
    SubCell origin_{};
    Whole step_u_{};
    Whole step_v_{};
    Whole corner_{};
};

/// All three coordinates of a position, or nothing if one is out of all bounds.
std::optional<SubCell> subs_of(const Triple& position_m, double cell_m) {
    SubCell result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto sub = sub_of(position_m[i], cell_m);
        if (!sub) {
            return {};
        }
        result[i] = *sub;
    }
    return result;
}

Triple to_world(const Pose& pose, const Eigen::Vector3f& point_m) {
    Triple result =
        rotate(pose.rotation, {static_cast<double>(point_m.x()), static_cast<double>(point_m.y()),
                               static_cast<double>(point_m.z())});
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = result[i] + pose.position_m[i];
    }
    return result;
}

} // namespace

bool Window::holds(const CellIndex& cell) const {
    const Whole wanted{cell.x, cell.y, cell.z};
    for (std::size_t i = 0; i < 3; ++i) {
        if (wanted[i] < first[i] || wanted[i] >= first[i] + edge) {
            return false;
        }
    }
    return true;
}

std::optional<std::int64_t> sub_of(double position_m, double cell_m) {
    const double cells = position_m / cell_m;
    if (!(std::abs(cells) <= 2147483647.0)) {
        return {};
    }
    return floor_to_whole(cells * 256.0);
}

bool is_missing(float depth_m) {
    return std::isnan(depth_m) || depth_m <= 0.0F;
}

std::size_t pixel_at(const Camera& camera, int u, int v) {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(camera.width_px) +
           static_cast<std::size_t>(u);
}

Triple pixel_direction(const Camera& camera, int u, int v) {
    if (camera.directions.empty()) {
        return {(u - camera.cx_px) / camera.fx_px, (v - camera.cy_px) / camera.fy_px, 1.0};
    }
    const Eigen::Vector2f& direction = camera.directions[pixel_at(camera, u, v)];
    return {static_cast<double>(direction.x()), static_cast<double>(direction.y()), 1.0};
}

LocalMap image_local_map(const Camera& camera, const MapperOptions& options, const Pose& pose,
                         std::span<const float> depth_m) {
    const Picture picture(camera, options, pose);
    LocalMap map;
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            const auto depth = picture.depth(u, v, depth_m[pixel_at(camera, u, v)]);
            if (!depth) {
                ++map.missing;
                continue;
            }
            for (const Whole& ray : picture.rays(u, v, *depth)) {
                const SubCell end = picture.point(ray, depth->near);
                say_free(map.cells, picture.origin(), end);
                if (depth->far) {
                    say_occupied(map.cells, end, picture.point(ray, *depth->far));
                }
            }
        }
    }
    return map;
}

LocalMap scan_local_map(const Scan& scan, const MapperOptions& options, const Pose& pose,
                        const Window& window) {
    LocalMap map;
    for (std::size_t n = 0; n < scan.ends_m.size(); ++n) {
        const Triple start =
            scan.starts_m.empty() ? pose.position_m : to_world(pose, scan.starts_m[n]);
        Triple end = to_world(pose, scan.ends_m[n]);
        const Triple way{end[0] - start[0], end[1] - start[1], end[2] - start[2]};
        const double d = std::sqrt((way[0] * way[0] + way[1] * way[1]) + way[2] * way[2]);
        if (!std::isfinite(d) || d == 0.0) {
            ++map.missing;
            continue;
        }
        const bool hit = d <= options.range_m;
        if (!hit) {
            const double share = options.range_m / d;
            for (std::size_t i = 0; i < 3; ++i) {
                end[i] = start[i] + way[i] * share;
            }
        }
        const auto from = subs_of(start, options.cell_m);
        const auto to = subs_of(end, options.cell_m);
        if (!from || !to || !window.holds(cell_of(*from)) || !window.holds(cell_of(*to))) {
            ++map.dropped;
            continue;
        }
        say_free(map.cells, *from, *to);
        if (hit) {
            say_occupied(map.cells, *to, *to);
        }
    }
    return map;
}

} // namespace zonegrid::oracle
