#include "support/oracle_view.h"

#include "support/oracle_rounding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zonegrid::oracle {

namespace {

constexpr std::int64_t units_per_cell = 16;
constexpr std::int64_t subs_per_unit = 16;
constexpr std::int64_t normal_length = 16384; // 2^14
constexpr std::int64_t margin = 3;            // units

std::int64_t dot(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A box of pixels; all bounds inclusive.
struct PixelBox {
    int first_u = 0;
    int last_u = 0;
    int first_v = 0;
    int last_v = 0;
};

/// The least box with every pixel that is not missing; nothing if all are.
std::optional<PixelBox> seeing_pixels(const Camera& camera, std::span<const float> depth_m) {
    std::optional<PixelBox> box;
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            if (is_missing(depth_m[pixel_at(camera, u, v)])) {
                continue;
            }
            if (!box) {
                box = PixelBox{u, u, v, v};
            }
            box->first_u = std::min(box->first_u, u);
            box->last_u = std::max(box->last_u, u);
            box->first_v = std::min(box->first_v, v);
            box->last_v = std::max(box->last_v, v);
        }
    }
    return box;
}

/// The slopes of the four planes, each from that pixel of its edge that is farthest inwards: with a
/// table of directions an edge of the picture is no straight line.
struct Slopes {
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
};

Slopes slopes_of(const Camera& camera, const PixelBox& box) {
    Slopes slopes;
    slopes.left = pixel_direction(camera, box.first_u, box.first_v)[0];
    slopes.right = pixel_direction(camera, box.last_u, box.first_v)[0];
    for (int v = box.first_v; v <= box.last_v; ++v) {
        slopes.left = std::max(slopes.left, pixel_direction(camera, box.first_u, v)[0]);
        slopes.right = std::min(slopes.right, pixel_direction(camera, box.last_u, v)[0]);
    }
    slopes.top = pixel_direction(camera, box.first_u, box.first_v)[1];
    slopes.bottom = pixel_direction(camera, box.first_u, box.last_v)[1];
    for (int u = box.first_u; u <= box.last_u; ++u) {
        slopes.top = std::max(slopes.top, pixel_direction(camera, u, box.first_v)[1]);
        slopes.bottom = std::min(slopes.bottom, pixel_direction(camera, u, box.last_v)[1]);
    }
    return slopes;
}

/// A plane's normal in the world, from the one in the camera's frame.
std::array<std::int64_t, 3> world_normal(const Rotation& rotation, const Triple& normal) {
    const double length =
        std::sqrt((normal[0] * normal[0] + normal[1] * normal[1]) + normal[2] * normal[2]);
    const Triple turned =
        rotate(rotation, {normal[0] / length, normal[1] / length, normal[2] / length});
    std::array<std::int64_t, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = floor_to_whole(static_cast<double>(normal_length) * turned[i] + 0.5);
    }
    return result;
}

} // namespace

View::View(const Camera& camera, const MapperOptions& options, const Pose& pose,
           std::span<const float> depth_m)
    : radius_(floor_to_whole((options.range_m / options.cell_m) *
                             static_cast<double>(units_per_cell))) {
    for (std::size_t i = 0; i < 3; ++i) {
        centre_[i] =
            floor_divide(sub_of(pose.position_m[i], options.cell_m).value(), subs_per_unit);
    }
    const auto box = seeing_pixels(camera, depth_m);
    if (!box) {
        return;
    }
    const Slopes slopes = slopes_of(camera, *box);
    inwards_ = {world_normal(pose.rotation, {1.0, 0.0, -slopes.left}),
                world_normal(pose.rotation, {-1.0, 0.0, slopes.right}),
                world_normal(pose.rotation, {0.0, 1.0, -slopes.top}),
                world_normal(pose.rotation, {0.0, -1.0, slopes.bottom})};
}

bool View::holds_whole(const CellIndex& cell) const {
    if (!inwards_) {
        return false;
    }
    for (const std::int64_t x : {std::int64_t{0}, units_per_cell}) {
        for (const std::int64_t y : {std::int64_t{0}, units_per_cell}) {
            for (const std::int64_t z : {std::int64_t{0}, units_per_cell}) {
                if (!holds_corner({units_per_cell * cell.x + x, units_per_cell * cell.y + y,
                                   units_per_cell * cell.z + z})) {
                    return false;
                }
            }
        }
    }
    return true;
}

bool View::holds_corner(const Whole& corner) const {
    Whole d{};
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = corner[i] - centre_[i];
    }
    for (const Whole& inwards : *inwards_) {
        if (dot(inwards, d) < margin * normal_length) {
            return false;
        }
    }
    return dot(d, d) <= (radius_ - margin) * (radius_ - margin);
}

} // namespace zonegrid::oracle
