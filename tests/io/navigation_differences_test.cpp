#include "io/navigation_differences.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace zonegrid {
namespace {

/// Samples on x(t) = t^2 with leftovers that the functions must overwrite.
std::vector<NavigationSample> samples_at(std::initializer_list<double> times_s) {
    std::vector<NavigationSample> samples;
    for (const double time_s : times_s) {
        NavigationSample sample;
        sample.time_s = time_s;
        sample.position_m = {time_s * time_s, -time_s, 3.0};
        sample.velocity_mps = {9, 9, 9};
        sample.acceleration_mps2 = {9, 9, 9};
        sample.body_rate_radps = {9, 9, 9};
        samples.push_back(sample);
    }
    return samples;
}

TEST(NavigationDifferences, AreCentralInsideAndOneSidedAtTheEnds) {
    auto samples = samples_at({1.0, 1.05, 1.1});
    derive_velocities(samples);
    EXPECT_NEAR(samples[0].velocity_mps.x(), 2.05, 1e-12); // (1.1025 - 1) / 0.05
    EXPECT_NEAR(samples[1].velocity_mps.x(), 2.10, 1e-12); // the true derivative
    EXPECT_NEAR(samples[2].velocity_mps.x(), 2.15, 1e-12);
    for (const NavigationSample& sample : samples) {
        EXPECT_NEAR(sample.velocity_mps.y(), -1.0, 1e-12);
        EXPECT_EQ(sample.acceleration_mps2, Eigen::Vector3d::Zero());
    }
}

TEST(NavigationDifferences, DoNotReachAcrossGaps) {
    auto samples = samples_at({1.0, 1.05, 1.2, 1.25, 1.5, 1.75});
    derive_velocities(samples);
    EXPECT_NEAR(samples[1].velocity_mps.x(), 2.05, 1e-12);
    EXPECT_NEAR(samples[2].velocity_mps.x(), 2.45, 1e-12);
    EXPECT_NEAR(samples[3].velocity_mps.x(), 2.45, 1e-12);
    EXPECT_EQ(samples[4].velocity_mps, Eigen::Vector3d::Zero()); // alone between two gaps
    EXPECT_EQ(samples[5].velocity_mps, Eigen::Vector3d::Zero());
}

TEST(NavigationDifferences, TakeAStepOfJustATenthAsNoGap) {
    auto samples = samples_at({0.2, 0.1 * 3}); // 0.30000000000000004
    derive_velocities(samples);
    EXPECT_NEAR(samples[0].velocity_mps.y(), -1.0, 1e-9);
}

TEST(NavigationDifferences, OfASingleSampleAreZero) {
    auto samples = samples_at({1.0});
    derive_velocities(samples);
    derive_body_rates(samples);
    EXPECT_EQ(samples[0].velocity_mps, Eigen::Vector3d::Zero());
    EXPECT_EQ(samples[0].body_rate_radps, Eigen::Vector3d::Zero());
}

TEST(NavigationDifferences, GiveTurnRatesInTheBodyFrame) {
    // Pitched up by 90 degrees, then turning about the body's forward axis, which points up.
    const Eigen::Quaterniond start(Eigen::AngleAxisd(1.5707963267948966, Eigen::Vector3d::UnitY()));
    auto samples = samples_at({1.0, 1.02, 1.04, 1.06});
    for (NavigationSample& sample : samples) {
        const double turn_rad = 0.7 * (sample.time_s - 1.0);
        sample.world_from_body = start * Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitX());
    }
    samples[2].world_from_body.coeffs() *= -1.0; // the same attitude
    derive_body_rates(samples);
    for (const NavigationSample& sample : samples) {
        EXPECT_NEAR((sample.body_rate_radps - Eigen::Vector3d(0.7, 0, 0)).norm(), 0.0, 1e-9);
    }
}

} // namespace
} // namespace zonegrid
