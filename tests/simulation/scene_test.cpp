#include "simulation/scene.h"

#include "io/npy.h"
#include "support/temporary_folder.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace zonegrid::testing {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;

const std::string flight = // 8 lines, two waypoints
    "[[flight.waypoint]]\nnorth_m = 0\neast_m = 0\nheight_m = 5\n"
    "[[flight.waypoint]]\nnorth_m = 50\neast_m = 0\nheight_m = 5\n";

/// A folder with a scene's file.
class SceneFolder {
public:
    explicit SceneFolder(const std::string& text) { write("field.toml", text); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_.path() / name) << text;
    }
    [[nodiscard]] std::filesystem::path path() const { return folder_.path(); }
    [[nodiscard]] Scene read(std::uint64_t seed = 1) const {
        return read_scene(folder_.path() / "field.toml", seed);
    }

private:
    TemporaryFolder folder_;
};

Scene scene_of(const std::string& text, std::uint64_t seed = 1) {
    return SceneFolder(text).read(seed);
}

std::vector<std::string> names_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const TrueObstacle& obstacle : scene.surfaces.obstacles) {
        names.push_back(obstacle.name);
    }
    return names;
}

Eigen::AlignedBox3d bounds_of(const Scene& scene, const std::string& name) {
    Eigen::AlignedBox3d bounds;
    for (const TrueObstacle& obstacle : scene.surfaces.obstacles) {
        for (std::uint32_t i = 0; obstacle.name == name && i < obstacle.triangles; ++i) {
            for (const auto vertex : scene.surfaces.triangles[obstacle.first_triangle + i]) {
                bounds.extend(scene.surfaces.vertices_m[vertex].cast<double>());
            }
        }
    }
    return bounds;
}

TEST(Scene, HasTheCameraOfThePaperUnlessItSaysOtherwise) {
    const Scene scene = scene_of("[ground]\n" + flight);
    EXPECT_EQ(scene.name, "field");
    EXPECT_EQ(scene.camera.width_px, 640);
    EXPECT_EQ(scene.camera.height_px, 480);
    EXPECT_DOUBLE_EQ(scene.camera.fx_px, 320.0 / std::tan(25.5 * rad_per_deg));
    EXPECT_DOUBLE_EQ(scene.camera.fy_px, 240.0 / std::tan(20.0 * rad_per_deg));
    EXPECT_DOUBLE_EQ(scene.camera.cx_px, 319.5);
    EXPECT_DOUBLE_EQ(scene.camera.cy_px, 239.5);
    EXPECT_DOUBLE_EQ(scene.camera.stereo->baseline_m, 0.3);
    EXPECT_DOUBLE_EQ(scene.camera.stereo->disparity_sigma_px, 0.25);
    EXPECT_TRUE(scene.camera.body_from_camera.linear().isApprox(body_from_forward_camera()));
    EXPECT_TRUE(scene.camera.body_from_camera.translation().isZero());
    EXPECT_DOUBLE_EQ(scene.image_rate_hz, 30.0);
    EXPECT_DOUBLE_EQ(scene.navigation_rate_hz, 100.0);
    EXPECT_FALSE(scene.duration_s.has_value());
}

TEST(Scene, ReadsCameraAndMounting) {
    const Scene scene = scene_of(
        "name = \"meadow\"\n[ground]\n[camera]\nwidth_px = 320\nheight_px = 200\nfx_px = 300\n"
        "fy_px = 310\ncx_px = 150\ncy_px = 99\nbaseline_m = 0.2\ndisparity_sigma_px = 0.5\n"
        "position_m = [1, 2, 3]\npitch_deg = -30\nimage_rate_hz = 15\n" +
        flight);
    EXPECT_EQ(scene.name, "meadow");
    const Camera& camera = scene.camera;
    EXPECT_EQ(camera.width_px, 320);
    EXPECT_EQ(camera.height_px, 200);
    EXPECT_EQ(camera.fx_px, 300.0);
    EXPECT_EQ(camera.fy_px, 310.0);
    EXPECT_EQ(camera.cx_px, 150.0);
    EXPECT_EQ(camera.cy_px, 99.0);
    EXPECT_EQ(camera.stereo->baseline_m, 0.2);
    EXPECT_EQ(camera.stereo->disparity_sigma_px, 0.5);
    EXPECT_EQ(camera.body_from_camera.translation(), Eigen::Vector3d(1, 2, 3));
    // The optical axis looks 30 degrees down: forward and down are cos 30 and sin 30.
    EXPECT_TRUE(camera.body_from_camera.linear().col(2).isApprox(
        Eigen::Vector3d(std::sqrt(0.75), 0.0, 0.5), 1e-12));
    EXPECT_EQ(scene.image_rate_hz, 15.0);
    // A smaller image sees the same angles.
    const Scene small = scene_of("[ground]\n[camera]\nwidth_px = 64\nheight_px = 48\n" + flight);
    EXPECT_DOUBLE_EQ(small.camera.fx_px, 32.0 / std::tan(25.5 * rad_per_deg));
    EXPECT_DOUBLE_EQ(small.camera.cy_px, 23.5);
}

