#include "simulation/terrain.h"

#include "io/seeded_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace zonegrid::testing {
namespace {

/// Height of the first triangle over a place, by the triangle's own plane.
std::optional<double> surface_height_m(const Shape& ground, double north_m, double east_m) {
    for (const auto& [a, b, c] : ground.triangles) {
        const Eigen::Vector3d corner = ground.vertices_m[a];
        Eigen::Matrix2d sides;
        sides.col(0) = (ground.vertices_m[b] - corner).head<2>();
        sides.col(1) = (ground.vertices_m[c] - corner).head<2>();
        const Eigen::Vector2d shares =
            sides.inverse() * (Eigen::Vector2d(north_m, east_m) - corner.head<2>());
        if (shares.minCoeff() >= 0.0 && shares.sum() <= 1.0) {
            return -(corner.z() + shares.x() * (ground.vertices_m[b] - corner).z() +
                     shares.y() * (ground.vertices_m[c] - corner).z());
        }
    }
    return std::nullopt;
}

void expect_heights_of_triangles(const Terrain& terrain, double least_m, double most_m) {
    const Shape ground = terrain.ground_shape({least_m, least_m}, {most_m, most_m});
    SeededNumbers numbers(3, 0);
    for (int i = 0; i < 200; ++i) {
        const double north_m = numbers.real(least_m, most_m);
        const double east_m = numbers.real(least_m, most_m);
        const std::optional<double> surface_m = surface_height_m(ground, north_m, east_m);
        ASSERT_TRUE(surface_m.has_value()) << north_m << " " << east_m;
        EXPECT_NEAR(terrain.height_m(north_m, east_m), *surface_m, 1e-9);
    }
    for (const auto& [a, b, c] : ground.triangles) {
        const Eigen::Vector3d normal = (ground.vertices_m[b] - ground.vertices_m[a])
                                           .cross(ground.vertices_m[c] - ground.vertices_m[a]);
        EXPECT_LT(normal.z(), 0.0); // up
    }
}

TEST(Terrain, HasTheGivenHeightsAtItsNodesAndPlanesBetween) {
    HeightGrid grid;
    grid.least_m = {0.0, 10.0};
    grid.most_m = {20.0, 40.0};
    grid.rows = 2;
    grid.columns = 3;
    grid.heights_m = {0, 2, 4, 1, 5, 3}; // spacing 20 north, 15 east
    const Terrain terrain(grid);
    EXPECT_DOUBLE_EQ(terrain.height_m(0, 10), 0.0);
    EXPECT_DOUBLE_EQ(terrain.height_m(20, 25), 5.0);
    EXPECT_DOUBLE_EQ(terrain.height_m(20, 40), 3.0);
    EXPECT_DOUBLE_EQ(terrain.height_m(10, 17.5), 2.5);   // the diagonal from 0 to 5
    EXPECT_DOUBLE_EQ(terrain.height_m(15, 13.75), 1.75); // 0 + 0.75 * (1 - 0) + 0.25 * (5 - 1)
    EXPECT_DOUBLE_EQ(terrain.height_m(5, 21.25), 2.25);  // 0 + 0.75 * (2 - 0) + 0.25 * (5 - 2)
    EXPECT_DOUBLE_EQ(terrain.height_m(-7, 10), 0.0);     // the edge's height beyond it
    EXPECT_DOUBLE_EQ(terrain.height_m(300, 400), 3.0);
    const Shape ground = terrain.ground_shape({0, 0}, {1, 1});
    EXPECT_EQ(ground.vertices_m.size(), 6U);
    EXPECT_EQ(ground.triangles.size(), 4U);
    EXPECT_EQ(ground.vertices_m[5], Eigen::Vector3d(20, 40, -3));
}

TEST(Terrain, IsTheSurfaceOfItsTriangles) {
    expect_heights_of_triangles(Terrain(7.0), -30.0, 40.0);
    expect_heights_of_triangles(Terrain(5.0, {8.0, 40.0, 3, 5}), -30.0, 40.0);
    HeightGrid grid{{-30, -30}, {40, 40}, 4, 3, {1, 2, 3, 9, 5, 2, -4, 0, 1, 7, 8, 3}};
    expect_heights_of_triangles(Terrain(grid), -30.0, 40.0);
}

TEST(Terrain, CoversTheRectangleThatIsAskedFor) {
    const Shape ground = Terrain(20.0).ground_shape({-35, 3}, {15, 41});
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& vertex : ground.vertices_m) {
        bounds.extend(vertex);
    }
    EXPECT_EQ(bounds.min(), Eigen::Vector3d(-40, 0, 0));
    EXPECT_EQ(bounds.max(), Eigen::Vector3d(20, 60, 0));
    EXPECT_EQ(ground.triangles.size(), 3U * 3U * 2U);
}

TEST(Terrain, HillsKeepWithinTheirReliefAndDifferBySeed) {
    const HillNoise noise{12.0, 60.0, 3, 1};
    HillNoise other = noise;
    other.seed = 9;
    const Terrain hills(2.0, noise);
    const Terrain same(2.0, noise);
    const Terrain different(2.0, other);
    double least_m = 0.0;
    double most_m = 0.0;
    double steepest = 0.0;
    double difference_m = 0.0;
    for (double north_m = -300.0; north_m < 300.0; north_m += 2.0) {
        for (double east_m = -300.0; east_m < 300.0; east_m += 6.0) {
            const double height_m = hills.height_m(north_m, east_m);
            least_m = std::min(least_m, height_m);
            most_m = std::max(most_m, height_m);
            steepest =
                std::max(steepest, std::abs(hills.height_m(north_m + 2.0, east_m) - height_m));
            ASSERT_EQ(height_m, same.height_m(north_m, east_m));
            difference_m =
                std::max(difference_m, std::abs(different.height_m(north_m, east_m) - height_m));
        }
    }
    EXPECT_GE(least_m, -6.0);
    EXPECT_LE(most_m, 6.0);
    EXPECT_LT(least_m, -2.0); // and they are no plain
    EXPECT_GT(most_m, 2.0);
    EXPECT_LT(steepest, 2.0 * 1.0); // no cliffs: a slope of less than 45 degrees
    EXPECT_GT(difference_m, 2.0);
}

} // namespace
} // namespace zonegrid::testing
