#include "truth/ray_caster.h"

#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Collects obstacles one after the other.
class World {
public:
    using Corners = std::array<Eigen::Vector3f, 3>;

    World& add(const std::string& name, const std::vector<Corners>& triangles,
               bool moving = false) {
        TrueObstacle obstacle;
        obstacle.name = name;
        obstacle.first_triangle = static_cast<std::uint32_t>(surfaces.triangles.size());
        obstacle.triangles = static_cast<std::uint32_t>(triangles.size());
        obstacle.moving = moving;
        for (const Corners& corners : triangles) {
            const auto first = static_cast<std::uint32_t>(surfaces.vertices_m.size());
            surfaces.vertices_m.insert(surfaces.vertices_m.end(), corners.begin(), corners.end());
            surfaces.triangles.push_back({first, first + 1, first + 2});
        }
        surfaces.obstacles.push_back(obstacle);
        return *this;
    }

    Surfaces surfaces;
};

/// A square across the x axis at `x_m`, its middle on the axis.
std::vector<World::Corners> square(float x_m, float half_m) {
    const Eigen::Vector3f a(x_m, -half_m, -half_m);
    const Eigen::Vector3f b(x_m, half_m, -half_m);
    const Eigen::Vector3f c(x_m, half_m, half_m);
    const Eigen::Vector3f d(x_m, -half_m, half_m);
    return {{a, b, c}, {a, c, d}};
}

/// A sphere around the origin, of `rings` times twice as many cells.
std::vector<World::Corners> sphere(float radius_m, int rings) {
    const auto at = [&](int ring, int slice) {
        const double polar = std::numbers::pi * ring / rings;
        const double around = std::numbers::pi * slice / rings;
        return Eigen::Vector3f(Eigen::Vector3d(radius_m * std::sin(polar) * std::cos(around),
                                               radius_m * std::sin(polar) * std::sin(around),
                                               radius_m * std::cos(polar))
                                   .cast<float>());
    };
    std::vector<World::Corners> triangles;
    for (int ring = 0; ring < rings; ++ring) {
        for (int slice = 0; slice < 2 * rings; ++slice) {
            triangles.push_back({at(ring, slice), at(ring + 1, slice), at(ring + 1, slice + 1)});
            triangles.push_back({at(ring, slice), at(ring + 1, slice + 1), at(ring, slice + 1)});
        }
    }
    return triangles;
}

Camera small_camera() {
    Camera camera;
    camera.width_px = 61; // odd, and no multiple of a packet
    camera.height_px = 43;
    camera.fx_px = 50.0;
    camera.fy_px = 55.0;
    camera.cx_px = 29.5;
    camera.cy_px = 22.0;
    return camera;
}

/// Looks along x, which is north.
Eigen::Isometry3d looking_north(const Eigen::Vector3d& position_m) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = body_from_forward_camera();
    pose.translation() = position_m;
    return pose;
}

TEST(RayCaster, FindsTheDistanceToAPlaneExactly) {
    World world;
    world.add("wall", square(12.0F, 50.0F));
    const RayCaster caster(world.surfaces);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d start_m(-3.0 + 0.01 * i, 0.2, -0.1);
        const Eigen::Vector3d direction =
            Eigen::Vector3d(1.0, 0.01 * i - 1.0, 0.3 - 0.004 * i).normalized();
        const auto hit = caster.cast(start_m, direction);
        ASSERT_TRUE(hit) << i;
        EXPECT_NEAR(hit->distance_m, (12.0 - start_m.x()) / direction.x(), 1e-12) << i;
        EXPECT_EQ(hit->obstacle, 0U);
        EXPECT_NEAR(std::abs(hit->normal.x()), 1.0F, 1e-6F);
    }
}

TEST(RayCaster, SeesTheNearestObstacleAndTheSky) {
    World world;
    world.add("far", square(20.0F, 5.0F)).add("near", square(8.0F, 1.0F));
    const RayCaster caster(world.surfaces);
    const Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
    EXPECT_EQ(caster.cast(start_m, {1.0, 0.0, 0.0})->obstacle, 1U);
    EXPECT_DOUBLE_EQ(caster.cast(start_m, {1.0, 0.0, 0.0})->distance_m, 8.0);
    const Eigen::Vector3d beside = Eigen::Vector3d(20.0, 4.0, 0.0).normalized();
    EXPECT_EQ(caster.cast(start_m, beside)->obstacle, 0U);
    EXPECT_NEAR(caster.cast(start_m, beside)->distance_m, std::hypot(20.0, 4.0), 1e-12);
    EXPECT_FALSE(caster.cast(start_m, {-1.0, 0.0, 0.0}));
    EXPECT_FALSE(caster.cast(start_m, {0.0, 0.0, -1.0}));
}

