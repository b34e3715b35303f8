#include "evaluation/solid_cells.h"

#include "evaluation/small_truth.h"
#include "support/oracle_random.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace zonegrid::testing {
namespace {

std::uint64_t count_in(const SolidCells& solid, const CellBox& box) {
    std::uint64_t count = 0;
    cells_of_box(box.low, box.high).for_each([&](const CellIndex& cell) {
        count += solid.contains(cell) ? 1U : 0U;
    });
    return count;
}

/// The faces of a box of cells.
CellSet hull(const CellIndex& low, const CellIndex& high) {
    return without(cells_of_box(low, high), cells_of_box({low.x + 1, low.y + 1, low.z + 1},
                                                         {high.x - 1, high.y - 1, high.z - 1}));
}

TEST(SolidCells, AreTheInsideOfAHull) {
    const CellBox region{{-50, -50, -50}, {50, 50, 50}};
    // Through the borders of zones, which are 32 cells wide.
    const CellSet touched = hull({-10, 25, -5}, {10, 40, 5});
    const SolidCells solid(touched, region, {});
    EXPECT_EQ(count_in(solid, region), 19U * 14U * 9U);
    EXPECT_TRUE(solid.contains({-9, 26, -4}));
    EXPECT_FALSE(solid.contains({-10, 26, -4})); // the hull
    EXPECT_FALSE(solid.contains({-11, 26, -4}));
}

TEST(SolidCells, AreNoneWhereAHullHasAHole) {
    const CellBox region{{-50, -50, -50}, {50, 50, 50}};
    const CellSet touched =
        without(hull({-10, 25, -5}, {10, 40, 5}), cells_of_box({0, 30, 5}, {0, 30, 5}));
    EXPECT_EQ(count_in(SolidCells(touched, region, {}), region), 0U);
}

TEST(SolidCells, LieUnderGroundUpToTheRegionsSides) {
    const CellBox region{{0, 0, -10}, {39, 39, 9}};
    const CellSet touched = cells_of_box({-5, -5, 2}, {45, 45, 2});
    EXPECT_EQ(count_in(SolidCells(touched, region, {}), region), 40U * 40U * 7U);
}

TEST(SolidCells, AreNoneWhereSomethingOpenIs) {
    const CellBox region{{0, 0, -10}, {39, 39, 9}};
    // A tunnel under ground, 3 x 3 cells wide, in which a camera was.
    const CellSet ground = cells_of_box({-5, -5, 2}, {45, 45, 2});
    CellSet touched = hull({4, 10, 4}, {34, 14, 8});
    touched.insert_all(ground);
    const std::vector<CellIndex> camera{{20, 12, 6}};
    const SolidCells solid(touched, region, camera);
    EXPECT_FALSE(solid.contains({5, 11, 5}));
    EXPECT_TRUE(solid.contains({5, 9, 5}));
    EXPECT_TRUE(SolidCells(touched, region, {}).contains({5, 11, 5}));
}

/// Cells not reached, by flooding cell by cell.
std::set<CellIndex> solid_by_cells(const CellSet& touched, const CellBox& region) {
    std::set<CellIndex> left;
    cells_of_box(region.low, region.high).for_each([&](const CellIndex& cell) {
        if (!touched.contains(cell)) {
            left.insert(cell);
        }
    });
    std::vector<CellIndex> waiting;
    for (const auto& cell : left) {
        if (cell.z == region.low.z) {
            waiting.push_back(cell);
        }
    }
    while (!waiting.empty()) {
        const CellIndex cell = waiting.back();
        waiting.pop_back();
        if (left.erase(cell) == 0) {
            continue;
        }
        for (const int step : {-1, 1}) {
            waiting.push_back({cell.x + step, cell.y, cell.z});
            waiting.push_back({cell.x, cell.y + step, cell.z});
            waiting.push_back({cell.x, cell.y, cell.z + step});
        }
    }
    return left;
}

TEST(SolidCells, EqualAFloodOfSingleCells) {
    std::size_t seen = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        oracle::Random random(seed);
        const CellBox region{{random.pick(-40, -30), random.pick(-5, 5), random.pick(-40, -30)},
                             {random.pick(10, 20), random.pick(30, 40), random.pick(0, 10)}};
        CellSet touched;
        const double share = random.real(0.6, 0.72); // about where paths begin to end
        cells_of_box(region.low, region.high).for_each([&](const CellIndex& cell) {
            if (random.chance(share)) {
                touched.insert(cell);
            }
        });
        const SolidCells solid(touched, region, {});
        const auto expected = solid_by_cells(touched, region);
        seen += expected.size();
        std::set<CellIndex> actual;
        cells_of_box(region.low, region.high).for_each([&](const CellIndex& cell) {
            if (solid.contains(cell)) {
                actual.insert(cell);
            }
        });
        ASSERT_EQ(actual, expected) << "seed " << seed;
    }
    EXPECT_GT(seen, 1000U);
}

} // namespace
} // namespace zonegrid::testing
