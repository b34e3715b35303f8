#include "io/generated_flight.h"

#include "io/generated_depths.h"
#include "io/plain_camera.h"
#include "io/plain_description.h"
#include "io/pose_conversion.h"
#include "io/seeded_numbers.h"
#include "model/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace zonegrid {
namespace {

constexpr double first_time_s = 100.0;
constexpr double between_images_s = 0.125; // whole numbers of it are exact
constexpr double quarter_turn_rad = std::numbers::pi / 2.0;

MapperOptions generate_options(SeededNumbers& numbers) {
    MapperOptions options;
    options.cell_m = numbers.chance(0.4) ? 0.5 : numbers.real(0.05, 2.0);
    const double cells = numbers.chance(0.1) ? numbers.real(30.0, 90.0) : numbers.real(0.5, 24.0);
    options.range_m = options.cell_m * (numbers.chance(0.3) ? std::ceil(cells) : cells);
    options.zone = 8 << numbers.whole(0, 2);
    options.model = numbers.chance(0.5) ? SensorModel::span : SensorModel::line;
    options.span_sigmas = numbers.chance(0.5) ? 1.0 : numbers.real(0.0, 3.0);
    options.limit = numbers.one_of(std::array{8, 8, 1, 2, 5, 127});
    options.hit =
        numbers.chance(0.2) ? options.limit : numbers.whole(1, std::min(options.limit, 9));
    options.miss =
        numbers.chance(0.2) ? options.limit : numbers.whole(1, std::min(options.limit, 4));
    options.threshold = numbers.whole(1, options.limit);
    if (numbers.chance(0.5)) { // one hit is an obstacle: flights with objects
        options.threshold = options.hit;
    }
    return options;
}

/// A lens: the ideal slopes pulled towards the axis or away from it.
void add_directions(SeededNumbers& numbers, Camera& camera) {
    const double bend = numbers.real(-0.08, 0.08);
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            const double x = (u - camera.cx_px) / camera.fx_px;
            const double y = (v - camera.cy_px) / camera.fy_px;
            const double factor = 1.0 + bend * (x * x + y * y);
            camera.directions.emplace_back(static_cast<float>(x * factor),
                                           static_cast<float>(y * factor));
        }
    }
    Camera fitted = camera;
    if (fit_mean_spacing(fitted)) {
        camera = std::move(fitted);
    } else {
        camera.directions.clear();
    }
}

Camera generate_camera(SeededNumbers& numbers) {
    constexpr std::array<std::array<int, 2>, 12> sizes{{{1, 1},
                                                        {13, 7},
                                                        {5, 9},
                                                        {1, 8},
                                                        {7, 1},
                                                        {17, 12},
                                                        {3, 3},
                                                        {2, 11},
                                                        {33, 5},
                                                        {24, 18},
                                                        {31, 23},
                                                        {65, 49}}};
    Camera camera;
    const auto& size = numbers.one_of(sizes);
    camera.width_px = size[0];
    camera.height_px = size[1];
    if (numbers.chance(0.3)) { // whole slopes: rays through edges and corners of cells
        camera.fx_px = std::max(1, (camera.width_px - 1) / 2);
        camera.fy_px = std::max(1, (camera.height_px - 1) / 2);
        camera.cx_px = std::floor((camera.width_px - 1) / 2.0);
        camera.cy_px = std::floor((camera.height_px - 1) / 2.0);
    } else {
        camera.fx_px = camera.width_px * numbers.real(0.4, 2.5);
        camera.fy_px = camera.height_px * numbers.real(0.4, 2.5);
        camera.cx_px = (camera.width_px - 1) * numbers.real(0.4, 0.6);
        camera.cy_px = (camera.height_px - 1) * numbers.real(0.4, 0.6);
        if (camera.width_px > 1 && camera.height_px > 1 && numbers.chance(0.3)) {
            add_directions(numbers, camera);
        }
    }
    if (numbers.chance(0.6)) {
        camera.stereo = StereoNoise{numbers.real(0.05, 1.0), numbers.real(0.1, 1.5)};
    }
    return camera;
}

SensorMounting generate_mounting(SeededNumbers& numbers) {
    SensorMounting mounting;
    if (numbers.chance(0.4)) {
        for (int axis = 0; axis < 3; ++axis) {
            mounting.position_m[axis] = numbers.real(-0.5, 0.5);
        }
    }
    if (numbers.chance(0.5)) {
        mounting.roll_pitch_yaw_deg = {numbers.real(-20.0, 20.0), numbers.real(-90.0, 30.0),
                                       numbers.real(-180.0, 180.0)};
    }
    return mounting;
}

/// Where the body is at each image.
class Path {
public:
    Path(SeededNumbers& numbers, const FlightPlan& plan, int images)
        : numbers_(numbers),
          cell_m_(plan.options.cell_m),
          zone_m_(plan.options.zone * plan.options.cell_m),
          images_(images),
          window_m_(make_window(plan.options, plan.camera).edge_cells() * plan.options.cell_m) {
        const double furthest_cells = numbers.chance(0.1) ? 0x1.0p+29 : 40.0;
        for (int axis = 0; axis < 3; ++axis) {
            home_m_[axis] = place(numbers.real(-1.0, 1.0) * furthest_cells * cell_m_);
            away_m_[axis] = numbers.chance(0.4) ? 0.0 : numbers.real(-1.6, 1.6) * window_m_;
        }
        shape_ = numbers.one_of(
            std::array{Shape::hover, Shape::out_and_back, Shape::out_and_back, Shape::wander});
    }

    [[nodiscard]] bool hovers() const { return shape_ == Shape::hover; }

