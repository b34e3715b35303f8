#include "evaluation/moving_measures.h"

#include "evaluation/small_truth.h"

#include <gtest/gtest.h>

namespace zonegrid::testing {
namespace {

/// A cube that lies within one cell, (10, -4 + 2 i, 0) when image i is taken, i = 0 .. 4.
Truth passing_cube() {
    Truth truth;
    truth.camera = north_camera();
    add_box(truth.surfaces, {-0.4F, -0.4F, -0.4F}, {0.4F, 0.4F, 0.4F});
    end_obstacle(truth.surfaces, "second", ObstacleKind::aircraft, true);
    ObstacleMotion motion;
    for (int i = 0; i < 5; ++i) {
        truth.images.push_back(looking_north(i, {0.5, 0.5, 0.5}));
        MovingPose pose;
        pose.time_s = i;
        pose.world_from_obstacle.translation() = Eigen::Vector3d(10.5, -3.5 + 2.0 * i, 0.5);
        motion.poses.push_back(pose);
    }
    truth.motions.push_back(motion);
    return truth;
}

MovingMeasures judge(const CellSet& occupied, std::uint32_t image) {
    const Truth truth = passing_cube();
    const Evaluation marks = evaluate(map_of(truth, occupied, {}, image), truth);
    EXPECT_TRUE(marks.obstacles.empty());
    EXPECT_EQ(marks.moving.size(), 1U);
    return marks.moving.at(0);
}

CellSet one(const CellIndex& cell) {
    return cells_of_box(cell, cell);
}

TEST(Moving, CellsLeftBehindAreATrail) {
    const auto marks = judge(one({10, -2, 0}), 1);
    EXPECT_EQ(marks.trail_cells, 1U);
    ASSERT_TRUE(marks.detection.has_value());
    EXPECT_EQ(marks.detection->image, 1U);
    EXPECT_DOUBLE_EQ(marks.detection->distance_m, std::hypot(10.0, 2.0));
    ASSERT_TRUE(marks.first_sight.has_value());
    EXPECT_EQ(marks.first_sight->image, 0U);
}

TEST(Moving, CellsThatAppearWhereItIsNotAnyMoreAreNoDetection) {
    const auto marks = judge(one({10, -2, 0}), 3);
    EXPECT_EQ(marks.trail_cells, 1U);
    EXPECT_FALSE(marks.detection.has_value());
}

TEST(Moving, CellsWhereItIsAtTheEndAreNoTrailAndNoFalseObstacle) {
    const Truth truth = passing_cube();
    const Evaluation marks = evaluate(map_of(truth, one({10, 4, 0}), {}, 4), truth);
    EXPECT_EQ(marks.moving.at(0).trail_cells, 0U);
    EXPECT_EQ(marks.cells.precision[0].count, 1U);
    const Evaluation behind = evaluate(map_of(truth, one({10, -4, 0}), {}, 4), truth);
    EXPECT_EQ(behind.cells.precision[2].count, 0U);
}

TEST(Moving, SurfacesAreNotFreeWhereTheyAreSeen) {
    Truth truth;
    truth.camera = north_camera();
    truth.images.push_back(looking_north(0.0, {0.5, 0.5, 0.5}));
    add_box(truth.surfaces, {-0.1F, -3.0F, -3.0F}, {0.1F, 3.0F, 3.0F});
    end_obstacle(truth.surfaces, "plate", ObstacleKind::other, true);
    MovingPose pose;
    pose.world_from_obstacle.translation() = Eigen::Vector3d(10.5, 0.5, 0.5);
    truth.motions.push_back({0, {pose}});
    const CellBox region{{-50, -50, -50}, {50, 50, 50}};
    const TrueView view =
        look_around(truth, touch_cells(truth.surfaces, 1.0, region), draw_every_triangle(truth),
                    {1.0, 20.0, 0, 1, 1}, [](std::size_t) {});
    EXPECT_FALSE(view.free.contains({10, 0, 0}));
    EXPECT_TRUE(view.free.contains({9, 0, 0}));
    EXPECT_TRUE(view.surface.empty());
    ASSERT_TRUE(view.first_sight[0].has_value());
    EXPECT_NEAR(view.first_sight[0]->distance_m, 9.9, 0.01);
}

TEST(Moving, CellsFarFromItsWayAreNot) {
    const auto marks = judge(one({10, 8, 0}), 4);
    EXPECT_EQ(marks.trail_cells, 0U);
    EXPECT_FALSE(marks.detection.has_value());
}

} // namespace
} // namespace zonegrid::testing