TEST(RayCaster, LeavesASphereNowhere) {
    // From inside a closed sphere of triangles every ray meets it, within the cut of its facets.
    constexpr int rings = 40;
    World world;
    world.add("sphere", sphere(10.0F, rings));
    const RayCaster caster(world.surfaces);
    const double deepest_m =
        10.0 * std::cos(std::numbers::pi / 2.0 / rings) * std::cos(std::numbers::pi / 2.0 / rings);
    for (int i = 0; i < 100; ++i) {
        for (int k = 0; k < 100; ++k) {
            const double polar = 0.01 + 0.0312 * i;
            const double around = 0.0628 * k;
            const Eigen::Vector3d direction(std::sin(polar) * std::cos(around),
                                            std::sin(polar) * std::sin(around), std::cos(polar));
            const auto hit = caster.cast(Eigen::Vector3d::Zero(), direction);
            ASSERT_TRUE(hit) << i << " " << k;
            EXPECT_LE(hit->distance_m, 10.0 + 1e-5);
            EXPECT_GE(hit->distance_m, deepest_m - 1e-5);
        }
    }
}

TEST(RayCaster, DrawsDepthAlongTheOpticalAxis) {
    World world;
    world.add("wall", square(12.0F, 5.0F)).add("plate", square(6.0F, 0.5F));
    const RayCaster caster(world.surfaces);
    const Camera camera = small_camera();
    const std::size_t pixels = 61 * 43;
    std::vector<float> depth_m(pixels);
    std::vector<std::uint32_t> obstacles(pixels);
    caster.draw(camera, looking_north({1.0, 0.1, 0.0}), depth_m, obstacles);
    for (int v = 0; v < 43; ++v) {
        for (int u = 0; u < 61; ++u) {
            // Where the pixel's line meets the planes, by hand: x north, y right, z down.
            const double right = (u - 29.5) / 50.0;
            const double below = (v - 22.0) / 55.0;
            const auto within = [&](double ahead_m, double half_m) {
                return std::abs(0.1 + right * ahead_m) < half_m &&
                       std::abs(below * ahead_m) < half_m;
            };
            const auto pixel = static_cast<std::size_t>(61 * v + u);
            if (within(5.0, 0.5)) {
                EXPECT_EQ(depth_m[pixel], 5.0F);
                EXPECT_EQ(obstacles[pixel], 1U);
            } else if (within(11.0, 5.0)) {
                EXPECT_EQ(depth_m[pixel], 11.0F);
                EXPECT_EQ(obstacles[pixel], 0U);
            } else {
                EXPECT_EQ(depth_m[pixel], std::numeric_limits<float>::infinity());
                EXPECT_EQ(obstacles[pixel], sky_obstacle);
            }
        }
    }
}

