#include "io/navigation_differences.h"

#include <cstddef>

namespace zonegrid {
namespace {

/// The samples before and after sample `index` that belong to it; both are `index` if it is alone.
struct Neighbours {
    std::size_t before;
    std::size_t after;
};

Neighbours neighbours_of(std::size_t index, std::span<const NavigationSample> samples) {
    // Times in seconds since 1970 are rounded to 0.24 us: a step of just 0.1 s is no gap.
    constexpr double largest_step_s = navigation_gap_s + 1e-6;
    Neighbours found{index, index};
    if (index > 0 && samples[index].time_s - samples[index - 1].time_s <= largest_step_s) {
        found.before = index - 1;
    }
    if (index + 1 < samples.size() &&
        samples[index + 1].time_s - samples[index].time_s <= largest_step_s) {
        found.after = index + 1;
    }
    return found;
}

/// The shorter way round: Eigen takes the quaternion's sign into account.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
    const Eigen::AngleAxisd turn(rotation);
    return turn.angle() * turn.axis();
}

} // namespace

void derive_velocities(std::span<NavigationSample> samples) {
    for (std::size_t index = 0; index < samples.size(); ++index) {
        NavigationSample& sample = samples[index];
        sample.velocity_mps.setZero();
        sample.acceleration_mps2.setZero();
        const auto [before, after] = neighbours_of(index, samples);
        if (before != after) {
            sample.velocity_mps = (samples[after].position_m - samples[before].position_m) /
                                  (samples[after].time_s - samples[before].time_s);
        }
    }
}

void derive_body_rates(std::span<NavigationSample> samples) {
    for (std::size_t index = 0; index < samples.size(); ++index) {
        samples[index].body_rate_radps.setZero();
        const auto [before, after] = neighbours_of(index, samples);
        if (before != after) {
            samples[index].body_rate_radps =
                rotation_vector(samples[before].world_from_body.conjugate() *
                                samples[after].world_from_body) /
                (samples[after].time_s - samples[before].time_s);
        }
    }
}

} // namespace zonegrid
