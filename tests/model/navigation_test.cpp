#include "model/navigation.h"

#include "support/scenes.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

// docs/model.md, section 2.

namespace zonegrid {
namespace {

using Eigen::Vector3d;
using scenes::resting_at;
using testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Navigation, ConstantAccelerationInClosedForm) {
    NavigationSample sample;
    sample.position_m = {10.0, -20.0, -30.0};
    sample.velocity_mps = {3.0, -4.0, 0.5};
    sample.acceleration_mps2 = {2.0, 1.0, -8.0};
    const auto ahead = extrapolate_pose(sample, 0.5);
    // 10 + 3 * 0.5 + 2 * 0.125; -20 - 4 * 0.5 + 0.125; -30 + 0.25 - 1
    EXPECT_TRUE(ahead.translation().isApprox(Vector3d(11.75, -21.875, -30.75), 1e-15));
    const auto back = extrapolate_pose(sample, -0.5);
    EXPECT_TRUE(back.translation().isApprox(Vector3d(8.75, -17.875, -31.25), 1e-15));
    EXPECT_TRUE(ahead.linear().isApprox(Eigen::Matrix3d::Identity()));
}

TEST(Navigation, TurnAboutTheBodysDiagonalSwapsTheAxes) {
    // A third of a turn about (1, 1, 1) takes x to y, y to z and z to x.
    NavigationSample sample;
    sample.body_rate_radps = Vector3d::Constant(2.0 * pi / 3.0 / std::sqrt(3.0));
    const Eigen::Matrix3d ahead = extrapolate_pose(sample, 1.0).linear();
    EXPECT_TRUE((ahead * Vector3d::UnitX()).isApprox(Vector3d::UnitY(), 1e-12));
    EXPECT_TRUE((ahead * Vector3d::UnitY()).isApprox(Vector3d::UnitZ(), 1e-12));
    const Eigen::Matrix3d back = extrapolate_pose(sample, -1.0).linear();
    EXPECT_TRUE((back * Vector3d::UnitY()).isApprox(Vector3d::UnitX(), 1e-12));
}

TEST(Navigation, TurnRateIsOfTheBodyNotOfTheWorld) {
    // Rolled by 90 degrees to the right, the body's down axis points to the left (west): a turn
    // about it by 90 degrees takes the nose from north to where the right side was, down.
    NavigationSample sample;
    sample.world_from_body = attitude_from_euler(pi / 2.0, 0.0, 0.0);
    sample.body_rate_radps = {0.0, 0.0, pi / 2.0};
    const Vector3d nose = extrapolate_pose(sample, 1.0).linear() * Vector3d::UnitX();
    EXPECT_TRUE(nose.isApprox(Vector3d(0.0, 0.0, 1.0), 1e-12)) << "nose " << nose.transpose();
}

/// A body on a level circle that also climbs: 20 m/s, 0.5 rad/s, 1 m/s upwards.
struct Helix {
    double speed_mps = 20.0;
    double yaw_rate_radps = 0.5;
    double climb_mps = 1.0;