TEST(RayCaster, DrawsWhatItCasts) {
    World world;
    world.add("sphere", sphere(3.0F, 20));
    const RayCaster caster(world.surfaces);
    const Camera camera = small_camera();
    std::vector<float> depth_m(61 * 43);
    const Eigen::Isometry3d pose = looking_north({-6.0, 0.3, 0.2});
    caster.draw(camera, pose, depth_m);
    int hits = 0;
    for (int v = 0; v < 43; ++v) {
        for (int u = 0; u < 61; ++u) {
            const Eigen::Vector3d step =
                pose.linear() * Eigen::Vector3d((u - 29.5) / 50.0, (v - 22.0) / 55.0, 1.0);
            const auto hit = caster.cast(pose.translation(), step.normalized());
            const float drawn_m = depth_m[static_cast<std::size_t>(61 * v + u)];
            ASSERT_EQ(hit.has_value(), std::isfinite(drawn_m)) << u << " " << v;
            if (hit) {
                EXPECT_NEAR(hit->distance_m / step.norm(), drawn_m, 2e-6);
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, 500);
}

TEST(RayCaster, MovesObstacles) {
    World world;
    world.add("wall", square(30.0F, 50.0F)).add("vehicle", square(0.0F, 1.0F), true);
    MovingPose start;
    start.world_from_obstacle.translation() = Eigen::Vector3d(10.0, 0.0, 0.0);
    MovingPose end;
    end.time_s = 4.0;
    end.world_from_obstacle.translation() = Eigen::Vector3d(18.0, 4.0, 0.0);
    const std::vector<ObstacleMotion> motions{{1, {start, end}}};
    RayCaster caster(world.surfaces, motions);
    const Eigen::Vector3d ahead(1.0, 0.0, 0.0);
    EXPECT_DOUBLE_EQ(caster.cast(Eigen::Vector3d::Zero(), ahead)->distance_m, 10.0);
    EXPECT_EQ(caster.cast(Eigen::Vector3d::Zero(), ahead)->obstacle, 1U);
    caster.move_to(2.0); // half way: beside the ray, 14 m ahead
    EXPECT_EQ(caster.cast(Eigen::Vector3d::Zero(), ahead)->obstacle, 0U);
    EXPECT_DOUBLE_EQ(caster.cast({0.0, 2.0, 0.0}, ahead)->distance_m, 14.0);
    std::vector<float> depth_m(61 * 43);
    std::vector<std::uint32_t> obstacles(61 * 43);
    caster.draw(small_camera(), looking_north({0.0, 2.0, 0.0}), depth_m, obstacles);
    EXPECT_EQ(depth_m[22 * 61 + 29], 14.0F);
    EXPECT_EQ(obstacles[22 * 61 + 29], 1U);
}

TEST(RayCaster, TurnsObstacles) {
    World world;
    world.add("vehicle", square(0.0F, 1.0F), true);
    MovingPose pose;
    pose.world_from_obstacle.translation() = Eigen::Vector3d(10.0, 0.0, 0.0);
    pose.world_from_obstacle.linear() =
        Eigen::AngleAxisd(std::numbers::pi / 4.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const std::vector<ObstacleMotion> motions{{0, {pose}}};
    const RayCaster caster(world.surfaces, motions);
    const auto hit = caster.cast({0.0, 0.1, 0.0}, {1.0, 0.0, 0.0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance_m, 9.9, 1e-12); // the plate runs along x - 10 = -y
    EXPECT_NEAR(std::abs(hit->normal.y()), std::sqrt(0.5), 1e-6);
}

TEST(RayCaster, RefusesMotionsThatDoNotFit) {
    World world;
    world.add("wall", square(30.0F, 5.0F)).add("vehicle", square(0.0F, 1.0F), true);
    EXPECT_THAT([&] { const RayCaster caster(world.surfaces); },
                ThrowsMessage<UsageError>(HasSubstr("'vehicle' has 0 motions")));
    const std::vector<ObstacleMotion> wrong{{0, {MovingPose{}}}};
    EXPECT_THAT([&] { const RayCaster caster(world.surfaces, wrong); },
                ThrowsMessage<UsageError>(HasSubstr("obstacle 0, which does not move")));
}

TEST(RayCaster, RefusesRaysThatSinglePrecisionCannotHold) {
    World world;
    world.add("wall", square(30.0F, 5.0F));
    const RayCaster caster(world.surfaces);
    EXPECT_THROW(static_cast<void>(caster.cast({0.0, 1e300, 0.0}, {1.0, 0.0, 0.0})), UsageError);
    std::vector<float> depth_m(61 * 43);
    EXPECT_THROW(caster.draw(small_camera(), looking_north({0.0, 0.0, -1e30}), depth_m),
                 UsageError);
    Camera aside = small_camera();
    aside.cx_px = 1e308;
    EXPECT_THROW(caster.draw(aside, looking_north(Eigen::Vector3d::Zero()), depth_m), UsageError);
}

TEST(RayCaster, SeesSkyWhereThereIsNoSurface) {
    const Surfaces nothing;
    const RayCaster caster(nothing);
    EXPECT_FALSE(caster.cast(Eigen::Vector3d::Zero(), {1.0, 0.0, 0.0}));
    std::vector<float> depth_m(61 * 43);
    caster.draw(small_camera(), looking_north(Eigen::Vector3d::Zero()), depth_m);
    EXPECT_TRUE(std::ranges::all_of(depth_m, [](float value) { return std::isinf(value); }));
    std::vector<float> wrong(5);
    EXPECT_THROW(caster.draw(small_camera(), looking_north(Eigen::Vector3d::Zero()), wrong),
                 UsageError);
}

} // namespace
} // namespace zonegrid::testing