TEST(Scene, ReadsTheFlight) {
    const Scene scene = scene_of(
        "[ground]\n[flight]\nduration_s = 90\nloop = true\nnavigation_rate_hz = 200\n"
        "[flight.limits]\nspeed_mps = 8\nacceleration_mps2 = 2\nclimb_mps = 3\n"
        "yaw_rate_degps = 45\n"
        "[[flight.waypoint]]\nnorth_m = 1\neast_m = 2\nheight_m = 3\n"
        "[[flight.waypoint]]\nnorth_m = 4\neast_m = 5\nabove_ground_m = 6\nspeed_mps = 7\n"
        "yaw_deg = 90\nhold_s = 2\n");
    EXPECT_EQ(scene.duration_s, 90.0);
    EXPECT_TRUE(scene.route.loop);
    EXPECT_EQ(scene.navigation_rate_hz, 200.0);
    EXPECT_EQ(scene.route.limits.speed_mps, 8.0);
    EXPECT_EQ(scene.route.limits.acceleration_mps2, 2.0);
    EXPECT_EQ(scene.route.limits.climb_mps, 3.0);
    EXPECT_DOUBLE_EQ(scene.route.limits.yaw_rate_radps, std::numbers::pi / 4.0);
    ASSERT_EQ(scene.route.waypoints.size(), 2U);
    const Waypoint& first = scene.route.waypoints[0];
    EXPECT_EQ(first.position_m, Eigen::Vector3d(1, 2, -3));
    EXPECT_EQ(first.speed_mps, 5.0);
    EXPECT_FALSE(first.yaw_rad.has_value());
    EXPECT_EQ(first.hold_s, 0.0);
    const Waypoint& second = scene.route.waypoints[1];
    EXPECT_EQ(second.position_m, Eigen::Vector3d(4, 5, -6));
    EXPECT_EQ(second.speed_mps, 7.0);
    EXPECT_DOUBLE_EQ(*second.yaw_rad, std::numbers::pi / 2.0);
    EXPECT_EQ(second.hold_s, 2.0);
}

