#pragma once

#include "io/plain_writer.h"
#include "simulation/scene.h"
#include "simulation/uniform_spline.h"
#include "truth/truth_folder.h"

#include <optional>
#include <vector>

namespace zonegrid {

/// How a rotorcraft flies a route: from rest at the first waypoint, along straight lines, slowly
/// enough through corners that it stays within a metre of them, to rest at the last
/// (docs/simulation.md, "Flight").
///
/// Position and yaw are splines that are four times continuously differentiable, and velocity,
/// acceleration, attitude and turn rates follow from them exactly. Speed, climb, acceleration and
/// yaw rate stay within the route's limits.
class Motion {
public:
    /// A looping route goes on until `duration_s`. Throws UsageError if the route cannot be flown.
    explicit Motion(const Route& route, std::optional<double> duration_s = {});

    /// When the vehicle has come to rest at the end of the route, or of the laps asked for.
    [[nodiscard]] double end_s() const { return end_s_; }

    /// The true state at `time_s`, 0 or more; after the end the vehicle hovers. Throws UsageError
    /// where the limits let it fall faster than its rotor can follow, which would turn it over.
    [[nodiscard]] EulerSample at(double time_s) const;

private:
    UniformSpline curve_; ///< north, east, down, yaw
    double end_s_ = 0.0;
};

/// The path of a second vehicle from 0 to `duration_s`, with an entry every 20 ms.
[[nodiscard]] ObstacleMotion motion_of(const SecondVehicle& vehicle, double duration_s);

} // namespace zonegrid
