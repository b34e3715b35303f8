#include "io/profile_picture_range.h"

#include "io/colour_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace zonegrid {
namespace {

using testing::HasSubstr;

TEST(ProfilePictureRange, IsNotSpoiltByAFewWildHeights) {
    HeightProfile profile{0.5, {}};
    for (int x = 0; x < 100; ++x) {
        for (int y = 0; y < 100; ++y) {
            profile.columns.push_back({x, y, -(x % 20)}); // 0 to 9.5 m
        }
    }
    const GroundPlan plan = ground_plan(profile, {});
    const HeightRanges before = height_ranges(profile, plan);
    EXPECT_DOUBLE_EQ(before.colour.low_m, 0.0);
    EXPECT_DOUBLE_EQ(before.colour.high_m, 9.5);
    EXPECT_EQ(clipping_note(before.colour), "");
    EXPECT_EQ(clipping_note(before.drawn), "");

    profile.columns[50].z = -4000;
    profile.columns[5050].z = 3000;
    const HeightRanges after = height_ranges(profile, plan);
    EXPECT_DOUBLE_EQ(after.colour.low_m, 0.0);
    EXPECT_DOUBLE_EQ(after.colour.high_m, 9.5);
    EXPECT_TRUE(after.colour.some_below && after.colour.some_above);
    EXPECT_EQ(clipping_note(after.colour), "heights outside 0.0..9.5 m clipped");
    EXPECT_DOUBLE_EQ(after.drawn.low_m, 0.0);
    EXPECT_LT(after.drawn.high_m, 20.0);
    EXPECT_THAT(clipping_note(after.drawn), HasSubstr("clipped"));
}

TEST(ProfilePictureRange, NamesTheOneHeightOfLevelGroundWithAHole) {
    HeightProfile profile{1.0, {}};
    for (int x = 0; x < 100; ++x) {
        for (int y = 0; y < 10; ++y) {
            profile.columns.push_back({x, y, -1});
        }
    }
    profile.columns[500].z = 0;
    const HeightRanges ranges = height_ranges(profile, ground_plan(profile, {}));
    EXPECT_DOUBLE_EQ(ranges.drawn.low_m, ranges.drawn.high_m);
    EXPECT_EQ(clipping_note(ranges.drawn), "heights outside 1.00..1.00 m clipped");
}

TEST(ProfilePictureRange, KeepsAMastOnAFlatField) {
    HeightProfile profile{0.5, {}};
    for (int x = 0; x < 100; ++x) {
        for (int y = 0; y < 100; ++y) {
            profile.columns.push_back({x, y, 0});
        }
    }
    profile.columns[5050].z = -8; // 4 m
    const HeightRanges ranges = height_ranges(profile, ground_plan(profile, {}));
    EXPECT_DOUBLE_EQ(ranges.drawn.high_m, 4.0);
    EXPECT_FALSE(ranges.drawn.some_above);
    EXPECT_DOUBLE_EQ(ranges.colour.low_m, 0.0);
    EXPECT_TRUE(ranges.colour.some_above);
}

TEST(ProfilePictureRange, StepsAndNumbersAreRound) {
    EXPECT_DOUBLE_EQ(round_step(100.0, 10), 10.0);
    EXPECT_DOUBLE_EQ(round_step(101.0, 10), 20.0);
    EXPECT_DOUBLE_EQ(round_step(0.26, 10), 0.05);
    EXPECT_DOUBLE_EQ(round_step(7.0, 1), 10.0);
    EXPECT_EQ(number_text(-12.0, 2.0), "\u221212");
    EXPECT_EQ(number_text(-1e-12, 0.5), "0.0");
    EXPECT_EQ(number_text(0.25, 0.05), "0.25");
}

TEST(ColourMap, RunsFromBlueOverGreenToRed) {
    const Rgb low = height_colour(0.0);
    const Rgb middle = height_colour(0.5);
    const Rgb high = height_colour(1.0);
    EXPECT_GT(low.b, std::max(low.r, low.g));
    EXPECT_GT(middle.g, std::max(middle.r, middle.b));
    EXPECT_GT(high.r, std::max(high.g, high.b));
    EXPECT_EQ(height_colour(-3.0), low);
    EXPECT_EQ(height_colour(7.0), high);
    EXPECT_EQ(height_colour(std::numeric_limits<double>::quiet_NaN()), low);
    EXPECT_EQ(shade(middle, 1.0), middle);
    EXPECT_EQ(shade(middle, 0.0), (Rgb{0, 0, 0}));
    EXPECT_EQ(shade(middle, 2.0), (Rgb{255, 255, 255}));
}

} // namespace
} // namespace zonegrid