TEST(Scene, NamesWhatStandsInIt) {
    const Scene scene = scene_of(
        "[ground]\ntexture = 0.25\n"
        "[[tree]]\nnorth_m = 5\neast_m = 6\n"
        "[[tree]]\nname = \"oak\"\nnorth_m = 15\neast_m = 6\ntexture = 0.5\n"
        "[[row]]\nof = \"tree\"\nstart_m = [0, 30]\nend_m = [20, 30]\nnumber = 3\n"
        "[[row]]\nof = \"bush\"\nstart_m = [0, 40]\nend_m = [20, 40]\nnumber = 2\n"
        "[[bush]]\nnorth_m = 1\neast_m = 1\n"
        "[[building]]\nnorth_m = 50\neast_m = 50\nlength_m = 9\nwidth_m = 8\nheight_m = 7\n"
        "[[wire]]\nstart_m = [0, 0, 9]\nend_m = [50, 0, 9]\n"
        "[[mast]]\nnorth_m = 0\neast_m = 0\nheight_m = 9\n"
        "[[aircraft]]\nnorth_m = -20\neast_m = 0\n"
        "[tunnel]\ndiameter_m = 5\n[[tunnel.point]]\nnorth_m = 0\neast_m = 99\nheight_m = 0\n"
        "[[tunnel.point]]\nnorth_m = 9\neast_m = 99\nheight_m = 0\n"
        "[[forest]]\nnumber = 2\nnorth_m = [100, 110]\neast_m = [0, 10]\n"
        "[[vehicle]]\nmodel = \"helicopter\"\n"
        "[[vehicle.waypoint]]\nnorth_m = 0\neast_m = 0\nheight_m = 9\n"
        "[[vehicle.waypoint]]\nnorth_m = 9\neast_m = 0\nheight_m = 9\n" +
        flight);
    EXPECT_THAT(names_of(scene), ::testing::ElementsAre(
                                     "ground", "tree 1", "oak", "bush 1", "tree 2", "tree 3",
                                     "tree 4", "bush 2", "bush 3", "building 1", "wire 1", "mast 1",
                                     "tunnel 1", "aircraft 1", "vehicle 1", "tree 5", "tree 6"));
    ASSERT_EQ(scene.texture.size(), scene.surfaces.obstacles.size());
    EXPECT_EQ(scene.texture[0], 0.25);
    EXPECT_EQ(scene.texture[1], 1.0);
    EXPECT_EQ(scene.texture[2], 0.5);
    ASSERT_EQ(scene.vehicles.size(), 1U);
    const TrueObstacle& vehicle = scene.surfaces.obstacles[scene.vehicles[0].obstacle];
    EXPECT_EQ(vehicle.name, "vehicle 1");
    EXPECT_TRUE(vehicle.moving);
    EXPECT_EQ(vehicle.kind, ObstacleKind::aircraft);
    EXPECT_EQ(scene.vehicles[0].route.waypoints[1].position_m, Eigen::Vector3d(9, 0, -9));
    EXPECT_EQ(std::ranges::count(scene.surfaces.obstacles, true, &TrueObstacle::moving), 1);
    EXPECT_NEAR(bounds_of(scene, "vehicle 1").center().y(), 0.0, 1e-5); // in its own frame
    // The ground reaches 150 m beyond everything: the trees at 110, the tunnel at 99 + 2.8.
    EXPECT_GE(bounds_of(scene, "ground").max().x(), 100.0 + 150.0);
    EXPECT_GE(bounds_of(scene, "ground").max().y(), 101.0 + 150.0);
    EXPECT_LE(bounds_of(scene, "ground").max().x(), 115.0 + 150.0 + 20.0);
}

