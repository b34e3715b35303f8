#include "evaluation/obstacle_measures.h"

#include "evaluation/evaluation_json.h"
#include "evaluation/small_truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace zonegrid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Ground in the layer z = 2, and two posts on it, cells (6, -4, 0 .. 2) and (6, 3, 0 .. 2): the
/// lowest of each is one of the ground's too, so two of each are judged.
Truth two_posts() {
    Truth truth;
    truth.camera = north_camera();
    add_rectangle(truth.surfaces, {Eigen::Vector3f(1.2F, -6.8F, 2.5F),
                                   {14.8F, -6.8F, 2.5F},
                                   {14.8F, 6.8F, 2.5F},
                                   {1.2F, 6.8F, 2.5F}});
    end_obstacle(truth.surfaces, "floor", ObstacleKind::ground);
    add_box(truth.surfaces, {6.2F, -3.8F, 0.2F}, {6.8F, -3.2F, 2.5F});
    end_obstacle(truth.surfaces, "left", ObstacleKind::mast);
    add_box(truth.surfaces, {6.2F, 3.2F, 0.2F}, {6.8F, 3.8F, 2.5F});
    end_obstacle(truth.surfaces, "right", ObstacleKind::mast);
    for (int i = 0; i < 4; ++i) {
        truth.images.push_back(looking_north(10.0 + i, {0.5 + i, 0.5, 0.5}));
    }
    return truth;
}

CellSet posts() {
    CellSet cells = cells_of_box({6, -4, 0}, {6, -4, 2});
    cells.insert_all(cells_of_box({6, 3, 0}, {6, 3, 2}));
    return cells;
}

CellSet floor_cells() {
    return cells_of_box({1, -7, 2}, {14, 6, 2});
}

const ObstacleMeasures& named(const Evaluation& evaluation, const std::string& name) {
    for (const auto& obstacle : evaluation.obstacles) {
        if (obstacle.name == name) {
            return obstacle;
        }
    }
    throw std::runtime_error("no obstacle " + name);
}

TEST(Obstacles, StandingOnGroundAreJoinedWithItNotMerged) {
    const Truth truth = two_posts();
    CellSet occupied = posts();
    occupied.insert_all(floor_cells());
    const Evaluation marks = evaluate(map_of(truth, occupied, {}), truth);
    for (const char* const name : {"left", "right"}) {
        const auto& post = named(marks, name);
        EXPECT_TRUE(post.found) << name;
        EXPECT_EQ(post.found_cells.of, 2U);
        EXPECT_EQ(post.map_cells, 2U) << "its foot is the ground's";
        EXPECT_FALSE(post.judged_with_ground);
        EXPECT_TRUE(post.joined_with_ground);
        EXPECT_THAT(post.merged_with, IsEmpty());
        EXPECT_FALSE(post.split());
    }
    EXPECT_TRUE(named(marks, "floor").found);
}

TEST(Obstacles, StandOnGroundThatIsSolidBelowAsFarAsItReaches) {
    const Truth truth = two_posts();
    const Evaluation marks =
        evaluate(map_of(truth, {}, cells_of_box({-5, -10, -10}, {20, 9, 5})), truth);
    // Under the floor, x = 1 .. 14 and y = -7 .. 6: the layers z = 3 .. 5.
    EXPECT_EQ(marks.cells.wrong_free_solid.count, 14U * 14U * 3U);
    EXPECT_EQ(marks.cells.wrong_free_solid.of, 26U * 20U * 16U);
}

TEST(Obstacles, AreNotFoundInTheGroundBelowThem) {
    const Truth truth = two_posts();
    const Evaluation marks = evaluate(map_of(truth, floor_cells(), {}), truth);
    const auto& post = named(marks, "left");
    EXPECT_EQ(post.found_cells.count, 0U);
    EXPECT_EQ(post.map_cells, 0U);
    EXPECT_FALSE(post.found);
    EXPECT_FALSE(post.detection.has_value());
}

TEST(Obstacles, WhoseCellsAreAllTheGroundsAreNotFoundByIt) {
    Truth truth = two_posts();
    add_box(truth.surfaces, {6.2F, -0.8F, 2.1F}, {6.8F, 0.8F, 2.5F});
    end_obstacle(truth.surfaces, "sill", ObstacleKind::other);
    const Evaluation marks = evaluate(map_of(truth, floor_cells(), {}), truth);
    const auto& sill = named(marks, "sill");
    EXPECT_TRUE(sill.judged_with_ground);
    EXPECT_GT(sill.found_cells.count, 0U);
    EXPECT_FALSE(sill.found);
    EXPECT_TRUE(json_of(marks)["obstacles"]["each"][3]["found"].is_null());
}

TEST(Obstacles, AreMergedByABridgeOfCells) {
    const Truth truth = two_posts();
    CellSet occupied = posts();
    occupied.insert_all(cells_of_box({6, -3, 0}, {6, 2, 0}));
    const Evaluation marks = evaluate(map_of(truth, occupied, {}), truth);
    EXPECT_THAT(named(marks, "left").merged_with, ElementsAre("right"));
    EXPECT_THAT(named(marks, "right").merged_with, ElementsAre("left"));
    EXPECT_TRUE(named(marks, "left").merged());
}

