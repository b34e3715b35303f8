#include "reference/integrate_image.h"

#include "reference/draw_segment.h"

namespace zonegrid::reference {

namespace {

/// The least k for which 2^k by 2^k sub-rays are no further apart than a cell at `depth`.
std::int32_t split_level(const ImageRays& rays, std::int32_t depth) {
    std::int32_t level = 0;
    while (rays.spanned && level < ZG_MAX_SPLIT_LEVEL && rays.spacing << level < depth) {
        ++level;
    }
    return level;
}

/// Displacement of sub-ray `i` of 2^level from its pixel's centre on one image axis.
Direction sub_ray_offset(const Direction& per_pixel, std::int32_t i, std::int32_t level) {
    const std::int32_t m = 2 * i + 1 - (1 << level);
    // 64 bits: with a focal length below 2 pixels, 15 times the step leaves 32.
    const auto share = [=](std::int32_t component) {
        return static_cast<std::int32_t>((std::int64_t{component} * m) >> (level + 1));
    };
    return {share(per_pixel.x), share(per_pixel.y), share(per_pixel.z)};
}

/// Calls `visit(direction, depth)` for every sub-ray of every pixel that makes a statement.
template <class Visit>
void for_each_sub_ray(const ImageRays& rays, Visit&& visit) {
    std::size_t pixel = 0;
    for (std::int32_t v_px = 0; v_px < rays.height_px; ++v_px) {
        for (std::int32_t u_px = 0; u_px < rays.width_px; ++u_px, ++pixel) {
            const PixelDepth depth = rays.depths[pixel];
            if (depth.near < 0) {
                continue;
            }
            const Direction centre = rays.direction(u_px, v_px);
            const auto level = split_level(rays, depth.far >= 0 ? depth.far : depth.near);
            if (level == 0) {
                visit(centre, depth);
                continue;
            }
            for (std::int32_t j = 0; j < 1 << level; ++j) {
                const Direction down = sub_ray_offset(rays.v, j, level);
                for (std::int32_t i = 0; i < 1 << level; ++i) {
                    const Direction right = sub_ray_offset(rays.u, i, level);
                    visit(Direction{centre.x + right.x + down.x, centre.y + right.y + down.y,
                                    centre.z + right.z + down.z},
                          depth);
                }
            }
        }
    }
}

} // namespace

void integrate_image(const ImageRays& rays, LocalMap& local_map) {
    const SegmentPens pens(rays.origin, ZG_STATEMENT_FREE, local_map);
    for_each_sub_ray(rays, [&](const Direction& direction, const PixelDepth& depth) {
        pens.draw_to(rays.point_at(direction, depth.near));
    });
    // Obstacles last, all of them: occupied beats free in whatever order the pixels come.
    for_each_sub_ray(rays, [&](const Direction& direction, const PixelDepth& depth) {
        if (depth.far == depth.near) {
            draw_point(rays.point_at(direction, depth.far), ZG_STATEMENT_OCCUPIED, local_map);
        } else if (depth.far >= 0) {
            draw_segment(rays.point_at(direction, depth.near), rays.point_at(direction, depth.far),
                         ZG_STATEMENT_OCCUPIED, local_map);
        }
    });
}

} // namespace zonegrid::reference
