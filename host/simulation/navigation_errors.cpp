#include "simulation/navigation_errors.h"

#include "simulation/counted_numbers.h"

#include <array>
#include <cmath>
#include <numbers>

namespace zonegrid {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;
constexpr double white_share = 0.1;

/// Deviations at scale 1 in the order of the numbers' parts: north, east, down, roll, pitch, yaw.
constexpr std::array<double, 6> deviations() {
    constexpr NavigationDeviations given;
    return {given.north_m,
            given.east_m,
            given.height_m,
            rad_per_deg * given.roll_deg,
            rad_per_deg * given.pitch_deg,
            rad_per_deg * given.yaw_deg};
}

/// The error of one component at each sample, in deviations (P. S. Maybeck, Stochastic Models,
/// Estimation, and Control, vol. 1, section 4.11).
std::vector<double> errors_of(std::span<const EulerSample> truth, double time_constant_s,
                              std::uint64_t seed, std::uint64_t component) {
    const CountedNumbers slow_numbers(seed, Stream::slow_errors, component);
    const CountedNumbers quick_numbers(seed, Stream::quick_errors, component);
    std::vector<double> errors(truth.size());
    double slow = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        double kept = 0.0; // before the first sample nothing is known
        if (i > 0) {
            const double gap_s = truth[i].sample.time_s - truth[i - 1].sample.time_s;
            kept = std::exp(-gap_s / time_constant_s);
        }
        slow = kept * slow + std::sqrt(1.0 - kept * kept) * slow_numbers.normal(i);
        errors[i] = slow + white_share * quick_numbers.normal(i);
    }
    return errors;
}

} // namespace

std::vector<EulerSample> with_errors(std::span<const EulerSample> truth,
                                     const NavigationFaults& faults, std::uint64_t seed) {
    std::vector<EulerSample> samples(truth.begin(), truth.end());
    if (faults.scale == 0.0) {
        return samples;
    }
    constexpr std::array<double, 6> sigmas = deviations();
    for (std::size_t component = 0; component < sigmas.size(); ++component) {
        const std::vector<double> errors =
            errors_of(truth, faults.time_constant_s, seed, component);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double error = faults.scale * sigmas[component] * errors[i];
            const auto axis = static_cast<Eigen::Index>(component % 3);
            if (component < 3) {
                samples[i].sample.position_m[axis] += error;
            } else {
                samples[i].roll_pitch_yaw_rad[axis] += error;
            }
        }
    }
    for (EulerSample& state : samples) {
        const Eigen::Vector3d& angles_rad = state.roll_pitch_yaw_rad;
        state.sample.world_from_body =
            attitude_from_euler(angles_rad.x(), angles_rad.y(), angles_rad.z());
    }
    return samples;
}

} // namespace zonegrid
