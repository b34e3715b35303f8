#include "ops/reached_zones.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace zonegrid::ops {

namespace {

using Point = std::array<std::int64_t, 3>;

/// What a box's least and greatest sub-cells are widened by: ends are rounded down to a sub-cell,
/// and the straight line between two of them strays from the exact ray by less than that.
constexpr std::int64_t slack_sub = 2;

class ZoneMarks {
public:
    explicit ZoneMarks(const Window& window)
        : zones_(window.zones_per_axis()),
          zone_sub_(std::int64_t{window.zone_edge()} * ZG_SUB_PER_CELL),
          marks_(window.zone_count()) {}

    [[nodiscard]] std::int64_t zone_sub() const { return zone_sub_; }

    /// Marks the zones of a box of sub-cells; what lies beyond the window is left out.
    void mark(const Point& least, const Point& greatest) {
        std::array<std::int64_t, 3> first{};
        std::array<std::int64_t, 3> last{};
        for (std::size_t i = 0; i < 3; ++i) {
            first[i] = std::max<std::int64_t>(least[i] - slack_sub, 0) / zone_sub_;
            last[i] = std::min((greatest[i] + slack_sub) / zone_sub_, zones_ - 1);
        }
        for (auto z = first[2]; z <= last[2]; ++z) {
            for (auto y = first[1]; y <= last[1]; ++y) {
                for (auto x = first[0]; x <= last[0]; ++x) {
                    marks_[static_cast<std::size_t>((z * zones_ + y) * zones_ + x)] = true;
                }
            }
        }
    }

    [[nodiscard]] std::vector<std::uint32_t> places() const {
        std::vector<std::uint32_t> places;
        for (std::size_t place = 0; place < marks_.size(); ++place) {
            if (marks_[place]) {
                places.push_back(static_cast<std::uint32_t>(place));
            }
        }
        return places;
    }

private:
    std::int64_t zones_;
    std::int64_t zone_sub_;
    std::vector<bool> marks_;
};

Point as_point(const Direction& direction) {
    return {direction.x, direction.y, direction.z};
}

Point as_point(const SubPoint& point) {
    return {point.x, point.y, point.z};
}

/// Rays of a rectangle of pixels: what bounds them all.
struct Bundle {
    Point least{INT32_MAX, INT32_MAX, INT32_MAX}; ///< directions
    Point greatest{INT32_MIN, INT32_MIN, INT32_MIN};
    std::int32_t depth = -1; ///< the deepest end; -1: no ray

    void add(const Direction& direction, const PixelDepth& pixel) {
        if (pixel.near < 0) {
            return;
        }
        depth = std::max({depth, pixel.near, pixel.far});
        const Point point = as_point(direction);
        for (std::size_t i = 0; i < 3; ++i) {
            least[i] = std::min(least[i], point[i]);
            greatest[i] = std::max(greatest[i], point[i]);
        }
    }
};

void mark_bundle(const ImageRays& rays, const Bundle& bundle, ZoneMarks& marks) {
    const Point origin = as_point(rays.origin);
    const Point u = as_point(rays.u);
    const Point v = as_point(rays.v);
    for (std::int64_t from = 0; from <= bundle.depth; from += marks.zone_sub()) {
        const std::int64_t to = std::min<std::int64_t>(from + marks.zone_sub(), bundle.depth);
        Point least{};
        Point greatest{};
        for (std::size_t i = 0; i < 3; ++i) {
            // Sub-rays stay within half a pixel of its centre.
            const std::int64_t half =
                rays.spanned ? (std::abs(u[i]) + std::abs(v[i])) / 2 + 2 : std::int64_t{0};
            const std::int64_t low = bundle.least[i] - half;
            const std::int64_t high = bundle.greatest[i] + half;
            least[i] = origin[i] + (std::min(low * from, low * to) >> ZG_DIRECTION_BITS);
            greatest[i] = origin[i] + (std::max(high * from, high * to) >> ZG_DIRECTION_BITS);
        }
        marks.mark(least, greatest);
    }
}

} // namespace

std::vector<std::uint32_t> reached_zones(const ImageRays& rays, const Window& window) {
    constexpr std::int32_t tile_px = 8;
    ZoneMarks marks(window);
    for (std::int32_t tile_v = 0; tile_v < rays.height_px; tile_v += tile_px) {
        for (std::int32_t tile_u = 0; tile_u < rays.width_px; tile_u += tile_px) {
            Bundle bundle;
            for (auto v = tile_v; v < std::min(tile_v + tile_px, rays.height_px); ++v) {
                for (auto u = tile_u; u < std::min(tile_u + tile_px, rays.width_px); ++u) {
                    bundle.add(rays.direction(u, v),
                               rays.depths[static_cast<std::size_t>(v) *
                                               static_cast<std::size_t>(rays.width_px) +
                                           static_cast<std::size_t>(u)]);
                }
            }
            mark_bundle(rays, bundle, marks);
        }
    }
    return marks.places();
}

std::vector<std::uint32_t> reached_zones(const ScanRays& scan, const Window& window) {
    ZoneMarks marks(window);
    for (const auto& ray : scan.rays) {
        const Point start = as_point(ray.start);
        const Point end = as_point(ray.end);
        std::int64_t longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            longest = std::max(longest, std::abs(end[i] - start[i]));
        }
        const std::int64_t pieces = longest / marks.zone_sub() + 1;
        for (std::int64_t piece = 0; piece < pieces; ++piece) {
            Point least{};
            Point greatest{};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto at = [&](std::int64_t n) {
                    return start[i] + (end[i] - start[i]) * n / pieces;
                };
                least[i] = std::min(at(piece), at(piece + 1));
                greatest[i] = std::max(at(piece), at(piece + 1));
            }
            marks.mark(least, greatest);
        }
    }
    return marks.places();
}

} // namespace zonegrid::ops
