#include "simulation/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace zonegrid::testing {
namespace {

constexpr double clearance_m = 1.0;
constexpr double step_m = 0.5;

Scene shipped(const std::string& name, std::uint64_t seed = 1) {
    return read_scene(std::filesystem::path(ZONEGRID_SOURCE_DIR) / "scenes" / (name + ".toml"),
                      seed);
}

double distance_to_edge_m(const Eigen::Vector3d& point, const Eigen::Vector3d& start,
                          const Eigen::Vector3d& end) {
    const Eigen::Vector3d edge = end - start;
    const double length2 = edge.squaredNorm();
    const double share =
        length2 > 0.0 ? std::clamp((point - start).dot(edge) / length2, 0.0, 1.0) : 0.0;
    return (point - start - share * edge).norm();
}

/// The distance to the plane where the point's foot is inside, else to the nearest edge.
double distance_to_triangle_m(const Eigen::Vector3d& point,
                              const std::array<Eigen::Vector3d, 3>& corners) {
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    bool inside = normal.norm() > 0.0;
    double distance_m = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d& start = corners.at(k);
        const Eigen::Vector3d& end = corners.at((k + 1) % 3);
        inside = inside && normal.cross(end - start).dot(point - start) >= 0.0;
        distance_m = std::min(distance_m, distance_to_edge_m(point, start, end));
    }
    return inside ? std::abs(normal.normalized().dot(point - corners[0])) : distance_m;
}

TEST(DistanceToTriangle, IsThatOfFaceEdgeOrCorner) {
    const std::array<Eigen::Vector3d, 3> corners{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 0, 0),
                                                 Eigen::Vector3d(0, 3, 0)};
    EXPECT_DOUBLE_EQ(distance_to_triangle_m({1, 1, -2}, corners), 2.0);
    EXPECT_DOUBLE_EQ(distance_to_triangle_m({2, -3, 4}, corners), 5.0);
    EXPECT_DOUBLE_EQ(distance_to_triangle_m({7, 0, 4}, corners), 5.0);
    EXPECT_DOUBLE_EQ(distance_to_triangle_m({3.2, 3.4, 0}, corners),
                     2.24); // hypotenuse 3 x + 4 y = 12: (9.6 + 13.6 - 12) / 5
}

struct Leg {
    Eigen::Vector3d start;
    Eigen::Vector3d end;
};

std::vector<Leg> legs_of(const Route& route) {
    std::vector<Leg> legs;
    const std::vector<Waypoint>& points = route.waypoints;
    for (std::size_t i = route.loop ? 0 : 1; i < points.size(); ++i) {
        legs.push_back(
            {points[i == 0 ? points.size() - 1 : i - 1].position_m, points[i].position_m});
    }
    return legs;
}

/// The least distance from the leg, every half metre, to the triangle.
double distance_of_leg_m(const Leg& leg, const std::array<Eigen::Vector3d, 3>& corners) {
    const int steps = static_cast<int>(std::ceil((leg.end - leg.start).norm() / step_m));
    double least_m = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i) {
        const Eigen::Vector3d point = leg.start + (leg.end - leg.start) * i / steps;
        least_m = std::min(least_m, distance_to_triangle_m(point, corners));
    }
    return least_m;
}

/// Expects the route to keep `distance_m` from all that stands still.
void expect_clear(const Scene& scene, const Route& route, double distance_m) {
    const std::vector<Leg> legs = legs_of(route);
    const std::vector<std::uint32_t> owners = scene.surfaces.obstacle_of_triangles();
    std::size_t near = 0;
    for (std::size_t i = 0; i < owners.size(); ++i) {
        const TrueObstacle& obstacle = scene.surfaces.obstacles[owners[i]];
        if (obstacle.moving) {
            continue;
        }
        std::array<Eigen::Vector3d, 3> corners;
        Eigen::AlignedBox3d bounds;
        for (std::size_t k = 0; k < 3; ++k) {
            corners.at(k) =
                scene.surfaces.vertices_m[scene.surfaces.triangles[i].at(k)].cast<double>();
            bounds.extend(corners.at(k));
        }
        for (const Leg& leg : legs) {
            const Eigen::AlignedBox3d around(leg.start.cwiseMin(leg.end),
                                             leg.start.cwiseMax(leg.end));
            // Wider than what is asked for, so that some triangles are looked at in every scene.
            if (around.squaredExteriorDistance(bounds) < 100.0) {
                ++near;
                ASSERT_GE(distance_of_leg_m(leg, corners), distance_m)
                    << scene.name << ": " << obstacle.name << " near " << corners[0].transpose();
            }
        }
    }
    EXPECT_GT(near, 0U) << scene.name;
}

double duration_s(const Route& route) {
    double sum_s = 0.0;
    for (std::size_t i = 1; i < route.waypoints.size(); ++i) {
        const Waypoint& to = route.waypoints[i];
        sum_s += (to.position_m - route.waypoints[i - 1].position_m).norm() / to.speed_mps;
        sum_s += to.hold_s;
    }
    return sum_s;
}