TEST(Scene, PutsThingsWhereTheFileSaysOnTheGround) {
    const SceneFolder folder(
        "[terrain]\nheights = \"hill.npy\"\nnorth_m = [0, 100]\neast_m = [0, 100]\n"
        "[[building]]\nnorth_m = 50\neast_m = 50\nlength_m = 20\nwidth_m = 4\nheight_m = 7\n"
        "yaw_deg = 90\n"
        "[[aircraft]]\nnorth_m = 20\neast_m = 30\nlength_m = 8\nspan_m = 12\nyaw_deg = 90\n"
        "[[tree]]\nnorth_m = 80\neast_m = 10\nheight_m = 9\n"
        "[[row]]\nof = \"bush\"\nstart_m = [10, 90]\nend_m = [50, 70]\nnumber = 3\n"
        "height_m = 1.5\ndiameter_m = 2\n"
        "[[wire]]\nstart_m = [0, 20, 8]\nend_m = [100, 20, 8]\nsag_m = 0\ndiameter_m = 0.02\n"
        "[[flight.waypoint]]\nnorth_m = 10\neast_m = 0\nabove_ground_m = 5\n"
        "[[flight.waypoint]]\nnorth_m = 50\neast_m = 0\nheight_m = 5\n");
    // A slope: 10 m up over 100 m to the north.
    write_npy(folder.path() / "hill.npy", {{2, 2}, {0, 0, 10, 10}});
    const Scene scene = folder.read();
    const Eigen::AlignedBox3d house = bounds_of(scene, "building 1");
    EXPECT_NEAR(house.min().x(), 48.0, 1e-4); // turned by 90 degrees: long from west to east
    EXPECT_NEAR(house.max().x(), 52.0, 1e-4);
    EXPECT_NEAR(house.min().y(), 40.0, 1e-4);
    EXPECT_NEAR(house.max().y(), 60.0, 1e-4);
    EXPECT_NEAR(house.min().z(), -(5.0 + 7.0), 1e-4);
    EXPECT_GE(house.max().z(), -4.8); // down to the ground of its lower side and into it
    const Eigen::AlignedBox3d aircraft = bounds_of(scene, "aircraft 1");
    EXPECT_NEAR(aircraft.max().z(), -2.0, 1e-4);  // wheels on the ground
    EXPECT_NEAR(aircraft.sizes().x(), 12.0, 0.1); // its span, as the nose is to the east
    EXPECT_NEAR(aircraft.max().y(), 34.0, 0.1);
    const Eigen::AlignedBox3d tree = bounds_of(scene, "tree 1");
    EXPECT_NEAR(tree.min().z(), -(8.0 + 9.0), 1e-4);
    EXPECT_NEAR(tree.center().x(), 80.0, 1.0);
    EXPECT_NEAR(tree.center().y(), 10.0, 1.0);
    for (int i = 0; i < 3; ++i) {
        const Eigen::AlignedBox3d bush = bounds_of(scene, "bush " + std::to_string(i + 1));
        EXPECT_NEAR(bush.center().x(), 10.0 + 20.0 * i, 0.3);
        EXPECT_NEAR(bush.center().y(), 90.0 - 10.0 * i, 0.3);
        EXPECT_NEAR(bush.min().z(), -(1.0 + 2.0 * i + 1.5), 1e-4);
    }
    const Eigen::AlignedBox3d wire = bounds_of(scene, "wire 1");
    EXPECT_NEAR(wire.min().z(), -18.0, 0.05);
    EXPECT_NEAR(wire.max().z(), -8.0, 0.05);
    EXPECT_NEAR(scene.route.waypoints[0].position_m.z(), -6.0, 1e-9);
    EXPECT_NEAR(scene.route.waypoints[1].position_m.z(), -5.0, 1e-9);
}

