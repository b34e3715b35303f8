#include "reference/draw_objects.h"

#include "model/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// docs/model.md, section 6: zones that enter.

namespace zonegrid {
namespace {

MapperOptions rule(int threshold, int limit) {
    MapperOptions options;
    options.threshold = threshold;
    options.limit = limit;
    options.hit = 1;
    options.miss = 1;
    return options;
}

TEST(DrawObjects, ValueIsHalfWayFromThresholdToLimitRoundedUp) {
    EXPECT_EQ(FusionRule(rule(2, 8)).drawn(), 5);
    EXPECT_EQ(FusionRule(rule(3, 8)).drawn(), 6);
    EXPECT_EQ(FusionRule(rule(1, 1)).drawn(), 1);
    EXPECT_EQ(FusionRule(rule(127, 127)).drawn(), 127);
    EXPECT_EQ(FusionRule(rule(1, 127)).drawn(), 64);
}

TEST(DrawObjects, ValueIsOccupiedAndWithinTheLimitForEveryRule) {
    for (int limit = 1; limit <= 127; ++limit) {
        for (int threshold = 1; threshold <= limit; ++threshold) {
            const int drawn = FusionRule(rule(threshold, limit)).drawn();
            ASSERT_GE(drawn, threshold);
            ASSERT_LE(drawn, limit);
        }
    }
}

TEST(DrawObjects, DrawsTheCellsAndNothingElse) {
    // Zone (-1, 0, 1) of edge 8 covers x -8 .. -1, y 0 .. 7, z 8 .. 15; order [z][y][x].
    const std::vector<CellIndex> cells{{-8, 0, 8}, {-1, 0, 8}, {-8, 1, 8}, {-8, 0, 9}, {-1, 7, 15}};
    std::vector<std::int8_t> values(512);
    reference::draw_objects(cells, FusionRule(rule(2, 8)), 8, values);
    std::vector<std::int8_t> expected(512);
    for (const std::size_t index : {0U, 7U, 8U, 64U, 511U}) {
        expected[index] = 5;
    }
    EXPECT_EQ(values, expected);
}

TEST(DrawObjects, NoCellsChangeNothing) {
    std::vector<std::int8_t> values(512, -3);
    reference::draw_objects({}, FusionRule(rule(2, 8)), 8, values);
    EXPECT_EQ(std::ranges::count(values, -3), 512);
}

} // namespace
} // namespace zonegrid
