#include "simulation/timed_way.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

constexpr double shortest_leg_m = 1e-6;
/// A leg is vertical, and says nothing of the nose, if it is steeper than this.
constexpr double least_horizontal_share = 0.05;
constexpr double slowing = 0.93;

bool above_zero(double value) {
    return std::isfinite(value) && value > 0.0;
}

void check_route(const Route& route) {
    const MotionLimits& limits = route.limits;
    if (!above_zero(limits.speed_mps) || !above_zero(limits.acceleration_mps2) ||
        !above_zero(limits.climb_mps) || !above_zero(limits.yaw_rate_radps)) {
        throw UsageError(
            "a limit of the motion is not above 0: give speed, acceleration, climb "
            "and turn rate above 0");
    }
    if (route.waypoints.size() < 2) {
        throw UsageError(
            fmt::format("the route has {} waypoints: give two or more", route.waypoints.size()));
    }
    for (std::size_t i = 0; i < route.waypoints.size(); ++i) {
        const Waypoint& waypoint = route.waypoints[i];
        if (!above_zero(waypoint.speed_mps) || !waypoint.position_m.allFinite() ||
            !(waypoint.hold_s >= 0.0 && std::isfinite(waypoint.hold_s))) {
            throw UsageError(
                fmt::format("waypoint {} cannot be flown: give a finite position, a "
                            "speed above 0 and a hold of 0 or more",
                            i));
        }
    }
}

} // namespace

TimedWay::TimedWay(const Route& route, double acceleration_mps2, std::optional<double> duration_s)
    : acceleration_mps2_(acceleration_mps2) {
    check_route(route);
    const std::vector<Waypoint>& waypoints = route.waypoints;
    Waypoint start = waypoints.front();
    add_leg(start.position_m, start, route.limits); // its wait, and its nose
    double least_s = start.hold_s;
    bool again = true;
    while (again) {
        const std::size_t before = legs_.size();
        for (std::size_t i = 1; i < waypoints.size() + (route.loop ? 1 : 0); ++i) {
            add_leg(waypoints[i - 1].position_m, waypoints[i % waypoints.size()], route.limits);
        }
        double round_s = 0.0;
        for (std::size_t i = before; i < legs_.size(); ++i) {
            round_s += legs_[i].length_m / legs_[i].speed_mps + legs_[i].wait_s;
        }
        if (!(round_s > 0.0)) {
            throw UsageError("all waypoints of the route are one place: give two");
        }
        least_s += round_s;
        again = route.loop && duration_s && least_s < *duration_s;
    }
    retime();
}

void TimedWay::add_leg(const Eigen::Vector3d& from_m, const Waypoint& to,
                       const MotionLimits& limits) {
    Leg leg;
    leg.start_m = from_m;
    const Eigen::Vector3d step_m = to.position_m - from_m;
    leg.length_m = step_m.norm() < shortest_leg_m ? 0.0 : step_m.norm();
    if (leg.length_m == 0.0 && !legs_.empty() && to.hold_s == 0.0 && !to.yaw_rad) {
        return; // the same place again says nothing, as where a loop names its start at its end
    }
    leg.direction = leg.length_m > 0.0 ? Eigen::Vector3d(step_m / leg.length_m)
                                       : Eigen::Vector3d(Eigen::Vector3d::Zero());
    leg.speed_mps = std::min(to.speed_mps, limits.speed_mps);
    const double climb = std::abs(leg.direction.z());
    if (climb > 0.0) {
        leg.speed_mps = std::min(leg.speed_mps, limits.climb_mps / climb);
    }
    leg.corner_mps = leg.speed_mps;
    leg.wait_s = to.hold_s;
    leg.yaw_rad = to.yaw_rad;
    if (!leg.yaw_rad && leg.direction.head<2>().norm() > least_horizontal_share) {
        leg.yaw_rad = std::atan2(leg.direction.y(), leg.direction.x());
    }
    legs_.push_back(leg);
}