TEST(Scene, ReadsMeshesAsOtherProgramsWriteThem) {
    const SceneFolder folder(
        "[[mesh]]\nfile = \"slab.obj\"\nnorth_m = 100\neast_m = 200\nheight_m = 5\nscale = 2\n"
        "axes = \"y_up\"\nyaw_deg = 90\n"
        "[[mesh]]\nname = \"post\"\nfile = \"post.ply\"\nnorth_m = 0\neast_m = 0\n" +
        flight);
    // A square in the plane z = -1 (forward 1), x 0 ... 3 (right), y 0 ... 2 (up), seen from
    // behind.
    folder.write("slab.obj", "v 0 0 -1\nv 3 0 -1\nv 3 2 -1\nv 0 2 -1\nf 1 2 3 4\n");
    folder.write("post.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "end_header\n1 0 0\n1 4 0\n1 0 6\n3 0 1 2\n");
    const Scene scene = folder.read();
    EXPECT_THAT(names_of(scene), ::testing::ElementsAre("mesh 1", "post"));
    EXPECT_EQ(scene.surfaces.obstacles[0].triangles, 2U);
    const Eigen::AlignedBox3d slab = bounds_of(scene, "mesh 1");
    EXPECT_TRUE(slab.min().isApprox(Eigen::Vector3d(94, 202, -9), 1e-6));
    EXPECT_TRUE(slab.max().isApprox(Eigen::Vector3d(100, 202, -5), 1e-6));
    // Its front, where the corners turn counter-clockwise, is backward: west, as it looks east.
    const auto& [a, b, c] = scene.surfaces.triangles[0];
    const std::vector<Eigen::Vector3f>& vertices = scene.surfaces.vertices_m;
    EXPECT_LT((vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).y(), 0.0F);
    const Eigen::AlignedBox3d post = bounds_of(scene, "post"); // z up, y to the left
    EXPECT_TRUE(post.min().isApprox(Eigen::Vector3d(1, -4, -6), 1e-6));
    EXPECT_TRUE(post.max().isApprox(Eigen::Vector3d(1, 0, 0), 1e-6));
}

const std::string random_things =
    "[terrain]\nrelief_m = 5\nwavelength_m = 80\n"
    "[[tree]]\nnorth_m = 5\neast_m = 6\n"
    "[[row]]\nof = \"bush\"\nstart_m = [0, 40]\nend_m = [20, 40]\nnumber = 2\n"
    "[[forest]]\nnumber = 60\nnorth_m = [-30, 70]\neast_m = [-50, 50]\nspacing_m = 6\n"
    "route_clearance_m = 15\nspecies = \"mixed\"\n";

TEST(Scene, OfOneSeedIsTheSameAndOfAnotherIsNot) {
    const Scene first = scene_of(random_things + flight, 11);
    const Scene again = scene_of(random_things + flight, 11);
    EXPECT_EQ(first.surfaces.vertices_m, again.surfaces.vertices_m);
    EXPECT_EQ(first.surfaces.triangles, again.surfaces.triangles);
    const Scene other = scene_of(random_things + flight, 12);
    for (const char* name : {"ground", "tree 1", "bush 1", "bush 2", "tree 2", "tree 61"}) {
        EXPECT_FALSE(bounds_of(first, name).isApprox(bounds_of(other, name), 1e-6)) << name;
    }
    // One more tree of its own leaves the others as they are.
    const Scene more =
        scene_of(random_things + "[[bush]]\nnorth_m = 70\neast_m = 70\n" + flight, 11);
    EXPECT_TRUE(bounds_of(first, "tree 61").isApprox(bounds_of(more, "tree 61"), 0.0));
}

TEST(Scene, GivesEveryTableNumbersOfItsOwn) {
    const std::string tree = "[[tree]]\nnorth_m = 20\neast_m = 20\nheight_m = [5, 10]\n";
    const std::string row =
        "[[row]]\nof = \"tree\"\nstart_m = [20, 20]\nend_m = [9, 9]\nnumber = 2\n"
        "height_m = [5, 10]\n";
    const Scene scene = scene_of(tree + tree + row + row + flight);
    std::vector<double> heights_m;
    for (const std::string& name : names_of(scene)) {
        heights_m.push_back(-bounds_of(scene, name).min().z());
        EXPECT_GE(heights_m.back(), 5.0);
        EXPECT_LE(heights_m.back(), 10.0);
    }
    ASSERT_EQ(heights_m.size(), 6U);
    std::ranges::sort(heights_m);
    for (std::size_t i = 1; i < heights_m.size(); ++i) {
        EXPECT_GT(heights_m[i], heights_m[i - 1] + 1e-5);
    }
}

TEST(Scene, SpacesTheTreesOfAForestAndKeepsThemOffTheRoute) {
    const Scene scene = scene_of(random_things + flight, 3);
    std::vector<Eigen::Vector2d> trunks;
    for (const TrueObstacle& obstacle : scene.surfaces.obstacles) {
        if (obstacle.kind == ObstacleKind::tree && obstacle.name != "tree 1") {
            // A coarse trunk is a ring of five around the place, in the ground.
            Eigen::Vector2d sum = Eigen::Vector2d::Zero();
            const auto first = scene.surfaces.triangles[obstacle.first_triangle][0];
            for (std::uint32_t k = 0; k < 5; ++k) {
                sum += scene.surfaces.vertices_m[first + k].head<2>().cast<double>() / 5.0;
            }
            trunks.push_back(sum);
        }
    }
    ASSERT_EQ(trunks.size(), 60U);
    for (std::size_t i = 0; i < trunks.size(); ++i) {
        EXPECT_NEAR(trunks[i].x(), 20.0, 50.0 + 1e-3);
        EXPECT_NEAR(trunks[i].y(), 0.0, 50.0 + 1e-3);
        // The route is 0 ... 50 north.
        const double beyond_m = std::max({0.0, -trunks[i].x(), trunks[i].x() - 50.0});
        EXPECT_GE(std::hypot(beyond_m, trunks[i].y()), 15.0 - 1e-3);
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_GE((trunks[i] - trunks[k]).norm(), 6.0 - 1e-3);
        }
    }
}

} // namespace
} // namespace zonegrid::testing
