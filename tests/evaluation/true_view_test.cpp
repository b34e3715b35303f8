#include "evaluation/true_view.h"

#include "evaluation/small_truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace zonegrid::testing {
namespace {

constexpr CellBox region{{-50, -50, -50}, {100, 50, 50}};

TrueView look(const Truth& truth, std::size_t every = 1) {
    const TouchedCells touched = touch_cells(truth.surfaces, 1.0, region);
    return look_around(truth, touched, draw_every_triangle(truth),
                       {1.0, 20.0, 0, truth.images.size(), every}, [](std::size_t) {});
}

TEST(TouchedCells, AreThoseCountedByHand) {
    const TouchedCells touched = touch_cells(wall_and_box().surfaces, 1.0, region);
    EXPECT_EQ(touched.of(0).size(), 121U);
    EXPECT_EQ(touched.of(1).size(), 34U);
    EXPECT_EQ(touched.all().size(), 155U);
    EXPECT_FALSE(touched.all().contains({6, 0, 0}));
    EXPECT_EQ(touched.obstacles_within({9, 0, 0}, 0), std::vector<std::uint32_t>());
    EXPECT_EQ(touched.obstacles_within({9, 0, 0}, 1), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(touched.obstacles_within({9, 3, 0}, 1), std::vector<std::uint32_t>{0});
}

TEST(TrueView, ShowsTheFrontAndWhatItsShadowLeavesOfTheWall) {
    const TrueView view = look(wall_and_box());
    EXPECT_EQ(view.surface.size(), wall_and_box_visible);
    EXPECT_EQ(view.surface_of[0].size(), 96U);
    EXPECT_EQ(view.surface_of[1].size(), 9U);
    EXPECT_TRUE(view.surface_of[0].contains({10, 3, 0}));
    EXPECT_FALSE(view.surface_of[0].contains({10, 2, 0}));
    EXPECT_TRUE(view.surface_of[1].contains({5, 0, 0}));
    EXPECT_EQ(view.unplaced_hits, 0U);
    EXPECT_GT(view.hits, 2000U);
}

TEST(TrueView, IsFreeBeforeSurfacesAndToTheRangeBesideThem) {
    const TrueView view = look(wall_and_box());
    for (std::int32_t x = 0; x < 5; ++x) {
        EXPECT_TRUE(view.free.contains({x, 0, 0})) << x;
    }
    for (std::int32_t x = 5; x < 20; ++x) {
        EXPECT_FALSE(view.free.contains({x, 0, 0})) << x;
    }
    EXPECT_FALSE(view.free.contains({7, 1, 1})); // touched
    // Beside the wall, at 45 degrees: 20 m along the ray are 14.1 m north.
    EXPECT_TRUE(view.free.contains({14, 14, 0}));
    EXPECT_FALSE(view.free.contains({15, 15, 0}));
    EXPECT_FALSE(view.free.contains({-1, 0, 0}));
}

TEST(TrueView, FindsFirstSightsBetweenTheImagesItLooksAt) {
    Truth truth;
    truth.camera = north_camera();
    add_rectangle(truth.surfaces, {Eigen::Vector3f(30.0F, -5.0F, -5.0F),
                                   {30.0F, 5.0F, -5.0F},
                                   {30.0F, 5.0F, 5.0F},
                                   {30.0F, -5.0F, 5.0F}});
    end_obstacle(truth.surfaces, "wall", ObstacleKind::building);
    for (int i = 0; i < 15; ++i) {
        truth.images.push_back(looking_north(0.1 * i, {0.5 + i, 0.5, 0.5}));
    }
    // The rays nearest to the axis are half a pixel off on both axes.
    const double slant = std::sqrt(1.0 + 2.0 * std::pow(0.5 / 64.0, 2));
    for (const std::size_t every : {1U, 4U, 7U}) {
        const TrueView view = look(truth, every);
        EXPECT_EQ(view.images, (15 + every - 1) / every);
        ASSERT_TRUE(view.first_sight[0].has_value());
        EXPECT_EQ(view.first_sight[0]->image, 10U) << every; // 29.5 - 10 is the first below 20
        EXPECT_NEAR(view.first_sight[0]->distance_m, 19.5 * slant, 1e-5);
    }
}

TEST(TrueView, FollowsRaysCloserThanHalfACellAtTheRange) {
    Camera camera = north_camera();
    camera.width_px = 640;
    camera.height_px = 480;
    camera.fx_px = 670.0;
    camera.fy_px = 660.0;
    // 0.5 m / 40 m * 660 px = 8.25 px
    EXPECT_EQ(pixel_stride(camera, 1.0, 40.0), 8);
    EXPECT_EQ(pixel_stride(camera, 0.25, 40.0), 2);
    EXPECT_EQ(pixel_stride(camera, 0.05, 40.0), 1);
}

} // namespace
} // namespace zonegrid::testing
