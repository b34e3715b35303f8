#include "simulation/simulation.h"

#include "model/navigation.h"
#include "simulation/clock.h"
#include "simulation/counted_numbers.h"
#include "simulation/motion.h"
#include "simulation/navigation_errors.h"
#include "simulation/vibration.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

/// Times in a list must differ.
constexpr double least_gap_s = 1e-6;
constexpr double between_way_points_s = 0.1;
/// Of images or navigation: some gigabytes.
constexpr double most_samples = 2e7;

/// The flight's length: as asked, as the scene says, or to the end of the route.
double duration_of(const Scene& scene, const SimulationOptions& options) {
    const std::optional<double> wanted_s =
        options.duration_s ? options.duration_s : scene.duration_s;
    if (!wanted_s && scene.route.loop) {
        throw UsageError(
            fmt::format("the route of scene '{}' is a loop without an end: give the "
                        "flight's seconds",
                        scene.name));
    }
    return wanted_s ? *wanted_s : Motion(scene.route).end_s();
}

/// Throws UsageError unless the times of so long a flight fit into memory.
void require_measurable(const Scene& scene, double duration_s) {
    const double most_hz = std::max(scene.image_rate_hz, scene.navigation_rate_hz);
    if (most_hz * duration_s > most_samples) {
        throw UsageError(
            fmt::format("a flight of {:.0f} s at {:g} Hz has more than {:g} samples: give fewer "
                        "seconds or lower rates",
                        duration_s, most_hz, most_samples));
    }
}

std::vector<EulerSample> true_navigation(const Motion& motion, const Scene& scene,
                                         double duration_s, std::uint64_t seed) {
    std::vector<EulerSample> states;
    for (const double time_s : clock_times(scene.navigation_rate_hz, duration_s,
                                           CountedNumbers(seed, Stream::navigation_clock))) {
        states.push_back(motion.at(time_s));
    }
    return states;
}

std::vector<TrueImage> take_images(const Motion& motion, const Scene& scene, double duration_s,
                                   const SimulationOptions& options) {
    const Vibration vibration(options.sensor.vibration_deg, options.seed);
    std::vector<TrueImage> images;
    for (const double time_s : clock_times(scene.image_rate_hz, duration_s,
                                           CountedNumbers(options.seed, Stream::image_clock))) {
        const NavigationSample state = motion.at(time_s).sample;
        Eigen::Isometry3d body = Eigen::Isometry3d::Identity();
        body.linear() = state.world_from_body.toRotationMatrix();
        body.translation() = state.position_m;
        images.push_back({time_s, mount_sensor(mount_sensor(body, vibration.at(time_s)),
                                               scene.camera.body_from_camera)});
    }
    return images;
}

double way_of(const Motion& motion, double duration_s) {
    double way_m = 0.0;
    Eigen::Vector3d last_m = motion.at(0.0).sample.position_m;
    for (double time_s = 0.0; time_s < duration_s; time_s += between_way_points_s) {
        const Eigen::Vector3d now_m = motion.at(time_s).sample.position_m;
        way_m += (now_m - last_m).norm();
        last_m = now_m;
    }
    return way_m;
}

/// Which images reach the recording, and when it says they were taken.
void record_images(const TransferFaults& faults, std::uint64_t seed, SimulatedFlight& flight) {
    const CountedNumbers late(seed, Stream::late_images);
    const CountedNumbers lost(seed, Stream::lost_images);
    for (std::uint64_t i = 0; i < flight.taken.size(); ++i) {
        if (lost.share(i) < faults.lost_images) {
            continue;
        }
        double time_s = flight.taken[i].time_s;
        if (late.share(2 * i) < faults.late_images) {
            time_s += faults.late_by_s * (1.0 - late.share(2 * i + 1));
        }
        if (!flight.image_times_s.empty()) { // no image overtakes another
            time_s = std::max(time_s, flight.image_times_s.back() + least_gap_s);
        }
        flight.images_late += time_s > flight.taken[i].time_s ? 1U : 0U;
        flight.numbers.push_back(i);
        flight.image_times_s.push_back(time_s);
        flight.truth.images.push_back(flight.taken[i]);
    }
    if (flight.numbers.empty()) {
        throw UsageError("no image is left of the flight: make it longer, or lose fewer images");
    }
}

void record_navigation(const std::vector<EulerSample>& truth, const SimulationOptions& options,
                       SimulatedFlight& flight) {
    const std::vector<EulerSample> said = with_errors(truth, options.navigation, options.seed);
    const CountedNumbers lost(options.seed, Stream::lost_navigation);
    for (std::uint64_t i = 0; i < said.size(); ++i) {
        if (lost.share(i) < options.transfer.lost_navigation) {
            ++flight.navigation_lost;
        } else {
            flight.navigation.push_back(said[i]);
            flight.truth.navigation.push_back(truth[i].sample);
        }
    }
    if (flight.navigation.empty()) {
        throw UsageError(
            "no navigation sample is left of the flight: make it longer, or lose fewer samples");
    }
}

} // namespace

SimulatedFlight fly(const Scene& scene, const SimulationOptions& options) {
    SimulatedFlight flight;
    flight.duration_s = duration_of(scene, options);
    require_measurable(scene, flight.duration_s);
    const Motion motion(scene.route, flight.duration_s);
    flight.way_m = way_of(motion, flight.duration_s);
    flight.taken = take_images(motion, scene, flight.duration_s, options);
    flight.images_taken = flight.taken.size();
    record_images(options.transfer, options.seed, flight);
    record_navigation(true_navigation(motion, scene, flight.duration_s, options.seed), options,
                      flight);
    flight.truth.scene = scene.name;
    flight.truth.seed = options.seed;
    flight.truth.camera = scene.camera;
    flight.truth.surfaces = scene.surfaces;
    for (const SecondVehicle& vehicle : scene.vehicles) {
        flight.truth.motions.push_back(motion_of(vehicle, flight.duration_s));
    }
    return flight;
}

std::uint16_t depth_value(float depth_m) {
    constexpr std::uint16_t infinite = 65535;
    constexpr double most = 65534.0;
    if (depth_m == 0.0F) {
        return 0;
    }
    const double value = std::round(static_cast<double>(depth_m) * simulated_units_per_m);
    return value > most ? infinite : static_cast<std::uint16_t>(std::max(value, 1.0));
}

std::string fault_arguments(const SimulationOptions& options) {
    std::string text;
    const auto add = [&text](const char* name, double value) {
        if (value != 0.0) {
            text += fmt::format("{}--{} {}", text.empty() ? "" : " ", name, value);
        }
    };
    constexpr double ms_per_s = 1000.0;
    add("stereo-noise", options.sensor.disparity_sigma_px);
    add("quantise", options.sensor.disparity_step_px);
    add("missing", options.sensor.missing);
    add("bleeding", options.sensor.bleeding_px);
    add("outliers", options.sensor.outlier_share);
    if (options.sensor.missing_sky) {
        text += text.empty() ? "--missing-sky" : " --missing-sky";
    }
    add("vibration", options.sensor.vibration_deg);
    add("screen", options.sensor.screen_px);
    add("navigation-errors", options.navigation.scale);
    if (options.navigation.scale != 0.0) {
        add("navigation-constant", options.navigation.time_constant_s);
    }
    add("late-images", options.transfer.late_images);
    if (options.transfer.late_images != 0.0) {
        add("late-by", ms_per_s * options.transfer.late_by_s);
    }
    add("lost-images", options.transfer.lost_images);
    add("lost-navigation", options.transfer.lost_navigation);
    return text;
}

} // namespace zonegrid
