#include "simulation/navigation_errors.h"

#include "simulation/clock.h"
#include "simulation/vibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace zonegrid::testing {
namespace {

constexpr double deg_per_rad = 180.0 / std::numbers::pi;

std::vector<EulerSample> resting(std::size_t count, double step_s) {
    std::vector<EulerSample> samples(count);
    for (std::size_t i = 0; i < count; ++i) {
        samples[i].sample.time_s = static_cast<double>(i) * step_s;
        samples[i].sample.position_m = {10.0, 20.0, -30.0};
    }
    return samples;
}

/// North, east, down in metres, roll, pitch, yaw in degrees, less what is true.
std::array<double, 6> errors_of(const EulerSample& said) {
    const Eigen::Vector3d position_m = said.sample.position_m - Eigen::Vector3d(10.0, 20.0, -30.0);
    const Eigen::Vector3d angles_deg = deg_per_rad * said.roll_pitch_yaw_rad;
    return {position_m.x(), position_m.y(), position_m.z(),
            angles_deg.x(), angles_deg.y(), angles_deg.z()};
}

TEST(NavigationErrors, HaveTheirDeviationsAndTimeConstant) {
    // 20000 times the time constant of 0.5 s: means of squares are known within a few hundredths.
    constexpr double step_s = 0.05;
    constexpr std::size_t count = 200000;
    NavigationFaults faults;
    faults.scale = 2.0;
    faults.time_constant_s = 0.5;
    const std::vector<EulerSample> said = with_errors(resting(count, step_s), faults, 5);
    constexpr std::array<double, 6> sigmas{0.20, 0.20, 0.50, 0.7, 4.0, 3.0};
    for (std::size_t component = 0; component < 6; ++component) {
        const auto mean_product = [&](std::size_t lag) {
            double sum = 0.0;
            for (std::size_t i = lag; i < count; ++i) {
                sum += errors_of(said[i])[component] * errors_of(said[i - lag])[component];
            }
            return sum / static_cast<double>(count - lag) /
                   (4.0 * sigmas[component] * sigmas[component]);
        };
        EXPECT_NEAR(mean_product(0), 1.01, 0.04) << component; // slow and a tenth white
        EXPECT_NEAR(mean_product(1), std::exp(-0.1), 0.04) << component;
        EXPECT_NEAR(mean_product(10), std::exp(-1.0), 0.04) << component;
        EXPECT_NEAR(mean_product(200), 0.0, 0.04) << component;
    }
}

TEST(NavigationErrors, AreThereFromTheFirstSampleOn) {
    NavigationFaults faults;
    faults.scale = 1.0;
    double squares = 0.0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        const double north = errors_of(with_errors(resting(1, 0.01), faults, seed)[0])[0];
        squares += north * north / 2000.0;
    }
    EXPECT_NEAR(std::sqrt(squares), 0.201, 0.01);
}

TEST(NavigationErrors, TurnTheAttitudeAndNothingElse) {
    NavigationFaults faults;
    faults.scale = 1.0;
    std::vector<EulerSample> truth = resting(10, 0.01);
    truth[3].sample.velocity_mps = {1.0, 2.0, 3.0};
    const std::vector<EulerSample> said = with_errors(truth, faults, 1);
    EXPECT_EQ(said[3].sample.velocity_mps, truth[3].sample.velocity_mps);
    const Eigen::Vector3d& angles = said[3].roll_pitch_yaw_rad;
    EXPECT_GT(angles.norm(), 1e-3);
    EXPECT_NEAR(said[3].sample.world_from_body.angularDistance(
                    attitude_from_euler(angles.x(), angles.y(), angles.z())),
                0.0, 1e-12);
    faults.scale = 0.0;
    EXPECT_EQ(with_errors(truth, faults, 1)[5].sample.position_m, truth[5].sample.position_m);
}

TEST(Clock, RunsAtItsRateWithJitterFromAPhaseOfItsOwn) {
    const std::vector<double> first =
        clock_times(30.0, 100.0, CountedNumbers(1, Stream::image_clock));
    EXPECT_NEAR(static_cast<double>(first.size()), 3000.0, 1.0);
    double least_s = 1.0;
    double most_s = 0.0;
    for (std::size_t i = 1; i < first.size(); ++i) {
        least_s = std::min(least_s, first[i] - first[i - 1]);
        most_s = std::max(most_s, first[i] - first[i - 1]);
        // Jitter does not add up.
        EXPECT_NEAR(first[i] - first[0], static_cast<double>(i) / 30.0, 0.04 / 30.0 + 2e-6);
    }
    EXPECT_GT(least_s, 0.95 / 30.0);
    EXPECT_LT(least_s, 0.97 / 30.0);
    EXPECT_LT(most_s, 1.05 / 30.0);
    EXPECT_GT(most_s, 1.03 / 30.0);
    EXPECT_GE(first.front(), 0.0);
    EXPECT_LE(first.back(), 100.0);
    const std::vector<double> second =
        clock_times(30.0, 100.0, CountedNumbers(2, Stream::image_clock));
    EXPECT_GT(std::abs(first[0] - second[0]), 1e-4);
}

TEST(Vibration, ShakesByItsAmplitudeAtTheRotorsRate) {
    const Vibration vibration(0.2, 9);
    double squares = 0.0;
    double most_rad = 0.0;
    Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
    constexpr int count = 137000; // of 0.1 ms: 13.7 s, a whole number of turns
    for (int i = 0; i < count; ++i) {
        const Eigen::Isometry3d pose = vibration.at(1e-4 * i);
        const double roll_rad = std::atan2(pose(2, 1), pose(2, 2));
        squares += roll_rad * roll_rad / count;
        most_rad = std::max(most_rad, std::abs(roll_rad));
        sum_m += pose.translation() / count;
    }
    // Sine waves of 0.2 and 0.1 degrees.
    EXPECT_NEAR(deg_per_rad * std::sqrt(squares), std::sqrt((0.04 + 0.01) / 2.0), 2e-3);
    EXPECT_LE(deg_per_rad * most_rad, 0.31);
    EXPECT_LT(sum_m.norm(), 1e-5);
    const double turn_s = 1.0 / 13.7;
    EXPECT_TRUE(vibration.at(0.4).isApprox(vibration.at(0.4 + turn_s), 1e-9));
    EXPECT_TRUE(Vibration(0.0, 9).at(0.4).isApprox(Eigen::Isometry3d::Identity(), 0.0));
}

} // namespace
} // namespace zonegrid::testing
