#include "simulation/scene.h"

#include "io/readable_text.h"
#include "io/text_list.h"
#include "simulation/scene_tables.h"
#include "simulation/world.h"
#include "zonegrid/errors.h"

#include <toml++/toml.h>

#include <limits>
#include <system_error>
#include <utility>

namespace zonegrid {
namespace {

toml::table parse_scene(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw InputError(file.string(), "there is no such file",
                         "name a scene; those that come with zonegrid are in scenes/");
    }
    try {
        return toml::parse_file(file.string());
    } catch (const toml::parse_error& problem) {
        throw InputError(place_of(file, problem.source().begin.line),
                         std::string(problem.description()), "correct the TOML");
    }
}

std::vector<Eigen::Vector3d> waypoints_of(const std::vector<Route>& routes) {
    std::vector<Eigen::Vector3d> points;
    for (const Route& route : routes) {
        for (const Waypoint& waypoint : route.waypoints) {
            points.push_back(waypoint.position_m);
        }
    }
    return points;
}

void add_vehicles(const World& world, std::vector<Route> routes, Scene& scene) {
    for (std::size_t i = 0; i < world.things().size(); ++i) {
        if (world.things()[i].moving) { // in the order of their routes
            scene.vehicles.push_back(
                {static_cast<std::uint32_t>(i), std::move(routes[scene.vehicles.size()])});
        }
    }
}

} // namespace

Scene read_scene(const std::filesystem::path& file, std::uint64_t seed) {
    const toml::table parsed = parse_scene(file);
    DescriptionTable root(parsed, file, "", "docs/simulation.md");
    const std::filesystem::path folder = file.parent_path();
    Scene scene;
    scene.name = readable_text(root.text("name").value_or(file.stem().string()));
    GroundPlan ground = read_ground(root, folder, seed);
    World world(std::move(ground.terrain));
    read_camera(root, scene);
    read_flight(root, world.terrain(), scene);
    read_plants(root, seed, world);
    read_structures(root, world);
    read_models(root, folder, world);
    std::vector<Route> vehicles = read_vehicles(root, world);
    std::vector<Route> routes = vehicles;
    routes.push_back(scene.route);
    read_forests(root, seed, routes, world);
    root.require_all_read();
    if (ground.drawn) {
        world.add_ground(waypoints_of(routes), ground.texture, ground.place);
    }
    if (world.things().empty()) {
        throw InputError(file.string(), "nothing is in the world",
                         "describe the [ground] or an obstacle");
    }
    add_vehicles(world, std::move(vehicles), scene);
    world.move_into(scene);
    check_surfaces(scene.surfaces, file.string());
    return scene;
}

} // namespace zonegrid
