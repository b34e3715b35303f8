#include "evaluation/evaluation.h"

#include "evaluation/evaluation_json.h"
#include "evaluation/evaluation_text.h"
#include "evaluation/small_truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Maps that deserve bad marks get them. All numbers are worked by hand from the truth of
// small_truth.h; cells compare at Chebyshev distances 0, 1 and 2.

namespace zonegrid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr CellIndex low{-5, -10, -10};
constexpr CellIndex high{14, 9, 9};
constexpr std::uint64_t all_cells = 8000;

MATCHER_P2(IsShare, count, of, "") {
    *result_listener << arg.count << " of " << arg.of;
    return arg.count == static_cast<std::uint64_t>(count) &&
           arg.of == static_cast<std::uint64_t>(of);
}

/// The wall but for what the box hides, and the box's front.
CellSet visible_surface() {
    CellSet cells =
        without(cells_of_box({10, -5, -5}, {10, 5, 5}), cells_of_box({10, -2, -2}, {10, 2, 2}));
    cells.insert_all(cells_of_box({5, -1, -1}, {5, 1, 1}));
    return cells;
}

/// What a perfect sensor sees free, from a view that another test checks.
CellSet visible_free(const Truth& truth) {
    const TouchedCells touched = touch_cells(truth.surfaces, 1.0, {{-50, -50, -50}, {50, 50, 50}});
    return look_around(truth, touched, draw_every_triangle(truth),
                       {1.0, 20.0, 0, truth.images.size(), 1}, [](std::size_t) {})
        .free;
}

TEST(Evaluation, GivesAPerfectMapPerfectMarks) {
    const Truth truth = wall_and_box();
    const Evaluation marks = evaluate(map_of(truth, visible_surface(), visible_free(truth)), truth);
    const CellMeasures& cells = marks.cells;
    EXPECT_THAT(cells.precision,
                ElementsAre(IsShare(105, 105), IsShare(105, 105), IsShare(105, 105)));
    EXPECT_THAT(cells.recall, ElementsAre(IsShare(105, 105), IsShare(105, 105), IsShare(105, 105)));
    EXPECT_THAT(cells.wrong_free_surface, IsShare(0, 105));
    EXPECT_EQ(cells.wrong_free_solid.count, 0U);
    EXPECT_EQ(cells.wrong_occupied_free.count, 0U);
    EXPECT_EQ(cells.unknown_free.count, 0U);
    EXPECT_GT(cells.unknown_free.of, 1000U);
    EXPECT_THAT(cells.unknown_surface, IsShare(0, 105));
    ASSERT_EQ(marks.obstacles.size(), 2U);
    for (const auto& obstacle : marks.obstacles) {
        EXPECT_TRUE(obstacle.found) << obstacle.name;
        EXPECT_EQ(obstacle.objects, 1U) << obstacle.name;
        EXPECT_THAT(obstacle.merged_with, IsEmpty());
        EXPECT_FALSE(obstacle.joined_with_ground);
        EXPECT_NEAR(*obstacle.horizontal_error_m, 0.0, 1e-12);
        EXPECT_NEAR(*obstacle.vertical_error_m, 0.0, 1e-12);
        EXPECT_NEAR(*obstacle.size_error_m, 0.0, 1e-12);
    }
    EXPECT_THAT(marks.obstacles[0].found_cells, IsShare(96, 96));
    EXPECT_THAT(marks.obstacles[1].found_cells, IsShare(9, 9));
    EXPECT_EQ(*marks.obstacles[1].true_size_m, Eigen::Vector3d(1, 3, 3));
}

