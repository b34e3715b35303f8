#include "io/generated_depths.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace zonegrid {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
constexpr float sky = std::numeric_limits<float>::infinity();

enum class Picture { blank, all_sky, one_pixel, noise, steps, wall, range_end, everything };

// A blank image or a sky teaches little: walls and steps come more often.
constexpr std::array pictures{
    Picture::blank,     Picture::all_sky,    Picture::one_pixel, Picture::noise, Picture::noise,
    Picture::steps,     Picture::steps,      Picture::steps,     Picture::wall,  Picture::wall,
    Picture::range_end, Picture::everything, Picture::everything};

float depth_of_any_kind(SeededNumbers& numbers, double range_m) {
    const auto ordinary = static_cast<float>(numbers.real(0.0, 1.2 * range_m));
    const std::array kinds{missing,
                           0.0F,
                           -1.0F,
                           -sky,
                           sky,
                           sky,
                           std::numeric_limits<float>::max(),
                           std::numeric_limits<float>::min(),
                           std::numeric_limits<float>::denorm_min(),
                           static_cast<float>(range_m)};
    return numbers.chance(0.4) ? ordinary : numbers.one_of(kinds);
}

/// Length of a pixel's direction whose third component is 1.
double direction_length(const Camera& camera, int u, int v) {
    double x = (u - camera.cx_px) / camera.fx_px;
    double y = (v - camera.cy_px) / camera.fy_px;
    if (!camera.directions.empty()) {
        const auto width = static_cast<std::size_t>(camera.width_px);
        const auto& slope =
            camera.directions[static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u)];
        x = static_cast<double>(slope.x());
        y = static_cast<double>(slope.y());
    }
    return std::sqrt(x * x + y * y + 1.0);
}

/// A depth whose point lies within two sub-cells of the range, on either side.
float depth_at_range(SeededNumbers& numbers, const MapperOptions& options, double length) {
    const double sub_m = options.cell_m / 256.0;
    const double limit = std::floor(options.range_m / sub_m / length);
    return static_cast<float>((limit + 0.5 * numbers.whole(-3, 4)) * sub_m);
}

} // namespace

std::vector<float> generate_depths(SeededNumbers& numbers, const Camera& camera,
                                   const MapperOptions& options) {
    const Picture picture = numbers.one_of(pictures);
    const double range_m = options.range_m;
    const auto near_m = static_cast<float>(numbers.real(0.0, range_m));
    const auto far_m =
        numbers.chance(0.2) ? sky : static_cast<float>(numbers.real(0.0, 1.5 * range_m));
    const int edge_u = numbers.whole(0, camera.width_px - 1);
    const int edge_v = numbers.whole(0, camera.height_px - 1);
    const double slope = numbers.real(-0.5, 0.5) / camera.width_px;
    const double holes = numbers.chance(0.3) ? 0.2 : 0.0;
    std::vector<float> depths;
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            float depth_m = missing;
            switch (picture) {
                case Picture::blank:
                    depth_m = numbers.chance(0.5) ? missing : -near_m;
                    break;
                case Picture::all_sky:
                    depth_m = sky;
                    break;
                case Picture::one_pixel:
                    depth_m = u == edge_u && v == edge_v ? near_m : missing;
                    break;
                case Picture::noise:
                    depth_m = static_cast<float>(numbers.real(0.0, 1.3 * range_m));
                    break;
                case Picture::steps:
                    depth_m = (u < edge_u) != (v < edge_v) ? near_m : far_m;
                    break;
                case Picture::wall:
                    depth_m = near_m * static_cast<float>(1.0 + slope * u);
                    break;
                case Picture::range_end:
                    depth_m = depth_at_range(numbers, options, direction_length(camera, u, v));
                    break;
                case Picture::everything:
                    depth_m = depth_of_any_kind(numbers, range_m);
                    break;
            }
            depths.push_back(numbers.chance(holes) ? missing : depth_m);
        }
    }
    return depths;
}

std::vector<Eigen::Vector3f> generate_scan(SeededNumbers& numbers, const MapperOptions& options) {
    const bool exact = numbers.chance(0.3); // ends on borders, rays along axes and diagonals
    const double most_m = numbers.real(0.3, 1.3) * options.range_m;
    const auto coordinate = [&] {
        const double cells = numbers.real(-most_m, most_m) / options.cell_m;
        return static_cast<float>((exact ? std::round(cells) : cells) * options.cell_m);
    };
    std::vector<Eigen::Vector3f> ends(static_cast<std::size_t>(numbers.whole(1, 300)));
    for (Eigen::Vector3f& end : ends) {
        const float x = coordinate();
        const float y = coordinate();
        end = {x, y, coordinate()};
        if (numbers.chance(0.05)) {
            end[numbers.whole(0, 2)] = numbers.chance(0.5) ? missing : sky;
        }
    }
    return ends;
}

} // namespace zonegrid
