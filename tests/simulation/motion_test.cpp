#include "simulation/motion.h"

#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double step_s = 0.001;

Waypoint waypoint(double north_m, double east_m, double down_m, double speed_mps) {
    Waypoint point;
    point.position_m = {north_m, east_m, down_m};
    point.speed_mps = speed_mps;
    return point;
}

/// Square corners, slants, a climb, a turn back and short legs.
Route hard_route() {
    Route route;
    route.waypoints = {waypoint(0, 0, -5, 8),    waypoint(40, 0, -5, 8),   waypoint(40, 30, -5, 12),
                       waypoint(60, 40, -15, 9), waypoint(62, 40, -15, 9), waypoint(62, 42, -15, 9),
                       waypoint(90, 60, -6, 14), waypoint(60, 60, -6, 14)};
    return route;
}

double distance_to_leg_m(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
    const Eigen::Vector3d leg = to - from;
    const double along = std::clamp((point - from).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
    return (point - from - along * leg).norm();
}

TEST(Motion, StaysNearTheRouteAndWithinItsLimits) {
    for (const double acceleration : {1.5, 3.0, 8.0}) {
        Route route = hard_route();
        route.limits.acceleration_mps2 = acceleration;
        const Motion motion(route);
        double fastest = 0.0;
        for (double time_s = 0.0; time_s < motion.end_s(); time_s += 0.01) {
            const NavigationSample state = motion.at(time_s).sample;
            double nearest_m = 1e9;
            for (std::size_t i = 1; i < route.waypoints.size(); ++i) {
                nearest_m = std::min(nearest_m, distance_to_leg_m(state.position_m,
                                                                  route.waypoints[i - 1].position_m,
                                                                  route.waypoints[i].position_m));
            }
            ASSERT_LT(nearest_m, 1.0) << time_s;
            fastest = std::max(fastest, state.velocity_mps.norm());
            ASSERT_LE(state.velocity_mps.norm(), 14.0 + 1e-9) << time_s;
            ASSERT_LE(std::abs(state.velocity_mps.z()), 4.0 + 1e-9) << time_s;
            ASSERT_LE(state.acceleration_mps2.norm(), acceleration + 1e-6) << time_s;
        }
        EXPECT_GT(fastest, 0.8 * std::min(8.0, std::sqrt(acceleration * 36.0 / 2.0)));
        const NavigationSample end = motion.at(motion.end_s()).sample;
        EXPECT_NEAR((end.position_m - Eigen::Vector3d(60, 60, -6)).norm(), 0.0, 1e-9);
        EXPECT_NEAR(end.velocity_mps.norm(), 0.0, 1e-9);
    }
}

TEST(Motion, IsConsistent) {
    const Motion motion(hard_route());
    // Velocity, attitude: integrated with the midpoint rule from the first state to the last.
    NavigationSample state = motion.at(0.0).sample;
    Eigen::Vector3d position_m = state.position_m;
    Eigen::Vector3d velocity_mps = state.velocity_mps;
    Eigen::Quaterniond attitude = state.world_from_body;
    for (int i = 0; i < static_cast<int>(motion.end_s() / step_s); ++i) {
        const NavigationSample middle = motion.at((i + 0.5) * step_s).sample;
        position_m += step_s * middle.velocity_mps;
        velocity_mps += step_s * middle.acceleration_mps2;
        const Eigen::Vector3d turn = step_s * middle.body_rate_radps;
        if (turn.norm() > 0.0) {
            attitude =
                attitude * Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
        }
        if (i % 500 == 0) {
            state = motion.at((i + 1) * step_s).sample;
            ASSERT_NEAR((position_m - state.position_m).norm(), 0.0, 1e-4) << i;
            ASSERT_NEAR((velocity_mps - state.velocity_mps).norm(), 0.0, 1e-4) << i;
            ASSERT_NEAR(attitude.angularDistance(state.world_from_body), 0.0, 1e-4) << i;
        }
    }
}

TEST(Motion, LeansIntoItsAcceleration) {
    Route route;
    route.waypoints = {waypoint(0, 0, -5, 10), waypoint(200, 0, -5, 10)};
    const Motion motion(route);
    // Amid speeding up (1.5 m/s^2 along the way) the nose is down by what thrust, weight and drag
    // say; amid steady flight by drag alone; at rest not at all.
    const NavigationSample speeding = motion.at(4.0).sample;
    EXPECT_NEAR(speeding.acceleration_mps2.x(), 1.5, 1e-9);
    const double pull = 1.5 + 0.08 * speeding.velocity_mps.x();
    EXPECT_NEAR(motion.at(4.0).roll_pitch_yaw_rad.y(), -std::atan2(pull, 9.80665), 1e-9);
    const EulerSample steady = motion.at(15.0);
    EXPECT_NEAR(steady.sample.velocity_mps.x(), 10.0, 1e-9);
    EXPECT_NEAR(steady.roll_pitch_yaw_rad.y(), -std::atan2(0.8, 9.80665), 1e-9);
    EXPECT_NEAR(motion.at(motion.end_s()).roll_pitch_yaw_rad.y(), 0.0, 1e-9);
}

TEST(Motion, BanksIntoATurnToTheRight) {
    Route route;
    route.waypoints = {waypoint(0, 0, -5, 10), waypoint(60, 0, -5, 10), waypoint(60, 60, -5, 10)};
    const Motion motion(route);
    double most_rad = 0.0;
    for (double time_s = 0.0; time_s < motion.end_s(); time_s += 0.01) {
        const EulerSample state = motion.at(time_s);
        if (state.sample.acceleration_mps2.y() > 0.5 && state.roll_pitch_yaw_rad.z() < 0.5) {
            most_rad = std::max(most_rad, state.roll_pitch_yaw_rad.x());
        }
    }
    EXPECT_GT(most_rad, 0.05); // right side down
}

TEST(Motion, TurnsItsNoseAlongTheWayAndAsTold) {
    Route route;
    route.waypoints = {waypoint(0, 0, -5, 6), waypoint(30, 0, -5, 6), waypoint(30, 30, -5, 6),
                       waypoint(0, 30, -5, 6)};
    route.waypoints[3].yaw_rad = 0.0;
    route.limits.yaw_rate_radps = 0.4;
    const Motion motion(route);
    EXPECT_NEAR(motion.at(2.0).roll_pitch_yaw_rad.z(), 0.0, 1e-9);
    EXPECT_NEAR(motion.at(motion.end_s()).roll_pitch_yaw_rad.z(), 0.0, 1e-9);
    double highest = 0.0;
    double most_radps = 0.0;
    for (double time_s = 0.0; time_s < motion.end_s(); time_s += 0.01) {
        const double yaw = motion.at(time_s).roll_pitch_yaw_rad.z();
        highest = std::max(highest, yaw);
        const double next = motion.at(time_s + 1e-4).roll_pitch_yaw_rad.z();
        most_radps = std::max(most_radps, std::abs(next - yaw) / 1e-4);
    }
    EXPECT_NEAR(highest, std::numbers::pi / 2.0, 1e-3); // along the leg to the east
    EXPECT_LE(most_radps, 0.4 + 1e-6);
    EXPECT_GT(most_radps, 0.3);
}

TEST(Motion, HoldsWhereItIsTold) {
    Route route;
    route.waypoints = {waypoint(0, 0, -5, 6), waypoint(30, 0, -5, 6), waypoint(30, 30, -5, 6)};
    route.waypoints[1].hold_s = 20.0;
    const Motion held(route);
    route.waypoints[1].hold_s = 0.0;
    const Motion passing(route);
    double rests_s = 0.0;
    for (double time_s = 0.0; time_s < held.end_s(); time_s += 0.01) {
        const NavigationSample state = held.at(time_s).sample;
        if ((state.position_m - Eigen::Vector3d(30, 0, -5)).norm() < 1e-6) {
            rests_s += 0.01;
            ASSERT_LT(state.velocity_mps.norm(), 1e-3);
        }
    }
    EXPECT_GT(rests_s, 13.0);
    EXPECT_GT(held.end_s(), passing.end_s() + 20.0);
}

TEST(Motion, LoopsUntilItsEnd) {
    Route route;
    route.waypoints = {waypoint(0, 0, -5, 6), waypoint(30, 0, -5, 6), waypoint(30, 30, -5, 6),
                       waypoint(0, 0, -5, 6)}; // its start again: no halt there
    route.loop = true;
    const Motion motion(route, 200.0);
    EXPECT_GE(motion.end_s(), 200.0);
    int rounds = 0;
    bool near = true;
    for (double time_s = 5.0; time_s < 200.0; time_s += 0.05) {
        const NavigationSample state = motion.at(time_s).sample;
        const bool now = state.position_m.head<2>().norm() < 2.0;
        rounds += now && !near ? 1 : 0;
        near = now;
        ASSERT_GT(state.velocity_mps.norm(), 0.2) << time_s;
    }
    EXPECT_GE(rounds, 5);
}

TEST(Motion, RefusesWhatCannotBeFlown) {
    Route route;
    route.waypoints = {waypoint(0, 0, 0, 5)};
    EXPECT_THAT([&] { const Motion motion(route); },
                ThrowsMessage<UsageError>(HasSubstr("two or more")));
    route.waypoints.push_back(waypoint(0, 0, 0, 5));
    EXPECT_THAT([&] { const Motion motion(route); },
                ThrowsMessage<UsageError>(HasSubstr("one place")));
    route.waypoints.push_back(waypoint(10, 0, 0, -1));
    EXPECT_THAT([&] { const Motion motion(route); },
                ThrowsMessage<UsageError>(HasSubstr("waypoint 2")));
    route.waypoints.back().speed_mps = 4.0;
    route.limits.climb_mps = 0.0;
    EXPECT_THAT([&] { const Motion motion(route); }, ThrowsMessage<UsageError>(HasSubstr("limit")));
}

TEST(Motion, RefusesToFlyUpsideDown) {
    Route route;
    route.waypoints.resize(2);
    route.waypoints[1].position_m = {1.0, 0.0, 1000.0};
    route.waypoints[1].speed_mps = 200.0;
    route.limits.speed_mps = route.limits.climb_mps = 200.0;
    // Half of it along the way: 9.8 - 7.5 m/s^2 are left for a drag of 0.08 m/s^2 for each m/s,
    // which suffices up to 29 m/s, for 3.8 s.
    route.limits.acceleration_mps2 = 15.0;
    const Motion motion(route);
    EXPECT_NO_THROW(static_cast<void>(motion.at(3.0)));
    EXPECT_THAT([&] { static_cast<void>(motion.at(8.0)); },
                ThrowsMessage<UsageError>(HasSubstr("upside down: lower the acceleration")));
}

TEST(Motion, TakesSecondVehiclesAlong) {
    SecondVehicle vehicle;
    vehicle.obstacle = 3;
    vehicle.route = hard_route();
    const ObstacleMotion path = motion_of(vehicle, 12.0);
    EXPECT_EQ(path.obstacle, 3U);
    EXPECT_EQ(path.poses.front().time_s, 0.0);
    EXPECT_GE(path.poses.back().time_s, 12.0);
    const Motion motion(vehicle.route);
    for (const double time_s : {1.013, 5.555, 11.99}) {
        const NavigationSample state = motion.at(time_s).sample;
        EXPECT_NEAR((path.at(time_s).translation() - state.position_m).norm(), 0.0, 1e-3);
        EXPECT_NEAR(
            Eigen::Quaterniond(path.at(time_s).linear()).angularDistance(state.world_from_body),
            0.0, 1e-3);
    }
}

} // namespace
} // namespace zonegrid::testing
