#include "io/profile_perspective_raster.h"

#include <algorithm>
#include <cmath>

namespace zonegrid {

BlockRaster::BlockRaster(int width_px, int height_px, int samples)
    : samples_(samples), width_(width_px * samples), height_(height_px * samples) {
    inverse_depth_.assign(index(0, height_), 0.0F);
    height_m_.assign(index(0, height_), 0.0F);
    brightness_.assign(index(0, height_), 0.0F);
}

void BlockRaster::fill_quad(const std::array<RasterCorner, 4>& corners, double brightness) {
    const auto value = static_cast<float>(brightness);
    fill_triangle(corners[0], corners[1], corners[2], value);
    fill_triangle(corners[0], corners[2], corners[3], value);
}

void BlockRaster::fill_triangle(const RasterCorner& a, const RasterCorner& b, const RasterCorner& c,
                                float brightness) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x});
    const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
    // Samples lie in the middle of their squares.
    const int x_first = std::max(0, static_cast<int>(std::ceil(x_low - 0.5)));
    const int x_last = std::min(width_ - 1, static_cast<int>(std::floor(x_high - 0.5)));
    const int y_first = std::max(0, static_cast<int>(std::ceil(y_low - 0.5)));
    const int y_last = std::min(height_ - 1, static_cast<int>(std::floor(y_high - 0.5)));
    if (x_first > x_last || y_first > y_last || std::abs(area) < 1e-12) {
        return;
    }
    // Shares of b and c in a sample grow evenly along rows and columns.
    const double b_per_x = (c.y - a.y) / area;
    const double b_per_y = -(c.x - a.x) / area;
    const double c_per_x = -(b.y - a.y) / area;
    const double c_per_y = (b.x - a.x) / area;
    // Samples on a shared edge belong to both faces: no cracks, and the depth decides.
    constexpr double slack = 1e-9;
    for (int y = y_first; y <= y_last; ++y) {
        for (int x = x_first; x <= x_last; ++x) {
            const double dx = x + 0.5 - a.x;
            const double dy = y + 0.5 - a.y;
            const double share_b = dx * b_per_x + dy * b_per_y;
            const double share_c = dx * c_per_x + dy * c_per_y;
            const double share_a = 1.0 - share_b - share_c;
            if (share_a < -slack || share_b < -slack || share_c < -slack) {
                continue;
            }
            const double inverse_depth =
                share_a * a.inverse_depth + share_b * b.inverse_depth + share_c * c.inverse_depth;
            const std::size_t i = index(x, y);
            if (inverse_depth <= static_cast<double>(inverse_depth_[i])) {
                continue;
            }
            // Height over depth is even on the screen, height itself is not.
            const double height_over_depth = share_a * a.height_m * a.inverse_depth +
                                             share_b * b.height_m * b.inverse_depth +
                                             share_c * c.height_m * c.inverse_depth;
            inverse_depth_[i] = static_cast<float>(inverse_depth);
            height_m_[i] = static_cast<float>(height_over_depth / inverse_depth);
            brightness_[i] = brightness;
        }
    }
}

bool BlockRaster::hides(const SeenPoint& point) const {
    const double x = std::floor(point.x_px * samples_);
    const double y = std::floor(point.y_px * samples_);
    if (!(x >= 0.0 && y >= 0.0 && x < width_ && y < height_)) {
        return false;
    }
    const float there = inverse_depth_[index(static_cast<int>(x), static_cast<int>(y))];
    return static_cast<double>(there) > point.inverse_depth * 1.0005;
}

double BlockRaster::rim_brightness(int x, int y, double slope_per_sample) const {
    const auto own = static_cast<double>(inverse_depth_[index(x, y)]);
    const int reach = samples_;
    double darkness = 0.0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int there_x = std::clamp(x + dx * reach, 0, width_ - 1);
            const int there_y = std::clamp(y + dy * reach, 0, height_ - 1);
            const double nearer =
                static_cast<double>(inverse_depth_[index(there_x, there_y)]) / own - 1.0;
            const double level_steps = nearer / (slope_per_sample * reach);
            darkness += std::clamp((level_steps - 5.0) / 40.0, 0.0, 1.0);
        }
    }
    return 1.0 - 0.5 * std::min(1.0, darkness / 4.0);
}

void BlockRaster::paint(Canvas& canvas, const ColourTable& colours, double slope_per_sample) const {
    canvas.begin_pixels();
    for (int y_px = 0; y_px < canvas.height_px(); ++y_px) {
        for (int x_px = 0; x_px < canvas.width_px(); ++x_px) {
            int covered = 0;
            std::array<int, 3> sum{};
            for (int s = 0; s < samples_ * samples_; ++s) {
                const int x = x_px * samples_ + s % samples_;
                const int y = y_px * samples_ + s / samples_;
                const std::size_t i = index(x, y);
                if (inverse_depth_[i] <= 0.0F) {
                    continue;
                }
                const Rgb colour = shade(
                    colours(static_cast<double>(height_m_[i])),
                    static_cast<double>(brightness_[i]) * rim_brightness(x, y, slope_per_sample));
                sum[0] += colour.r;
                sum[1] += colour.g;
                sum[2] += colour.b;
                ++covered;
            }
            if (covered == 0) {
                continue;
            }
            const Rgb under = canvas.pixel(x_px, y_px);
            const int all = samples_ * samples_;
            const auto mixed = [&](int total, std::uint8_t below) {
                return static_cast<std::uint8_t>((total + (all - covered) * below) / all);
            };
            canvas.set_pixel(
                x_px, y_px,
                {mixed(sum[0], under.r), mixed(sum[1], under.g), mixed(sum[2], under.b)});
        }
    }
    canvas.end_pixels();
}

} // namespace zonegrid