/// Where a vehicle is if it turns and changes its speed at once.
Eigen::Vector3d place_at(const Route& route, double time_s) {
    for (const Leg& leg : legs_of(route)) {
        const auto to = std::ranges::find(route.waypoints, leg.end, &Waypoint::position_m);
        const double leg_s = (leg.end - leg.start).norm() / to->speed_mps;
        if (time_s < leg_s) {
            return leg.start + std::max(time_s, 0.0) / leg_s * (leg.end - leg.start);
        }
        time_s -= leg_s;
    }
    return route.waypoints.back().position_m;
}

std::map<ObstacleKind, int> kinds_of(const Scene& scene) {
    std::map<ObstacleKind, int> kinds;
    for (const TrueObstacle& obstacle : scene.surfaces.obstacles) {
        ++kinds[obstacle.kind];
    }
    return kinds;
}

const std::map<std::string, std::map<ObstacleKind, int>> contents{
    {"slalom", {{ObstacleKind::ground, 1}, {ObstacleKind::tree, 5}}},
    {"field", {{ObstacleKind::ground, 1}, {ObstacleKind::bush, 11}, {ObstacleKind::aircraft, 1}}},
    {"empty_field", {{ObstacleKind::ground, 1}}},
    {"street_canyon",
     {{ObstacleKind::ground, 1}, {ObstacleKind::building, 11}, {ObstacleKind::tree, 2}}},
    {"tunnel", {{ObstacleKind::ground, 1}, {ObstacleKind::other, 1}}},
    {"wires", {{ObstacleKind::ground, 1}, {ObstacleKind::wire, 7}, {ObstacleKind::mast, 5}}},
    {"forest", {{ObstacleKind::ground, 1}, {ObstacleKind::tree, 4000}}},
    {"second_vehicle",
     {{ObstacleKind::ground, 1},
      {ObstacleKind::tree, 2},
      {ObstacleKind::building, 1},
      {ObstacleKind::aircraft, 1}}},
};

TEST(ShippedScenes, AreTheseAndHoldWhatTheySay) {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(ZONEGRID_SOURCE_DIR) / "scenes")) {
        if (entry.path().extension() == ".toml") {
            files.insert(entry.path().stem().string());
        }
    }
    std::set<std::string> names;
    for (const auto& [name, kinds] : contents) {
        names.insert(name);
        const Scene scene = shipped(name);
        EXPECT_EQ(scene.name, name);
        EXPECT_EQ(kinds_of(scene), kinds) << name;
        EXPECT_LT(scene.surfaces.triangles.size(), 1'500'000U) << name;
        EXPECT_EQ(scene.texture.size(), scene.surfaces.obstacles.size()) << name;
        EXPECT_GE(duration_s(scene.route), 18.0) << name; // and some more to start and stop
        EXPECT_LE(duration_s(scene.route), 110.0) << name;
    }
    EXPECT_EQ(files, names);
}

TEST(ShippedScenes, CanBeFlownWithoutTouchingAnything) {
    for (const auto& [name, kinds] : contents) {
        const Scene scene = shipped(name);
        expect_clear(scene, scene.route, clearance_m);
        for (const SecondVehicle& vehicle : scene.vehicles) {
            expect_clear(scene, vehicle.route, 4.0 + clearance_m); // half its length
        }
    }
}

TEST(ShippedScenes, CanBeFlownWithOtherSeeds) {
    for (const char* name : {"slalom", "field", "forest"}) {
        for (const std::uint64_t seed : {2U, 3U}) {
            const Scene scene = shipped(name, seed);
            expect_clear(scene, scene.route, clearance_m);
        }
    }
}

TEST(Slalom, PassesThreeTreesOfALineOnAlternatingSides) {
    const Scene scene = shipped("slalom");
    std::vector<double> sides;
    for (int tree = 0; tree < 3; ++tree) {
        const double north_m = 40.0 + 18.0 * tree;
        for (const Leg& leg : legs_of(scene.route)) {
            if (leg.start.x() < north_m && north_m <= leg.end.x()) {
                const double share = (north_m - leg.start.x()) / (leg.end.x() - leg.start.x());
                sides.push_back(leg.start.y() + share * (leg.end.y() - leg.start.y()));
            }
        }
    }
    ASSERT_EQ(sides.size(), 3U);
    EXPECT_LT(sides[0], -4.0);
    EXPECT_GT(sides[1], 4.0);
    EXPECT_LT(sides[2], -4.0);
}

TEST(SecondVehicle, CrossesTheViewAndKeepsAway) {
    const Scene scene = shipped("second_vehicle");
    ASSERT_EQ(scene.vehicles.size(), 1U);
    const Route& other = scene.vehicles[0].route;
    double least_m = std::numeric_limits<double>::infinity();
    int seen = 0;
    for (double time_s = 0.0; time_s < duration_s(scene.route); time_s += 0.1) {
        const Eigen::Vector3d ego = place_at(scene.route, time_s);
        const Eigen::Vector3d way = place_at(other, time_s) - ego;
        seen += way.x() > 0.0 && std::abs(way.y()) < std::tan(0.44) * way.x() && way.norm() < 40.0
                    ? 1
                    : 0;
        for (const double late_s : {-3.0, 0.0, 3.0}) { // starting and turning take their time
            least_m = std::min(least_m, (place_at(other, time_s + late_s) - ego).norm());
        }
    }
    EXPECT_GT(seen, 30); // three seconds
    EXPECT_GT(least_m, 6.0);
}

} // namespace
} // namespace zonegrid::testing