TEST(Obstacles, ThatTouchInTruthAreMergedWithoutBlame) {
    Truth truth = two_posts();
    add_box(truth.surfaces, {6.2F, -3.2F, 0.2F}, {6.8F, 3.2F, 0.8F});
    end_obstacle(truth.surfaces, "beam", ObstacleKind::building);
    CellSet occupied = posts();
    occupied.insert_all(cells_of_box({6, -3, 0}, {6, 2, 0}));
    const Evaluation marks = evaluate(map_of(truth, occupied, {}), truth);
    EXPECT_THAT(named(marks, "left").merged_with, ElementsAre("right", "beam"));
    EXPECT_THAT(named(marks, "left").touching, ElementsAre("right", "beam"));
    EXPECT_FALSE(named(marks, "left").merged());
}

TEST(Obstacles, InTwoObjectsAreSplit) {
    const Truth truth = two_posts();
    CellSet occupied;
    occupied.insert({6, -4, 0});
    occupied.insert({6, -5, -1}); // a neighbour that shares an edge only
    const Evaluation marks = evaluate(map_of(truth, occupied, {}), truth);
    EXPECT_EQ(named(marks, "left").objects, 2U);
    EXPECT_TRUE(named(marks, "left").split());
    EXPECT_DOUBLE_EQ(named(marks, "left").largest_share, 0.5);
    EXPECT_TRUE(named(marks, "left").found);
}

TEST(Obstacles, HavePlacesAndSizesThatAreCompared) {
    const Truth truth = two_posts();
    CellSet occupied = cells_of_box({5, -4, -1}, {6, -4, -1}); // one up, and one cell wider
    occupied.insert_all(cells_of_box({5, -4, 0}, {6, -4, 0}));
    const Evaluation marks = evaluate(map_of(truth, occupied, {}), truth);
    const auto& post = named(marks, "left");
    EXPECT_EQ(*post.true_centre_m, Eigen::Vector3d(6.5, -3.5, 1.0));
    EXPECT_EQ(*post.centre_m, Eigen::Vector3d(6.0, -3.5, 0.0));
    EXPECT_DOUBLE_EQ(*post.horizontal_error_m, 0.5);
    EXPECT_DOUBLE_EQ(*post.vertical_error_m, 1.0);
    EXPECT_EQ(*post.size_m, Eigen::Vector3d(2, 1, 2));
    EXPECT_DOUBLE_EQ(*post.size_error_m, 1.0);
}

TEST(Obstacles, AreDetectedWithTheFirstCellThatStays) {
    const Truth truth = two_posts();
    CellSet occupied = posts();
    occupied.insert_all(floor_cells());
    JudgedMap map = map_of(truth, occupied, {}, 0);
    for (auto& cell : map.occupied_cells) {
        if (cell.cell == CellIndex{6, -4, 0}) {
            cell.since_image = 3;
        } else if (cell.cell == CellIndex{6, -4, 1}) {
            cell.since_image = 2;
        }
    }
    const Evaluation marks = evaluate(map, truth);
    const auto& post = named(marks, "left");
    ASSERT_TRUE(post.detection.has_value());
    EXPECT_EQ(post.detection->image, 2U); // the foot, since image 0, is the ground's
    EXPECT_EQ(post.detection->time_s, 12.0);
    // From (2.5, 0.5, 0.5) to the middle of (6, -4, 0).
    EXPECT_DOUBLE_EQ(post.detection->distance_m, std::hypot(4.0, 4.0));
    ASSERT_TRUE(post.first_sight.has_value());
    EXPECT_EQ(post.first_sight->image, 0U);
    EXPECT_EQ(named(marks, "right").detection->image, 0U);
}

TEST(Obstacles, AreErasedWhereTheyWereOccupiedOnce) {
    const Truth truth = two_posts();
    CellSet occupied = posts();
    occupied.insert_all(floor_cells());
    const auto marks_of = [&](const CellSet& at_the_end) {
        JudgedMap map = map_of(truth, at_the_end, {}, 0);
        map.ever_occupied = map_of(truth, occupied, {}, 0).ever_occupied;
        return evaluate(map, truth);
    };
    EXPECT_EQ(named(marks_of(occupied), "left").erased_cells.count, 0U);
    const Evaluation marks = marks_of(without(occupied, cells_of_box({6, -4, 0}, {6, -4, 0})));
    EXPECT_EQ(named(marks, "left").erased_cells.count, 1U);
    EXPECT_EQ(named(marks, "left").erased_cells.of, 2U);
    EXPECT_EQ(named(marks, "right").erased_cells.count, 0U);
    EXPECT_EQ(named(marks, "right").erased_cells.of, 2U);
}

ObstacleMeasures tree_at(double found_y_m, double x_m) {
    ObstacleMeasures tree;
    tree.kind = ObstacleKind::tree;
    tree.found = true;
    tree.centre_m = Eigen::Vector3d(x_m, found_y_m, -x_m);
    tree.true_centre_m = Eigen::Vector3d(x_m, 3.0, 0.0);
    return tree;
}

TEST(Lines, AreFittedToWhatWasFound) {
    std::vector<ObstacleMeasures> trees{tree_at(0.0, 0.0), tree_at(1.0, 10.0), tree_at(0.0, 20.0)};
    EXPECT_THAT(measure_lines(std::span(trees).first(2)), IsEmpty());
    const auto lines = measure_lines(trees);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].kind, ObstacleKind::tree);
    EXPECT_EQ(lines[0].members, 3U);
    EXPECT_NEAR(lines[0].line_error_m, 2.0 / 3.0, 1e-12); // the line is y = 1 / 3
    EXPECT_NEAR(lines[0].true_line_error_m, 0.0, 1e-12);
    trees[1].found = false;
    EXPECT_THAT(measure_lines(trees), IsEmpty());
}

} // namespace
} // namespace zonegrid::testing
