#include "simulation/motion.h"

#include "simulation/timed_way.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace zonegrid {
namespace {

constexpr double gravity_mps2 = 9.80665;
/// Drag a unit of speed and mass: at 10 m/s the rotor leans by 4.7 degrees.
constexpr double drag_per_s = 0.08;
/// How far the curve may leave the way at a corner.
constexpr double corner_m = 0.6;
/// The curve leaves a corner by about this times acceleration times the square of the step: the
/// blending functions' mean distance in time is 0.47 steps, and half of it counts.
constexpr double corner_share = 0.25;
constexpr double longest_step_s = 1.0;
/// Share of the limit for speeding up and slowing down; the rest is left for turning at corners.
constexpr double along_share = 0.5;
constexpr double within_rounding = 1.0 + 1e-9;
constexpr int most_rounds = 2000;
/// A vehicle at rest, in steps after its way ends: the spline reaches that far.
constexpr double settling_steps = 3.0;
constexpr double between_poses_s = 0.02;

double nearest_turn(double angle_rad) {
    return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

/// Places at whole steps, the first at time 0.
std::vector<Eigen::Vector3d> sample_way(const TimedWay& way, double step_s) {
    std::vector<Eigen::Vector3d> places;
    const auto count = static_cast<std::size_t>(std::ceil(way.end_s() / step_s)) + 2;
    for (std::size_t i = 0; i < count; ++i) {
        places.push_back(way.at(static_cast<double>(i) * step_s).position_m);
    }
    return places;
}

/// Slows the corners until the control points' second differences, and with them the curve's
/// acceleration, keep the limit. Throws UsageError if they do not come to.
void keep_acceleration(TimedWay& way, double step_s, double limit_mps2) {
    const double most_m = limit_mps2 * step_s * step_s * within_rounding;
    for (int round = 0; round < most_rounds; ++round) {
        const std::vector<Eigen::Vector3d> places = sample_way(way, step_s);
        bool kept = true;
        for (std::size_t i = 1; i + 1 < places.size(); ++i) {
            if ((places[i + 1] - 2.0 * places[i] + places[i - 1]).norm() > most_m) {
                const double time_s = static_cast<double>(i) * step_s;
                kept = !way.slow_corners(time_s - step_s, time_s + step_s) && kept;
            }
        }
        if (kept) {
            return;
        }
        way.retime();
    }
    throw UsageError(
        fmt::format("the way's corners cannot be flown within {:g} m/s^2: raise the limit "
                    "on acceleration, or lower the speeds between waypoints",
                    limit_mps2));
}

std::vector<Eigen::Vector4d> control_points(const TimedWay& way, double step_s,
                                            double yaw_rate_radps) {
    const std::vector<Eigen::Vector3d> places = sample_way(way, step_s);
    std::vector<Eigen::Vector4d> control;
    double yaw_rad = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::optional<double> wanted = way.at(static_cast<double>(i) * step_s).yaw_rad;
        if (wanted) {
            const double turn = nearest_turn(*wanted - yaw_rad);
            const double most = i == 0 ? std::numbers::pi : yaw_rate_radps * step_s;
            yaw_rad += std::clamp(turn, -most, most);
        }
        control.emplace_back(places[i].x(), places[i].y(), places[i].z(), yaw_rad);
    }
    return control;
}

/// The attitude that points the rotor's thrust along what carries the vehicle, and its change.
struct Tilt {
    double roll_rad = 0.0;
    double pitch_rad = 0.0;
    double roll_radps = 0.0;
    double pitch_radps = 0.0;
};

/// Throws UsageError where that would turn it upside down.
Tilt tilt_of(const SplinePoint& point, double time_s) {
    // The body's down axis lies against the thrust, which balances gravity, drag and inertia.
    const Eigen::Vector3d down = Eigen::Vector3d(0.0, 0.0, gravity_mps2) - point.second.head<3>() -
                                 drag_per_s * point.first.head<3>();
    if (!(down.z() > 0.0)) {
        throw UsageError(
            fmt::format("at {:.1f} s a vehicle would have to fly upside down: lower the "
                        "acceleration, climb or speed of its limits",
                        time_s));
    }
    const Eigen::Vector3d down_change =
        -point.third.head<3>() - drag_per_s * point.second.head<3>();
    // Both as seen by a level body with the same yaw.
    const double c = std::cos(point.value.w());
    const double s = std::sin(point.value.w());
    const double rate = point.first.w();
    const Eigen::Vector3d w(c * down.x() + s * down.y(), -s * down.x() + c * down.y(), down.z());
    const Eigen::Vector3d turned(c * down_change.x() + s * down_change.y(),
                                 -s * down_change.x() + c * down_change.y(), down_change.z());
    const Eigen::Vector3d change = turned + rate * Eigen::Vector3d(w.y(), -w.x(), 0.0);
    const double upright = std::hypot(w.x(), w.z());
    const double upright_change = (w.x() * change.x() + w.z() * change.z()) / upright;
    Tilt tilt;
    tilt.pitch_rad = std::atan2(w.x(), w.z());
    tilt.roll_rad = std::atan2(-w.y(), upright);
    tilt.pitch_radps = (change.x() * w.z() - w.x() * change.z()) / (upright * upright);
    tilt.roll_radps = (w.y() * upright_change - change.y() * upright) / w.squaredNorm();
    return tilt;
}

/// Turn rates in the body frame from the changes of roll, pitch and yaw (z-y'-x'').
Eigen::Vector3d body_rates(const Tilt& tilt, double yaw_radps) {
    const double sin_roll = std::sin(tilt.roll_rad);
    const double cos_roll = std::cos(tilt.roll_rad);
    const double level_rate = yaw_radps * std::cos(tilt.pitch_rad);
    return {tilt.roll_radps - yaw_radps * std::sin(tilt.pitch_rad),
            tilt.pitch_radps * cos_roll + level_rate * sin_roll,
            level_rate * cos_roll - tilt.pitch_radps * sin_roll};
}

} // namespace