    [[nodiscard]] Vector3d position_m(double t) const {
        const double radius_m = speed_mps / yaw_rate_radps;
        return {radius_m * std::sin(yaw_rate_radps * t),
                radius_m * (1.0 - std::cos(yaw_rate_radps * t)), -climb_mps * t};
    }
    [[nodiscard]] NavigationSample sample(double t) const {
        NavigationSample sample;
        const double yaw = yaw_rate_radps * t;
        sample.time_s = t;
        sample.position_m = position_m(t);
        sample.velocity_mps = {speed_mps * std::cos(yaw), speed_mps * std::sin(yaw), -climb_mps};
        sample.acceleration_mps2 =
            speed_mps * yaw_rate_radps * Vector3d(-std::sin(yaw), std::cos(yaw), 0.0);
        sample.world_from_body = attitude_from_euler(0.0, 0.0, yaw);
        sample.body_rate_radps = {0.0, 0.0, yaw_rate_radps};
        return sample;
    }
};

TEST(Navigation, FollowsAHelixToThirdOrder) {
    const Helix helix;
    NavigationBuffer buffer;
    for (int n = 0; n <= 20; ++n) {
        buffer.add(helix.sample(0.1 * n));
    }
    // What the formula leaves out: the jerk, speed * rate^2, acting for at most 0.05 s.
    const double bound_m = 20.0 * 0.25 * std::pow(0.05, 3) / 6.0 * 1.01;
    int poses = 0;
    for (double t = -0.04; t < 2.05; t += 0.0137, ++poses) {
        const auto pose = buffer.world_from_body(t, 0.06);
        ASSERT_TRUE(pose.has_value()) << t;
        EXPECT_LT((pose->translation() - helix.position_m(t)).norm(), bound_m) << t;
        const Eigen::Matrix3d attitude = attitude_from_euler(0.0, 0.0, 0.5 * t).toRotationMatrix();
        EXPECT_LT((pose->linear() - attitude).norm(), 1e-12) << t;
    }
    EXPECT_GT(poses, 150);
}

/// North position tells the sample that was taken.
double north_of(const NavigationBuffer& buffer, double time_s, double max_gap_s = 100.0) {
    const auto pose = buffer.world_from_body(time_s, max_gap_s);
    return pose ? pose->translation().x() : nan;
}

TEST(Navigation, TakesTheNearestSampleAndTheEarlierOfTwo) {
    NavigationBuffer buffer;
    buffer.add(resting_at(1.0, {1.0, 0.0, 0.0}));
    buffer.add(resting_at(1.5, {2.0, 0.0, 0.0}));
    buffer.add(resting_at(2.5, {3.0, 0.0, 0.0}));
    EXPECT_EQ(north_of(buffer, 0.5), 1.0);
    EXPECT_EQ(north_of(buffer, 1.25), 1.0); // as near to 1.5
    EXPECT_EQ(north_of(buffer, 1.2500001), 2.0);
    EXPECT_EQ(north_of(buffer, 2.0), 2.0);  // as near to 2.5
    EXPECT_EQ(north_of(buffer, 2.25), 3.0); // a sample after the image
    EXPECT_EQ(north_of(buffer, 9.0), 3.0);
}

TEST(Navigation, GapLimitIsInclusive) {
    NavigationBuffer buffer;
    EXPECT_FALSE(buffer.world_from_body(0.0, 1e9).has_value());
    buffer.add(resting_at(1.0, {7.0, 0.0, 0.0}));
    EXPECT_EQ(north_of(buffer, 1.25, 0.25), 7.0);
    EXPECT_EQ(north_of(buffer, 0.75, 0.25), 7.0);
    EXPECT_FALSE(buffer.world_from_body(1.2501, 0.25).has_value());
    EXPECT_FALSE(buffer.world_from_body(0.7499, 0.25).has_value());
    EXPECT_EQ(north_of(buffer, 1.0, 0.0), 7.0);
    EXPECT_FALSE(buffer.world_from_body(nan, 1e9).has_value());
}

TEST(Navigation, KeepsTenSeconds) {
    NavigationBuffer buffer;
    buffer.add(resting_at(0.0, {1.0, 0.0, 0.0}));
    buffer.add(resting_at(0.5, {2.0, 0.0, 0.0}));
    buffer.add(resting_at(10.0, {3.0, 0.0, 0.0}));
    EXPECT_EQ(north_of(buffer, 0.0, 0.0), 1.0);
    buffer.add(resting_at(10.5, {4.0, 0.0, 0.0}));
    EXPECT_FALSE(buffer.world_from_body(0.0, 0.0).has_value());
    EXPECT_EQ(north_of(buffer, 0.5, 0.0), 2.0);
}

std::string refusal(const NavigationSample& sample) {
    NavigationBuffer buffer;
    buffer.add(resting_at(1.0, Vector3d::Zero()));
    try {
        buffer.add(sample);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Navigation, RefusesWhatIsNotFiniteInAnyField) {
    const std::vector<std::function<double&(NavigationSample&)>> fields{
        [](NavigationSample& s) -> double& { return s.time_s; },
        [](NavigationSample& s) -> double& { return s.position_m.y(); },
        [](NavigationSample& s) -> double& { return s.velocity_mps.z(); },
        [](NavigationSample& s) -> double& { return s.acceleration_mps2.x(); },
        [](NavigationSample& s) -> double& { return s.world_from_body.w(); },
        [](NavigationSample& s) -> double& { return s.body_rate_radps.y(); }};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        for (const double value : {nan, infinity, -infinity}) {
            NavigationSample sample = resting_at(2.0, Vector3d::Zero());
            fields[i](sample) = value;
            EXPECT_THAT(refusal(sample), HasSubstr("a value is not finite")) << "field " << i;
        }
    }
}

TEST(Navigation, RefusesWhatIsOutOfOrder) {
    EXPECT_THAT(refusal(resting_at(1.0, Vector3d::Zero())),
                HasSubstr("navigation sample at 1.000000 s: it is not after the previous one"));
    EXPECT_THAT(refusal(resting_at(0.999, Vector3d::Zero())), HasSubstr("increasing order"));
}

TEST(Navigation, RefusesWhatIsNoRotation) {
    NavigationSample sample = resting_at(2.0, Vector3d::Zero());
    sample.world_from_body.coeffs() *= 1.002;
    EXPECT_THAT(refusal(sample), HasSubstr("its quaternion has norm 1.002"));
    sample.world_from_body.coeffs().setZero();
    EXPECT_THAT(refusal(sample), HasSubstr("norm 0"));
}

TEST(Navigation, ARefusedSampleLeavesNoTrace) {
    NavigationBuffer buffer;
    buffer.add(resting_at(1.0, {1.0, 0.0, 0.0}));
    NavigationSample broken = resting_at(50.0, {2.0, 0.0, 0.0});
    broken.velocity_mps.x() = nan;
    EXPECT_THROW(buffer.add(broken), InputError);
    EXPECT_EQ(north_of(buffer, 50.0), 1.0);
    EXPECT_NO_THROW(buffer.add(resting_at(1.5, {3.0, 0.0, 0.0})));
}

TEST(Navigation, RoundedQuaternionsAreNormalised) {
    NavigationSample sample = resting_at(2.0, Vector3d::Zero(), 0.3);
    sample.world_from_body.coeffs() *= 1.0005;
    EXPECT_EQ(refusal(sample), "accepted");
    const Eigen::Matrix3d attitude = extrapolate_pose(sample, 0.0).linear();
    EXPECT_TRUE((attitude * attitude.transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-14));
}

} // namespace
} // namespace zonegrid