TEST(Evaluation, GivesAnEmptyMapNoRecallAndAllUnknown) {
    const Truth truth = wall_and_box();
    const Evaluation marks = evaluate(map_of(truth, {}, {}), truth);
    const CellMeasures& cells = marks.cells;
    EXPECT_THAT(cells.precision, ElementsAre(IsShare(0, 0), IsShare(0, 0), IsShare(0, 0)));
    EXPECT_EQ(cells.precision[0].value(), std::nullopt);
    EXPECT_THAT(cells.recall, ElementsAre(IsShare(0, 105), IsShare(0, 105), IsShare(0, 105)));
    EXPECT_THAT(cells.unknown_surface, IsShare(105, 105));
    EXPECT_EQ(cells.unknown_free.count, cells.unknown_free.of);
    EXPECT_GT(cells.unknown_free.of, 1000U);
    for (const auto& obstacle : marks.obstacles) {
        EXPECT_FALSE(obstacle.found);
        EXPECT_EQ(obstacle.found_cells.count, 0U);
        EXPECT_FALSE(obstacle.detection.has_value());
        EXPECT_FALSE(obstacle.centre_m.has_value());
    }
}

TEST(Evaluation, GivesAMapShiftedByTwoCellsWhatItDeserves) {
    const Truth truth = wall_and_box();
    const CellIndex step{0, 2, 0};
    const Evaluation marks = evaluate(
        map_of(truth, shifted(visible_surface(), step), shifted(visible_free(truth), step)), truth);
    const CellMeasures& cells = marks.cells;
    // Wall: of 96 cells those with y up to 3, 4, 5 stay within 0, 1, 2 of it: 74, 85, 96. Box: with
    // y = -1; 0; 1 likewise, each 3 cells.
    EXPECT_THAT(cells.precision,
                ElementsAre(IsShare(77, 105), IsShare(91, 105), IsShare(105, 105)));
    // Wall, distance 0: (y - 2, z) must be visible. Six rows (z) beyond the shadow: y = -3 .. 5, 54
    // cells; five through it: y = -3 and 5, 10 cells. Box: y = 1, 3 cells.
    EXPECT_THAT(cells.recall[0], IsShare(67, 105));
    EXPECT_LT(cells.recall[1].count, 105U);
    // Rays pass beside the wall, through (10, -7 .. -6, z), and beside the box, (5, -3 .. -2, z):
    // shifted, these free cells lie on 2 x 11 visible cells of the wall and 2 x 3 of the box.
    EXPECT_THAT(cells.wrong_free_surface, IsShare(28, 105));
    EXPECT_GT(cells.wrong_occupied_free.count, 0U);
    // The box's own cells are those within one cell of it: y = 1 and 2, so half a metre less.
    ASSERT_EQ(marks.obstacles.size(), 2U);
    EXPECT_NEAR(*marks.obstacles[1].horizontal_error_m, 1.5, 1e-12);
    EXPECT_NEAR(*marks.obstacles[1].size_error_m, 1.0, 1e-12);
    // Cells with an own one within 1: y = 0 and 1 of 3.
    EXPECT_THAT(marks.obstacles[1].found_cells, IsShare(6, 9));
}

TEST(Evaluation, GivesAMapOfObstaclesOnlyNoPrecision) {
    const Truth truth = wall_and_box();
    const Evaluation marks = evaluate(map_of(truth, cells_of_box(low, high), {}), truth);
    const CellMeasures& cells = marks.cells;
    // Within 1: wall 3 x 13 x 13, box 6 x 5 x 5, both 1 x 5 x 5; within 2: 5 x 15 x 15, 8 x 7 x 7
    // and 3 x 7 x 7.
    EXPECT_THAT(cells.precision,
                ElementsAre(IsShare(155, all_cells), IsShare(507 + 150 - 25, all_cells),
                            IsShare(1125 + 392 - 147, all_cells)));
    EXPECT_THAT(cells.recall[0], IsShare(105, 105));
    EXPECT_GT(cells.wrong_occupied_free.value().value_or(0.0), 0.3);
    EXPECT_THAT(cells.wrong_free_solid, IsShare(0, 0));
    ASSERT_EQ(marks.obstacles.size(), 2U);
    EXPECT_THAT(marks.obstacles[0].merged_with, ElementsAre("box"));
    EXPECT_THAT(marks.obstacles[1].merged_with, ElementsAre("wall"));
    EXPECT_TRUE(marks.obstacles[0].merged());
}

