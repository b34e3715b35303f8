#include "io/profile_picture_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace zonegrid {
namespace {

constexpr double no_column = -std::numeric_limits<double>::infinity();

/// Heights of the frame's pixels, row by row from the north.
struct HeightPixels {
    int width = 0;
    int height = 0;
    std::vector<double> top_m;
    [[nodiscard]] double& at(int x, int y) {
        return top_m[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    }
    [[nodiscard]] double at(int x, int y) const {
        return const_cast<HeightPixels&>(*this).at(x, y);
    }
};

struct PixelSpan {
    int first = 0;
    int end = 0;
};

/// Pixels that a cell between two places covers: at least one, and without gaps between cells.
PixelSpan covered_pixels(double from_px, double to_px, int count) {
    // Edges that should fall on whole pixels may miss them by rounding.
    const auto first = static_cast<int>(std::floor(from_px + 1e-6));
    const auto end = std::max(first + 1, static_cast<int>(std::floor(to_px + 1e-6)));
    return {std::clamp(first, 0, count), std::clamp(end, 0, count)};
}

HeightPixels rasterise(const ProfileLayout& layout, const HeightProfile& profile) {
    HeightPixels pixels{layout.frame.width_px, layout.frame.height_px, {}};
    pixels.top_m.assign(
        static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height),
        no_column);
    const double cell_m = profile.cell_m;
    for (const ProfileColumn& column : profile.columns) {
        const PixelSpan xs = covered_pixels(
            layout.x_px(column.y * cell_m) - layout.frame.left_px,
            layout.x_px((column.y + 1.0) * cell_m) - layout.frame.left_px, pixels.width);
        const PixelSpan ys =
            covered_pixels(layout.y_px((column.x + 1.0) * cell_m) - layout.frame.top_px,
                           layout.y_px(column.x * cell_m) - layout.frame.top_px, pixels.height);
        const double height_m = top_m(column, cell_m);
        for (int y = ys.first; y < ys.end; ++y) {
            for (int x = xs.first; x < xs.end; ++x) {
                pixels.at(x, y) = std::max(pixels.at(x, y), height_m);
            }
        }
    }
    return pixels;
}

/// For each pixel along one axis, the pixels in the middle of the cells before and after its own;
/// where cells are smaller than pixels, the pixels before and after.
struct Neighbours {
    std::vector<int> before;
    std::vector<int> after;
};

/// `place(i)` is the coordinate in cells of pixel i's middle, growing or falling by `step`.
template <typename Place>
Neighbours find_neighbours(int count, double cell_px, Place place) {
    Neighbours result;
    const auto inside = [count](double pixel) {
        return std::clamp(static_cast<int>(std::floor(pixel)), 0, count - 1);
    };
    for (int i = 0; i < count; ++i) {
        const double in_cell = place(i) - std::floor(place(i)); // 0..1 from one edge of the cell
        const double middle = cell_px <= 1.0 ? i + 0.5 : i + 0.5 + (0.5 - in_cell) * cell_px;
        const double step = std::max(cell_px, 1.0);
        result.before.push_back(inside(middle - step));
        result.after.push_back(inside(middle + step));
    }
    return result;
}

/// Brightness by slope, 1 on flat ground; light from the north-west, 45 degrees up.
double relief(double rise_east, double rise_south) {
    // Steps of a cell are steep everywhere; damped, they leave room for true slopes.
    const double toward_light = 0.7071 * (rise_east + rise_south);
    const double slope = std::hypot(rise_east, rise_south);
    return 1.0 + 0.30 * toward_light / (1.0 + slope);
}

} // namespace

void draw_columns(Canvas& canvas, const ProfileLayout& layout, const HeightProfile& profile,
                  const HeightRange& range) {
    const HeightPixels pixels = rasterise(layout, profile);
    const double cell_px = layout.px_per_m * profile.cell_m;
    const double span_m = 2.0 * std::max(cell_px, 1.0) / layout.px_per_m;
    const Neighbours across = find_neighbours(pixels.width, cell_px, [&](int x) {
        return layout.east_m(layout.frame.left_px + x + 0.5) / profile.cell_m;
    });
    const Neighbours down = find_neighbours(pixels.height, cell_px, [&](int y) {
        return -layout.place_north_m(layout.frame.top_px + y + 0.5) / profile.cell_m;
    });
    const ColourTable colours(range.low_m, range.high_m);
    canvas.begin_pixels();
    for (int y = 0; y < pixels.height; ++y) {
        for (int x = 0; x < pixels.width; ++x) {
            const double own_m = pixels.at(x, y);
            if (own_m == no_column) {
                continue;
            }
            const auto known = [own_m](double height_m) {
                return height_m == no_column ? own_m : height_m;
            };
            const auto i = static_cast<std::size_t>(x);
            const auto j = static_cast<std::size_t>(y);
            const double rise_east =
                (known(pixels.at(across.after[i], y)) - known(pixels.at(across.before[i], y))) /
                span_m;
            const double rise_south =
                (known(pixels.at(x, down.after[j])) - known(pixels.at(x, down.before[j]))) / span_m;
            canvas.set_pixel(layout.frame.left_px + x, layout.frame.top_px + y,
                             shade(colours(own_m), relief(rise_east, rise_south)));
        }
    }
    canvas.end_pixels();
}

} // namespace zonegrid
