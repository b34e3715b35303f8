#include "model/segment_walk.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

// docs/model.md, section 4. Exact agreement with the geometry is in tests/ops/oracle_segment_test.

namespace zonegrid {
namespace {

using Cells = std::vector<CellIndex>;

Cells cells_of(const SubPoint& start, const SubPoint& end) {
    Cells cells;
    for_each_cell(start, end, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
        cells.push_back({x, y, z});
    });
    return cells;
}

TEST(SegmentWalk, NoLengthIsOneCell) {
    EXPECT_EQ(cells_of({700, 3, 256}, {700, 3, 256}), (Cells{{2, 0, 1}}));
}

TEST(SegmentWalk, WithinOneCell) {
    EXPECT_EQ(cells_of({0, 0, 0}, {255, 255, 255}), (Cells{{0, 0, 0}}));
    EXPECT_EQ(cells_of({511, 256, 300}, {256, 511, 257}), (Cells{{1, 1, 1}}));
}

TEST(SegmentWalk, AlongEachAxisBothWays) {
    EXPECT_EQ(cells_of({128, 10, 10}, {700, 10, 10}), (Cells{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
    EXPECT_EQ(cells_of({10, 700, 10}, {10, 128, 10}), (Cells{{0, 2, 0}, {0, 1, 0}, {0, 0, 0}}));
    EXPECT_EQ(cells_of({10, 10, 255}, {10, 10, 256}), (Cells{{0, 0, 0}, {0, 0, 1}}));
    EXPECT_EQ(cells_of({10, 10, 256}, {10, 10, 255}), (Cells{{0, 0, 1}, {0, 0, 0}}));
}

TEST(SegmentWalk, ExactDiagonalTakesZBeforeYBeforeX) {
    EXPECT_EQ(cells_of({0, 0, 0}, {512, 512, 512}),
              (Cells{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 1, 2}, {1, 2, 2}, {2, 2, 2}}));
    EXPECT_EQ(cells_of({128, 128, 9}, {384, 384, 9}), (Cells{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    EXPECT_EQ(cells_of({128, 9, 128}, {384, 9, 384}), (Cells{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}}));
    EXPECT_EQ(cells_of({9, 128, 128}, {9, 384, 384}), (Cells{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}}));
}

TEST(SegmentWalk, TheReverseOfADiagonalTakesTheSameAxisFirst) {
    // Not the same cells: a tie goes to z whichever way the ray runs.
    EXPECT_EQ(cells_of({384, 384, 9}, {128, 128, 9}), (Cells{{1, 1, 0}, {1, 0, 0}, {0, 0, 0}}));
}

TEST(SegmentWalk, BordersCountFromTheCentreOfTheSubCell) {
    // From 254 to 256 and from 255 to 257 is 2 sub-cells each. x starts 1.5 sub-cells before its
    // border, y half a sub-cell: y first, although both end beyond theirs.
    EXPECT_EQ(cells_of({254, 255, 0}, {256, 257, 0}), (Cells{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    // Downwards: x is half a sub-cell from the border below it, y 1.5.
    EXPECT_EQ(cells_of({256, 257, 0}, {254, 255, 0}), (Cells{{1, 1, 0}, {0, 1, 0}, {0, 0, 0}}));
}

TEST(SegmentWalk, SlopeOneToTwoByHand) {
    // x from 0 to 600, y from 0 to 300: borders of x (distance 255.5, 511.5) at 0.4258 and 0.8525;
    // of y (255.5) at 0.8517: just before the second of x.
    EXPECT_EQ(cells_of({0, 0, 0}, {600, 300, 0}),
              (Cells{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}));
}

rc::Gen<SubPoint> points(std::int32_t end_sub) {
    const auto coordinate = rc::gen::inRange<std::int32_t>(0, end_sub);
    return rc::gen::build<SubPoint>(rc::gen::set(&SubPoint::x, coordinate),
                                    rc::gen::set(&SubPoint::y, coordinate),
                                    rc::gen::set(&SubPoint::z, coordinate));
}

std::array<std::int32_t, 3> coordinates(const SubPoint& point) {
    return {point.x, point.y, point.z};
}

/// Distances to the borders an axis crosses, in half sub-cells.
std::vector<std::int64_t> borders(std::int32_t start, std::int32_t end) {
    const std::int64_t within = start & 255;
    const std::int64_t first = end > start ? 511 - 2 * within : 2 * within + 1;
    std::vector<std::int64_t> distances;
    for (int k = 0; k < std::abs((end >> 8) - (start >> 8)); ++k) {
        distances.push_back(first + 512 * k);
    }
    return distances;
}

/// Whether two axes cross a border at the same moment.
bool has_tie(const SubPoint& start, const SubPoint& end) {
    const auto from = coordinates(start);
    const auto to = coordinates(end);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i + 1; j < 3; ++j) {
            const std::int64_t speed_i = std::abs(to[i] - from[i]);
            const std::int64_t speed_j = std::abs(to[j] - from[j]);
            for (const auto border_i : borders(from[i], to[i])) {
                for (const auto border_j : borders(from[j], to[j])) {
                    if (border_i * speed_j == border_j * speed_i) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

void check_steps(const SubPoint& start, const SubPoint& end) {
    const Cells cells = cells_of(start, end);
    const CellIndex first{start.x >> 8, start.y >> 8, start.z >> 8};
    const CellIndex last{end.x >> 8, end.y >> 8, end.z >> 8};
    RC_ASSERT(cells.front() == first);
    RC_ASSERT(cells.back() == last);
    RC_ASSERT(cells.size() ==
              static_cast<std::size_t>(std::abs(last.x - first.x) + std::abs(last.y - first.y) +
                                       std::abs(last.z - first.z) + 1));
    for (std::size_t i = 1; i < cells.size(); ++i) {
        RC_ASSERT(std::abs(cells[i].x - cells[i - 1].x) + std::abs(cells[i].y - cells[i - 1].y) +
                      std::abs(cells[i].z - cells[i - 1].z) ==
                  1);
    }
}

RC_GTEST_PROP(SegmentWalk, UnitStepsFromTheFirstCellToTheLast, ()) {
    check_steps(*points(6 * 256), *points(6 * 256));
}

RC_GTEST_PROP(SegmentWalk, UnitStepsOverTheWidestWindow, ()) {
    check_steps(*points(1 << 19), *points(1 << 19));
}

RC_GTEST_PROP(SegmentWalk, NeverLeavesTheTubeAroundTheSegment, ()) {
    // Every cell's centre is within half a cell's diagonal of the straight segment.
    const SubPoint start = *points(20 * 256);
    const SubPoint end = *points(20 * 256);
    const auto from = coordinates(start);
    const auto to = coordinates(end);
    for (const auto& cell : cells_of(start, end)) {
        const std::array<double, 3> centre{256.0 * cell.x + 127.5, 256.0 * cell.y + 127.5,
                                           256.0 * cell.z + 127.5};
        double along = 0.0;
        double length_2 = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            along += (centre[i] - from[i]) * (to[i] - from[i]);
            length_2 += double{1} * (to[i] - from[i]) * (to[i] - from[i]);
        }
        const double t = length_2 > 0.0 ? std::clamp(along / length_2, 0.0, 1.0) : 0.0;
        double distance_2 = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double off = centre[i] - (from[i] + t * (to[i] - from[i]));
            distance_2 += off * off;
        }
        RC_ASSERT(distance_2 <= 3.0 * 128.0 * 128.0 + 1e-6);
    }
}

RC_GTEST_PROP(SegmentWalk, TheReverseWalkPassesTheSameCellsUnlessThereIsATie, ()) {
    const SubPoint start = *points(8 * 256);
    const SubPoint end = *points(8 * 256);
    RC_PRE(!has_tie(start, end));
    Cells back = cells_of(end, start);
    std::ranges::reverse(back);
    RC_ASSERT(back == cells_of(start, end));
}

} // namespace
} // namespace zonegrid
