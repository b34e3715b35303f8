#pragma once

#include "io/description_table.h"
#include "simulation/scene.h"
#include "simulation/terrain.h"
#include "simulation/world.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

// Each reads some tables of a scene's file (docs/simulation.md lists their keys). All throw
// InputErrors that name file, line and key.

/// What the ground is like.
struct GroundPlan {
    Terrain terrain; ///< flat where there is no ground
    bool drawn = false;
    double texture = 1.0;
    std::string place{}; ///< file and line of its table
};

/// [ground] or [terrain]; neither: the world has no ground.
[[nodiscard]] GroundPlan read_ground(DescriptionTable& root, const std::filesystem::path& folder,
                                     std::uint64_t seed);

/// [camera] into the scene's camera and image rate; everything has a default.
void read_camera(DescriptionTable& root, Scene& scene);

/// [flight] into the scene's route, duration and navigation rate.
void read_flight(DescriptionTable& root, const Terrain& terrain, Scene& scene);

/// The way of `table`: its waypoints, limits and `loop`.
[[nodiscard]] Route read_route(DescriptionTable& table, const Terrain& terrain);

/// [[tree]], [[bush]], [[row]].
void read_plants(DescriptionTable& root, std::uint64_t seed, World& world);

/// [[forest]]; its trees keep away from the routes.
void read_forests(DescriptionTable& root, std::uint64_t seed, const std::vector<Route>& routes,
                  World& world);

/// [[building]], [[wire]], [[mast]], [tunnel].
void read_structures(DescriptionTable& root, World& world);

/// [[aircraft]] and [[mesh]]; meshes are named relative to `folder`.
void read_models(DescriptionTable& root, const std::filesystem::path& folder, World& world);

/// [[vehicle]]: adds each as a moving thing and returns their routes in order.
[[nodiscard]] std::vector<Route> read_vehicles(DescriptionTable& root, World& world);

} // namespace zonegrid