TEST(Evaluation, GivesAFreeMapEveryWrongFreeCell) {
    const Truth truth = wall_and_box();
    const Evaluation marks = evaluate(map_of(truth, {}, cells_of_box(low, high)), truth);
    const CellMeasures& cells = marks.cells;
    EXPECT_THAT(cells.wrong_free_surface, IsShare(105, 105));
    EXPECT_THAT(cells.wrong_free_solid, IsShare(2, all_cells)); // the inside of the box
    EXPECT_THAT(cells.recall[2], IsShare(0, 105));
    EXPECT_EQ(cells.precision[2].value(), std::nullopt);
    EXPECT_THAT(cells.unknown_surface, IsShare(0, 105));
    EXPECT_FALSE(marks.obstacles[0].found);
    EXPECT_FALSE(marks.obstacles[1].found);
}

TEST(Evaluation, TakesEitherCellForASurfaceOnTheirBorder) {
    Truth truth;
    truth.camera = north_camera();
    truth.images.push_back(looking_north(0.0, {0.5, 0.5, 0.5}));
    add_rectangle(truth.surfaces, {Eigen::Vector3f(10.0F, -4.4F, -4.4F),
                                   {10.0F, 5.4F, -4.4F},
                                   {10.0F, 5.4F, 5.4F},
                                   {10.0F, -4.4F, 5.4F}});
    end_obstacle(truth.surfaces, "wall", ObstacleKind::building);
    // A wall of 121 cells, on either side of its plane; the lesser half of y before, the rest
    // beyond.
    CellSet occupied = cells_of_box({9, -5, -5}, {9, -1, 5});
    occupied.insert_all(cells_of_box({10, 0, -5}, {10, 5, 5}));
    const Evaluation marks =
        evaluate(map_of(truth, occupied, cells_of_box({9, 0, -5}, {9, 5, 5})), truth);
    EXPECT_THAT(marks.cells.precision[0], IsShare(121, 121));
    EXPECT_THAT(marks.cells.recall[0], IsShare(121, 121));
    EXPECT_THAT(marks.cells.unknown_surface, IsShare(0, 121));
    EXPECT_THAT(marks.cells.wrong_free_surface, IsShare(0, 121));
    const Evaluation none =
        evaluate(map_of(truth, {}, cells_of_box({9, -5, -5}, {9, 5, 5})), truth);
    EXPECT_THAT(none.cells.recall[2], IsShare(0, 121));
    EXPECT_THAT(none.cells.wrong_free_surface, IsShare(0, 121)); // what is beyond is unknown
    EXPECT_THAT(none.cells.unknown_surface, IsShare(0, 121));
    const Evaluation free =
        evaluate(map_of(truth, {}, cells_of_box({9, -5, -5}, {10, 5, 5})), truth);
    EXPECT_THAT(free.cells.wrong_free_surface, IsShare(121, 121));
}

TEST(Evaluation, CountsOnlyTheLastWindowWithoutAHistory) {
    const Truth truth = wall_and_box();
    JudgedMap map = map_of(truth, visible_surface(), {});
    map.has_history = false;
    map.window = {{5, -1, -1}, {5, 1, 0}};
    for (auto& cell : map.occupied_cells) {
        cell.since_image = CellStamp::never;
    }
    map.ever_occupied.clear();
    const Evaluation marks = evaluate(map, truth);
    EXPECT_THAT(marks.cells.recall[0], IsShare(105, 105));
    EXPECT_THAT(marks.cells.unknown_surface, IsShare(0, 6));
    EXPECT_THAT(marks.cells.wrong_free_surface, IsShare(0, 6));
    EXPECT_FALSE(marks.obstacles[0].detection.has_value());
    EXPECT_THAT(text_of(marks), HasSubstr("zonegrid map --history"));
    EXPECT_EQ(json_of(marks)["map"]["history"], false);
    EXPECT_TRUE(json_of(marks)["obstacles"]["each"][0]["detection"].is_null());
}

} // namespace
} // namespace zonegrid::testing