void TimedWay::limit_speeds() {
    const auto reach = [this](double from_mps, double length_m) {
        return std::sqrt(from_mps * from_mps + 2.0 * acceleration_mps2_ * length_m);
    };
    for (std::size_t i = 0; i < legs_.size(); ++i) {
        Leg& leg = legs_[i];
        leg.first_mps = i == 0 ? 0.0 : legs_[i - 1].last_mps;
        const bool stops = i + 1 == legs_.size() || leg.length_m == 0.0 || leg.wait_s > 0.0;
        const double next_mps = stops ? 0.0 : legs_[i + 1].speed_mps;
        leg.last_mps =
            std::min({leg.corner_mps, leg.speed_mps, next_mps, reach(leg.first_mps, leg.length_m)});
        if (!stops && legs_[i + 1].length_m == 0.0) {
            leg.last_mps = 0.0;
        }
    }
    double next_mps = 0.0;
    for (auto leg = legs_.rbegin(); leg != legs_.rend(); ++leg) {
        leg->last_mps = std::min(leg->last_mps, next_mps);
        leg->first_mps = std::min(leg->first_mps, reach(leg->last_mps, leg->length_m));
        next_mps = leg->first_mps;
    }
}

void TimedWay::retime() {
    limit_speeds();
    const double a = acceleration_mps2_;
    double time_s = 0.0;
    for (Leg& leg : legs_) {
        leg.start_s = time_s;
        if (leg.length_m > 0.0) {
            const double highest =
                std::sqrt(a * leg.length_m +
                          (leg.first_mps * leg.first_mps + leg.last_mps * leg.last_mps) / 2.0);
            leg.peak_mps =
                std::max({std::min(leg.speed_mps, highest), leg.first_mps, leg.last_mps});
            leg.speeds_up_s = (leg.peak_mps - leg.first_mps) / a;
            leg.slows_down_s = (leg.peak_mps - leg.last_mps) / a;
            const double rest_m = leg.length_m -
                                  (leg.first_mps + leg.peak_mps) / 2.0 * leg.speeds_up_s -
                                  (leg.peak_mps + leg.last_mps) / 2.0 * leg.slows_down_s;
            leg.steady_s = std::max(rest_m, 0.0) / leg.peak_mps;
        }
        time_s = leg.arrival_s() + leg.wait_s;
    }
    end_s_ = time_s;
}

bool TimedWay::slow_corners(double from_s, double to_s) {
    bool any = false;
    for (Leg& leg : legs_) {
        const double passed_s = leg.arrival_s();
        if (passed_s >= from_s && passed_s <= to_s && leg.last_mps > 0.0) {
            leg.corner_mps = slowing * leg.last_mps;
            any = true;
        }
    }
    return any;
}

double TimedWay::way_m(const Leg& leg, double since_s) const {
    const double a = acceleration_mps2_;
    const double up_s = std::clamp(since_s, 0.0, leg.speeds_up_s);
    const double steady_s = std::clamp(since_s - leg.speeds_up_s, 0.0, leg.steady_s);
    const double down_s =
        std::clamp(since_s - leg.speeds_up_s - leg.steady_s, 0.0, leg.slows_down_s);
    return std::min(leg.length_m, (leg.first_mps + a * up_s / 2.0) * up_s +
                                      leg.peak_mps * steady_s +
                                      (leg.peak_mps - a * down_s / 2.0) * down_s);
}

WayPoint TimedWay::at(double time_s) const {
    const auto after = std::ranges::upper_bound(legs_, std::max(time_s, 0.0), {}, &Leg::start_s);
    const Leg& leg = *std::prev(after);
    WayPoint place;
    place.position_m = leg.start_m + way_m(leg, time_s - leg.start_s) * leg.direction;
    place.yaw_rad = leg.yaw_rad;
    return place;
}

} // namespace zonegrid