Motion::Motion(const Route& route, std::optional<double> duration_s)
    : curve_({Eigen::Vector4d::Zero()}, 1.0) {
    const double limit = route.limits.acceleration_mps2;
    TimedWay way(route, along_share * limit, duration_s);
    const double step_s = std::min(longest_step_s, std::sqrt(corner_m / (corner_share * limit)));
    keep_acceleration(way, step_s, limit);
    curve_ = UniformSpline(control_points(way, step_s, route.limits.yaw_rate_radps), step_s);
    end_s_ = way.end_s() + settling_steps * step_s;
}

EulerSample Motion::at(double time_s) const {
    const SplinePoint point = curve_.at(time_s);
    const Tilt tilt = tilt_of(point, time_s);
    EulerSample state;
    state.roll_pitch_yaw_rad = {tilt.roll_rad, tilt.pitch_rad, nearest_turn(point.value.w())};
    state.sample.time_s = time_s;
    state.sample.position_m = point.value.head<3>();
    state.sample.velocity_mps = point.first.head<3>();
    state.sample.acceleration_mps2 = point.second.head<3>();
    state.sample.world_from_body = attitude_from_euler(
        state.roll_pitch_yaw_rad.x(), state.roll_pitch_yaw_rad.y(), state.roll_pitch_yaw_rad.z());
    state.sample.body_rate_radps = body_rates(tilt, point.first.w());
    return state;
}

ObstacleMotion motion_of(const SecondVehicle& vehicle, double duration_s) {
    const Motion motion(vehicle.route, duration_s);
    ObstacleMotion path;
    path.obstacle = vehicle.obstacle;
    const auto count = static_cast<std::size_t>(std::ceil(duration_s / between_poses_s)) + 1;
    for (std::size_t i = 0; i < count; ++i) {
        const EulerSample state = motion.at(static_cast<double>(i) * between_poses_s);
        MovingPose pose;
        pose.time_s = state.sample.time_s;
        pose.world_from_obstacle.linear() = state.sample.world_from_body.toRotationMatrix();
        pose.world_from_obstacle.translation() = state.sample.position_m;
        path.poses.push_back(pose);
    }
    return path;
}

} // namespace zonegrid
