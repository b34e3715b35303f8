#include "evaluation/gap_measures.h"

#include "evaluation/small_truth.h"

#include <gtest/gtest.h>

namespace zonegrid::testing {
namespace {

/// Three masts from 1.8 m over the world's origin to 2.2 m under it, 3.4 m apart from west to east.
Truth row_of_masts(float north_of_the_last_m) {
    Truth truth;
    truth.camera = north_camera();
    const auto add_mast = [&truth](const std::string& name, float north_m, float east_m) {
        add_box(truth.surfaces, {north_m, east_m, -1.8F}, {north_m + 0.6F, east_m + 0.6F, 2.2F});
        end_obstacle(truth.surfaces, name, ObstacleKind::mast);
    };
    add_mast("west", 6.2F, -3.8F);
    add_mast("middle", 6.2F, 0.2F);
    add_mast("east", north_of_the_last_m, 4.2F);
    truth.images.push_back(looking_north(10.0, {0.5, 0.5, 0.5}));
    return truth;
}

CellSet masts() {
    CellSet cells = cells_of_box({6, -4, -2}, {6, -4, 2});
    cells.insert_all(cells_of_box({6, 0, -2}, {6, 0, 2}));
    cells.insert_all(cells_of_box({6, 4, -2}, {6, 4, 2}));
    return cells;
}

// Between the ends -3.2 and 0.2 m there are 7 places, in the cells -3, -3, -2, -2, -2, -1, -1; at
// each 2 across, in cell 6, and 4 up from -0.2 to 1.8 m, in the cells z = -1, -1, -2, -2.
TEST(Gaps, AreClearAndFreeAsFarAsTheMapSays) {
    const Truth truth = row_of_masts(6.2F);
    CellSet occupied = masts();
    occupied.insert({6, -2, -1});
    const CellSet free = without(cells_of_box({6, -3, -2}, {6, -1, -1}), occupied);
    const Evaluation marks = evaluate(map_of(truth, occupied, free), truth);
    ASSERT_EQ(marks.lines.size(), 1U);
    ASSERT_EQ(marks.lines[0].gaps.size(), 2U);
    const auto& barred = marks.lines[0].gaps[0];
    EXPECT_EQ(barred.before, "west");
    EXPECT_EQ(barred.after, "middle");
    EXPECT_NEAR(barred.true_m, 3.4, 1e-5);
    EXPECT_EQ(barred.occupied.of, 56U);
    EXPECT_EQ(barred.occupied.count, 3U * 2U * 2U);
    EXPECT_EQ(barred.free.count, 56U - 12U);
    EXPECT_NEAR(barred.clear_m, 3.4 * 2.0 / 7.0, 1e-5);
    const auto& unknown = marks.lines[0].gaps[1];
    EXPECT_EQ(unknown.after, "east");
    EXPECT_EQ(unknown.free.count, 0U);
    EXPECT_EQ(unknown.occupied.count, 0U);
    EXPECT_NEAR(unknown.clear_m, 3.4, 1e-5);
}

TEST(Gaps, AreOnlyInRows) {
    // The last mast stands 5 m farther north: the line is off by more than a metre from one of
    // them.
    const Truth truth = row_of_masts(11.2F);
    CellSet occupied = masts();
    occupied.insert_all(cells_of_box({11, 4, -2}, {11, 4, 2}));
    const Evaluation marks = evaluate(map_of(truth, occupied, {}), truth);
    ASSERT_EQ(marks.lines.size(), 1U);
    EXPECT_TRUE(marks.lines[0].gaps.empty());
}

} // namespace
} // namespace zonegrid::testing
