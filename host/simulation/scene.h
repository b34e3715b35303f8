#pragma once

#include "truth/surfaces.h"
#include "zonegrid/sensors.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

/// A point that a vehicle flies through.
struct Waypoint {
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero(); ///< world frame
    double speed_mps = 5.0;                               ///< wanted on the way to it
    std::optional<double> yaw_rad{}; ///< wanted nose; without it the nose follows the way
    double hold_s = 0.0;             ///< hover here for so long
};

/// What a rotorcraft can do.
struct MotionLimits {
    double speed_mps = 15.0;
    double acceleration_mps2 = 3.0;
    double climb_mps = 4.0;
    double yaw_rate_radps = 0.6;
};

/// A vehicle's way through the world.
struct Route {
    std::vector<Waypoint> waypoints; ///< at least two
    MotionLimits limits;
    bool loop = false; ///< begin again at the first until the flight ends
};

/// Another vehicle in flight: an obstacle that moves.
struct SecondVehicle {
    std::uint32_t obstacle = 0; ///< index into Surfaces::obstacles; marked as moving
    Route route;
};

/// A world, how to fly through it, and the camera (docs/simulation.md).
struct Scene {
    std::string name;
    Surfaces surfaces;
    std::vector<double> texture; ///< per obstacle, 0 (blank) ... 1: how well stereo matches on it
    Route route;
    std::vector<SecondVehicle> vehicles;
    Camera camera; ///< ideal pinhole with mounting; `stereo` holds baseline and disparity deviation
    double image_rate_hz = 30.0;
    double navigation_rate_hz = 100.0;
    std::optional<double> duration_s{}; ///< of the flight; without it the route's end
};

/// Reads a scene from TOML. What is random in it (places and shapes of trees) comes from `seed`:
/// the same file and seed give the same scene everywhere. Meshes are named relative to the file.
/// Throws InputError naming file, line and key, and what is allowed.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file, std::uint64_t seed);

} // namespace zonegrid
