#include "support/oracle_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace zonegrid::oracle {

namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
constexpr float sky = std::numeric_limits<float>::infinity();

float special_depth(Random& random, double range_m) {
    switch (random.pick(0, 9)) {
        case 0:
            return missing;
        case 1:
            return 0.0F;
        case 2:
            return -sky;
        case 3:
            return sky;
        case 4:
            return std::numeric_limits<float>::max();
        case 5:
            return std::numeric_limits<float>::denorm_min();
        case 6:
            return -1.0F;
        case 7:
            return static_cast<float>(range_m);
        default:
            return static_cast<float>(random.real(0.0, 1.2 * range_m));
    }
}

/// Length of a pixel's direction whose third component is 1.
double direction_length(const Camera& camera, std::size_t pixel) {
    double x = 0.0;
    double y = 0.0;
    if (camera.directions.empty()) {
        const auto width = static_cast<std::size_t>(camera.width_px);
        x = (static_cast<double>(pixel % width) - camera.cx_px) / camera.fx_px;
        y = (static_cast<double>(pixel / width) - camera.cy_px) / camera.fy_px;
    } else {
        x = static_cast<double>(camera.directions[pixel].x());
        y = static_cast<double>(camera.directions[pixel].y());
    }
    return std::sqrt(x * x + y * y + 1.0);
}

float depth_near_range_end(Random& random, const MapperOptions& options, double length) {
    const double sub_m = options.cell_m / 256.0;
    const double limit_sub = std::floor(options.range_m / sub_m / length);
    const double place = limit_sub + static_cast<double>(random.whole(-2, 4)) / 2.0;
    float depth_m = static_cast<float>(place * sub_m);
    for (std::int64_t n = random.whole(0, 2); n > 0; --n) {
        depth_m = std::nextafter(depth_m, random.chance(0.5) ? 0.0F : sky);
    }
    return depth_m;
}

void add_directions(Random& random, Camera& camera) {
    const double bend = random.real(-0.1, 0.1);
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            const double x = (u - camera.cx_px) / camera.fx_px;
            const double y = (v - camera.cy_px) / camera.fy_px;
            const double more = 1.0 + bend * (x * x + y * y);
            camera.directions.emplace_back(static_cast<float>(x * more),
                                           static_cast<float>(y * more));
        }
    }
}

} // namespace

Camera random_camera(Random& random) {
    constexpr std::array<std::pair<int, int>, 8> sizes{
        {{1, 1}, {13, 7}, {5, 9}, {1, 8}, {6, 1}, {16, 12}, {3, 3}, {2, 11}}};
    Camera camera;
    std::tie(camera.width_px, camera.height_px) =
        sizes[static_cast<std::size_t>(random.pick(0, static_cast<int>(sizes.size()) - 1))];
    camera.fx_px = camera.width_px * random.real(0.35, 2.5);
    camera.fy_px = camera.height_px * random.real(0.35, 2.5);
    camera.cx_px = (camera.width_px - 1) * random.real(0.35, 0.65);
    camera.cy_px = (camera.height_px - 1) * random.real(0.35, 0.65);
    if (random.chance(0.3)) { // whole slopes: rays that meet edges and corners exactly
        camera.fx_px = std::max(1, (camera.width_px - 1) / 2);
        camera.fy_px = std::max(1, (camera.height_px - 1) / 2);
        camera.cx_px = (camera.width_px - 1) / 2;
        camera.cy_px = (camera.height_px - 1) / 2;
    }
    if (random.chance(0.33)) {
        add_directions(random, camera);
    }
    if (random.chance(0.6)) {
        camera.stereo = StereoNoise{random.real(0.05, 1.0), random.real(0.0, 1.5)};
    }
    if (random.chance(0.5)) {
        camera.body_from_camera.linear() = body_from_forward_camera();
    } else {
        camera.body_from_camera.linear() = random_attitude(random).toRotationMatrix();
    }
    if (random.chance(0.5)) {
        camera.body_from_camera.translation() =
            Eigen::Vector3d{random.real(-0.5, 0.5), random.real(-0.5, 0.5), random.real(-0.5, 0.5)};
    }
    return camera;
}

MapperOptions random_options(Random& random, double range_cells) {
    MapperOptions options;
    options.cell_m = random.chance(0.4) ? 1.0 : random.real(0.05, 2.0);
    options.range_m = options.cell_m * (random.chance(0.3) ? std::floor(range_cells)
                                                           : random.real(0.2, range_cells));
    options.zone = 8 << random.pick(0, 2);
    options.model = random.chance(0.5) ? SensorModel::line : SensorModel::span;
    options.span_sigmas = random.chance(0.5) ? 1.0 : random.real(0.0, 3.0);
    options.limit = random.chance(0.5) ? 8 : random.pick(1, 127);
    options.hit = random.pick(1, options.limit);
    options.miss = random.pick(1, options.limit);
    options.threshold = random.pick(1, options.limit);
    if (random.chance(0.3)) {
        options.hit = options.limit;
    }
    return options;
}

