#include "simulation/aircraft.h"
#include "simulation/scene_keys.h"
#include "simulation/scene_tables.h"

#include <numbers>
#include <utility>

namespace zonegrid {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;
constexpr Span height_limits{-1e4, 1e4};

/// Height above 0 of a waypoint, which gives it so or above the ground.
double read_height_m(DescriptionTable& table, const Terrain& terrain,
                     const Eigen::Vector2d& place_m) {
    const std::optional<double> above_ground_m = table.number("above_ground_m");
    if (above_ground_m && table.number("height_m")) {
        table.refuse("above_ground_m", "comes beside height_m", "give one of them");
    }
    if (above_ground_m) {
        return terrain.height_m(place_m.x(), place_m.y()) +
               read_number(table, "above_ground_m", height_limits);
    }
    return read_number(table, "height_m", height_limits);
}

Waypoint read_waypoint(DescriptionTable& table, const Terrain& terrain) {
    Waypoint waypoint;
    const Eigen::Vector2d place_m = read_place(table);
    waypoint.position_m = {place_m.x(), place_m.y(), -read_height_m(table, terrain, place_m)};
    waypoint.speed_mps = read_number(table, "speed_mps", {0.1, 200.0}, waypoint.speed_mps);
    if (table.number("yaw_deg")) {
        waypoint.yaw_rad = read_angle_rad(table, "yaw_deg");
    }
    waypoint.hold_s = read_number(table, "hold_s", {0.0, 3600.0}, 0.0);
    table.require_all_read();
    return waypoint;
}

MotionLimits read_limits(DescriptionTable& table) {
    MotionLimits limits;
    limits.speed_mps = read_number(table, "speed_mps", {0.1, 200.0}, limits.speed_mps);
    limits.acceleration_mps2 =
        read_number(table, "acceleration_mps2", {0.1, 100.0}, limits.acceleration_mps2);
    limits.climb_mps = read_number(table, "climb_mps", {0.1, 200.0}, limits.climb_mps);
    limits.yaw_rate_radps = rad_per_deg * read_number(table, "yaw_rate_degps", {1.0, 720.0},
                                                      limits.yaw_rate_radps / rad_per_deg);
    table.require_all_read();
    return limits;
}

} // namespace

Route read_route(DescriptionTable& table, const Terrain& terrain) {
    Route route;
    std::vector<DescriptionTable> waypoints = table.tables("waypoint");
    for (DescriptionTable& waypoint : waypoints) {
        const Waypoint next = read_waypoint(waypoint, terrain);
        if (!route.waypoints.empty() && next.position_m == route.waypoints.back().position_m) {
            waypoint.refuse("north_m", "and the other coordinates are those of the one before",
                            "remove one; to stay at a waypoint give it hold_s");
        }
        route.waypoints.push_back(next);
    }
    if (waypoints.size() < 2) {
        table.refuse("waypoint", fmt::format("comes {} times", waypoints.size()),
                     fmt::format("give at least two, each as [[{}.waypoint]]", table.name()));
    }
    if (std::optional<DescriptionTable> limits = table.table("limits")) {
        route.limits = read_limits(*limits);
    }
    route.loop = table.flag("loop").value_or(false);
    return route;
}

void read_flight(DescriptionTable& root, const Terrain& terrain, Scene& scene) {
    std::optional<DescriptionTable> table = root.table("flight");
    if (!table) {
        root.refuse_absent("flight");
    }
    scene.route = read_route(*table, terrain);
    if (table->number("duration_s")) {
        scene.duration_s = read_number(*table, "duration_s", {0.1, 7200.0});
    } else if (scene.route.loop) {
        table->refuse("loop", "is true, so the route has no end", "give duration_s too");
    }
    scene.navigation_rate_hz =
        read_number(*table, "navigation_rate_hz", {1.0, 10000.0}, scene.navigation_rate_hz);
    table->require_all_read();
}

std::vector<Route> read_vehicles(DescriptionTable& root, World& world) {
    std::vector<Route> routes;
    for (DescriptionTable& table : root.tables("vehicle")) {
        const auto model = read_choice(
            table, "model",
            std::array{std::pair{std::string_view("helicopter"), AircraftModel::helicopter},
                       std::pair{std::string_view("aeroplane"), AircraftModel::aeroplane}});
        const double length_m = read_number(table, "length_m", {0.1, 100.0}, 8.0);
        const double span_m = read_number(table, "span_m", {0.1, 100.0}, length_m);
        routes.push_back(read_route(table, world.terrain()));
        world.add_named(table, "vehicle",
                        {{},
                         ObstacleKind::aircraft,
                         aircraft_shape(model, length_m, span_m),
                         read_texture(table),
                         true});
        table.require_all_read();
    }
    return routes;
}

} // namespace zonegrid