    Eigen::Vector3d at(int image) {
        // Out by the middle of the flight; the last two images are from home again.
        const double share = std::min(image, std::max(images_ - 2 - image, 0)) * 2.0 / images_;
        Eigen::Vector3d position_m = home_m_;
        for (int axis = 0; axis < 3; ++axis) {
            if (shape_ == Shape::out_and_back) {
                position_m[axis] = place(home_m_[axis] + share * away_m_[axis]);
            } else if (shape_ == Shape::wander) {
                position_m[axis] = place(home_m_[axis] + numbers_.real(-3.0, 3.0) * zone_m_);
            }
        }
        return position_m;
    }

private:
    enum class Shape { hover, out_and_back, wander };

    /// Near `metres`: often on a border of zones or cells, or in the middle of a cell.
    double place(double metres) {
        switch (numbers_.whole(0, 5)) {
            case 0:
                return std::round(metres / zone_m_) * zone_m_;
            case 1:
                return std::round(metres / cell_m_) * cell_m_;
            case 2:
                return (std::round(metres / cell_m_) + 0.5) * cell_m_;
            default:
                return metres;
        }
    }

    SeededNumbers& numbers_;
    double cell_m_;
    double zone_m_;
    int images_;
    double window_m_;
    Eigen::Vector3d home_m_;
    Eigen::Vector3d away_m_;
    Shape shape_ = Shape::hover;
};

Eigen::Vector3d generate_attitude(SeededNumbers& numbers) {
    if (numbers.chance(0.4)) { // level, on one of the axes
        return {0.0, 0.0, numbers.whole(0, 3) * quarter_turn_rad};
    }
    return {numbers.real(-0.6, 0.6), numbers.real(-1.5, 1.5), numbers.real(-3.2, 3.2)};
}

EulerSample generate_sample(SeededNumbers& numbers, double image_time_s,
                            const Eigen::Vector3d& position_m) {
    EulerSample generated;
    NavigationSample& sample = generated.sample;
    sample.time_s = image_time_s;
    sample.position_m = position_m;
    generated.roll_pitch_yaw_rad = generate_attitude(numbers);
    sample.world_from_body =
        attitude_from_euler(generated.roll_pitch_yaw_rad.x(), generated.roll_pitch_yaw_rad.y(),
                            generated.roll_pitch_yaw_rad.z());
    if (numbers.chance(0.4)) { // the pose is carried over a gap, of which 1 in 16 is too long
        sample.time_s += numbers.real(-0.05, 0.05) * 16.0 / 15.0;
        for (int axis = 0; axis < 3; ++axis) {
            sample.velocity_mps[axis] = numbers.real(-10.0, 10.0);
            sample.acceleration_mps2[axis] = numbers.real(-3.0, 3.0);
            sample.body_rate_radps[axis] = numbers.real(-2.0, 2.0);
        }
    }
    return generated;
}

FrameData generate_frame(SeededNumbers& numbers, const FlightPlan& plan) {
    FrameData frame;
    if (plan.camera) {
        frame.depth_m = generate_depths(numbers, *plan.camera, plan.options);
    } else {
        frame.ends_m = generate_scan(numbers, plan.options);
    }
    return frame;
}

RecordingContents contents_of(const FlightPlan& plan) {
    RecordingContents contents;
    contents.layout = "generated";
    contents.camera = plan.camera;
    const Eigen::Vector3d& deg = plan.mounting.roll_pitch_yaw_deg;
    Eigen::Isometry3d mounting = Eigen::Isometry3d::Identity();
    mounting.translation() = plan.mounting.position_m;
    mounting.linear() =
        mounted_rotation(deg.x(), deg.y(), deg.z(),
                         plan.camera ? body_from_forward_camera() : body_from_forward_left_up());
    if (contents.camera) {
        contents.camera->body_from_camera = mounting;
    } else {
        contents.body_from_sensor = mounting;
    }
    for (const EulerSample& generated : plan.navigation) {
        contents.navigation.push_back(generated.sample);
    }
    for (std::size_t i = 0; i < plan.times_s.size(); ++i) {
        const std::string file = fmt::format("frames/{:06}.npy", i + 1);
        contents.frames.push_back({plan.times_s[i], file, file});
    }
    return contents;
}

} // namespace

FlightPlan plan_flight(std::uint64_t seed, std::uint64_t number) {
    SeededNumbers numbers(seed, number);
    FlightPlan plan;
    plan.options = generate_options(numbers);
    if (number % 5 != 4) {
        plan.camera = generate_camera(numbers);
    }
    plan.mounting = generate_mounting(numbers);
    const int images = numbers.whole(4, 8);
    Path path(numbers, plan, images);
    for (int image = 0; image < images; ++image) {
        const double time_s = first_time_s + image * between_images_s;
        if (image > 0 && path.hovers()) { // the same again, until cells reach their limits
            EulerSample sample = plan.navigation.back();
            sample.sample.time_s += between_images_s;
            plan.navigation.push_back(sample);
            plan.frames.push_back(numbers.chance(0.7) ? plan.frames.back()
                                                      : generate_frame(numbers, plan));
        } else {
            plan.navigation.push_back(generate_sample(numbers, time_s, path.at(image)));
            plan.frames.push_back(generate_frame(numbers, plan));
        }
        plan.times_s.push_back(time_s);
    }
    return plan;
}

GeneratedFlight::GeneratedFlight(FlightPlan plan)
    : Recording(contents_of(plan)), plan_(std::move(plan)) {}

GeneratedFlight::GeneratedFlight(std::uint64_t seed, std::uint64_t number)
    : GeneratedFlight(plan_flight(seed, number)) {}

FrameData GeneratedFlight::read_frame(std::size_t index) const {
    require_frame(index);
    return plan_.frames[index];
}

} // namespace zonegrid
