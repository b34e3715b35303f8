#pragma once

#include "simulation/scene.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace zonegrid {

/// A place along the way, and the nose wanted there.
struct WayPoint {
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    std::optional<double> yaw_rad; ///< none where the way does not say: keep the last one
};

/// A route with a time for each of its places: straight from waypoint to waypoint, with even
/// acceleration, at a limited speed through each corner.
class TimedWay {
public:
    /// A looping route is repeated until `duration_s`. Throws UsageError if the route has less than
    /// two places, or a speed or limit that is not above 0.
    TimedWay(const Route& route, double acceleration_mps2, std::optional<double> duration_s);

    /// Lowers the speed through the corners that are passed within `from_s` ... `to_s`.
    /// Returns whether there is such a corner; `retime` makes it count.
    bool slow_corners(double from_s, double to_s);
    void retime();

    [[nodiscard]] double end_s() const { return end_s_; }
    /// The place at `time_s`; the first before 0 and the last after the end.
    [[nodiscard]] WayPoint at(double time_s) const;

private:
    /// A straight piece, or a wait where `length_m` is 0.
    struct Leg {
        Eigen::Vector3d start_m;
        Eigen::Vector3d direction; ///< unit
        double length_m = 0.0;
        double speed_mps = 0.0; ///< at most
        double wait_s = 0.0;    ///< at its end
        std::optional<double> yaw_rad;
        double corner_mps = 0.0; ///< at most, at its end
        // What `retime` finds:
        double start_s = 0.0;
        double speeds_up_s = 0.0;
        double steady_s = 0.0;
        double slows_down_s = 0.0;
        double first_mps = 0.0;
        double peak_mps = 0.0;
        double last_mps = 0.0;
        [[nodiscard]] double arrival_s() const {
            return start_s + speeds_up_s + steady_s + slows_down_s;
        }
    };

    void add_leg(const Eigen::Vector3d& from_m, const Waypoint& to, const MotionLimits& limits);
    void limit_speeds();
    [[nodiscard]] double way_m(const Leg& leg, double since_s) const;

    std::vector<Leg> legs_;
    double acceleration_mps2_;
    double end_s_ = 0.0;
};

} // namespace zonegrid