Eigen::Quaterniond random_attitude(Random& random) {
    if (random.chance(0.4)) {
        const Eigen::Quaterniond right(0.5, 0.5, 0.5, 0.5);
        Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
        for (int n = random.pick(0, 2); n > 0; --n) {
            turned = turned * right;
        }
        return turned;
    }
    Eigen::Quaterniond attitude{random.real(-1.0, 1.0), random.real(-1.0, 1.0),
                                random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    attitude.normalize();
    return attitude;
}

Eigen::Vector3d random_position(Random& random, double cell_m, double most) {
    const auto whole = static_cast<std::int64_t>(most);
    const bool all_exact = random.chance(0.3);
    const auto coordinate = [&]() -> double {
        if (all_exact || random.chance(0.2)) {
            return static_cast<double>(random.whole(-2 * whole, 2 * whole)) / 2.0 * cell_m;
        }
        return random.real(-most, most) * cell_m;
    };
    const double x_m = coordinate();
    const double y_m = coordinate();
    return {x_m, y_m, coordinate()};
}

std::vector<float> random_depths(Random& random, const Camera& camera, const MapperOptions& options,
                                 Picture picture) {
    const auto width = static_cast<std::size_t>(camera.width_px);
    const std::size_t pixels = width * static_cast<std::size_t>(camera.height_px);
    const auto range_m = options.range_m;
    const auto chosen = static_cast<std::size_t>(random.whole(0, camera.width_px - 1));
    const auto near_m = static_cast<float>(random.real(0.0, range_m));
    const auto far_m = static_cast<float>(random.real(0.0, 1.5 * range_m));
    std::vector<float> depths(pixels, missing);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        float& depth_m = depths[pixel];
        switch (picture) {
            case Picture::all_missing:
                depth_m = random.chance(0.5) ? missing : (random.chance(0.5) ? 0.0F : -near_m);
                break;
            case Picture::all_infinite:
                depth_m = sky;
                break;
            case Picture::one_pixel:
                depth_m = pixel == chosen ? near_m : missing;
                break;
            case Picture::noise:
                depth_m = static_cast<float>(random.real(0.0, 1.3 * range_m));
                break;
            case Picture::step:
                depth_m = pixel % width < chosen ? near_m : far_m;
                break;
            case Picture::range_end:
                depth_m = depth_near_range_end(random, options, direction_length(camera, pixel));
                break;
            case Picture::beyond:
                depth_m = static_cast<float>(random.real(1.01 * range_m, 100.0 * range_m));
                break;
            case Picture::mixed:
                depth_m = special_depth(random, range_m);
                break;
        }
    }
    return depths;
}

Camera seeing_camera(Random& random) {
    Camera camera = random_camera(random);
    while (std::min(camera.width_px, camera.height_px) < 3) {
        camera = random_camera(random);
    }
    if (random.chance(0.5)) { // where the navigation is: exactly where a test puts it
        camera.body_from_camera.translation().setZero();
    }
    return camera;
}

MapperOptions seeing_options(Random& random) {
    MapperOptions options = random_options(random, 9.0);
    options.hit = options.limit;
    options.range_m = options.cell_m *
                      (random.chance(0.5) ? random.pick(6, 11) + 0.3125 : random.real(6.0, 12.0));
    return options;
}

Eigen::Vector3d seeing_position(Random& random, double cell_m, int most) {
    const bool exact = random.chance(0.7);
    const auto coordinate = [&]() -> double {
        return exact ? random.pick(-16 * most, 16 * most) / 16.0 * cell_m
                     : random.real(-1.0, 1.0) * most * cell_m;
    };
    const double x_m = coordinate();
    const double y_m = coordinate();
    return {x_m, y_m, coordinate()};
}

std::vector<Eigen::Vector3f> filling_ends(const MapperOptions& options) {
    const int most = static_cast<int>(options.range_m / options.cell_m);
    std::vector<Eigen::Vector3f> ends;
    for (int x = -most; x < most; ++x) {
        for (int y = -most; y < most; ++y) {
            for (int z = -most; z < most; ++z) {
                const Eigen::Vector3d end_m =
                    Eigen::Vector3d{x + 0.5, y + 0.5, z + 0.5} * options.cell_m;
                if (end_m.norm() < options.range_m) {
                    ends.emplace_back(end_m.cast<float>());
                }
            }
        }
    }
    return ends;
}

std::vector<float> framed_depths(Random& random, const Camera& camera,
                                 const MapperOptions& options) {
    const bool whole = random.chance(0.3);
    const int first_u = whole ? 0 : random.pick(0, camera.width_px - 2);
    const int last_u = whole ? camera.width_px - 1 : random.pick(first_u + 1, camera.width_px - 1);
    const int first_v = whole ? 0 : random.pick(0, camera.height_px - 2);
    const int last_v =
        whole ? camera.height_px - 1 : random.pick(first_v + 1, camera.height_px - 1);
    std::vector<float> depths;
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            const bool inside = u >= first_u && u <= last_u && v >= first_v && v <= last_v;
            const float depth_m =
                random.chance(0.8) ? sky : static_cast<float>(0.5 * options.range_m);
            depths.push_back(inside && random.chance(0.9) ? depth_m
                                                          : (random.chance(0.5) ? missing : 0.0F));
        }
    }
    return depths;
}

} // namespace zonegrid::oracle
