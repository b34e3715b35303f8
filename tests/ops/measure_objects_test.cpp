#include "reference/measure_objects.h"

#include "support/oracle_random.h"
#include "support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

// docs/model.md, sections 8.2 and 8.3.

namespace zonegrid {
namespace {

TEST(MeasureObjects, OneCell) {
    const std::vector<CellIndex> cells{{-3, 5, -7}};
    const Object object = reference::measure_object(cells);
    EXPECT_EQ(object.id, cells[0]);
    EXPECT_EQ(object.cell_count, 1U);
    EXPECT_EQ(object.box_min, cells[0]);
    EXPECT_EQ(object.box_max, cells[0]);
    EXPECT_EQ(object.cell_sum, (std::array<std::int64_t, 3>{-3, 5, -7}));
    EXPECT_TRUE(object.centre_m(0.5).isApprox(Eigen::Vector3d(-1.25, 2.75, -3.25)));
}

TEST(MeasureObjects, IdentifierIsTheLeastByXThenYThenZ) {
    // The least on z alone, and on y alone, are other cells.
    const std::vector<CellIndex> cells{{1, -9, -9}, {0, 4, 2}, {0, 3, 8}, {0, 3, 7}, {2, 0, -20}};
    const Object object = reference::measure_object(cells);
    EXPECT_EQ(object.id, (CellIndex{0, 3, 7}));
    EXPECT_EQ(object.box_min, (CellIndex{0, -9, -20}));
    EXPECT_EQ(object.box_max, (CellIndex{2, 4, 8}));
    EXPECT_EQ(object.cell_sum, (std::array<std::int64_t, 3>{3, 1, -12}));
}

TEST(MeasureObjects, CentreOfABoxAcrossTheOrigin) {
    const auto cells = scenes::box_of_cells({-2, -1, 0}, {1, 0, 2}); // 4 x 2 x 3 cells
    const Object object = reference::measure_object(cells);
    EXPECT_EQ(object.cell_count, 24U);
    // Its faces are at x -2 .. 2, y -1 .. 1, z 0 .. 3 cells.
    EXPECT_TRUE(object.centre_m(2.0).isApprox(Eigen::Vector3d(0.0, 0.0, 3.0)));
}

TEST(MeasureObjects, SumsAreExactFarFromTheOrigin) {
    constexpr std::int32_t far = 1 << 30;
    const auto cells = scenes::box_of_cells({far - 20, -far, far - 20}, {far - 1, -far + 19, far});
    const Object object = reference::measure_object(cells);
    std::int64_t sum_x = 0;
    for (const auto& cell : cells) {
        sum_x += std::int64_t{cell.x};
    }
    EXPECT_GT(sum_x, std::int64_t{1} << 42);
    EXPECT_EQ(object.cell_sum[0], sum_x);
}

TEST(MeasureObjects, TheOrderOfTheCellsDoesNotMatter) {
    constexpr std::uint64_t seed = 9;
    oracle::Random random(seed);
    for (int run = 0; run < 200; ++run) {
        std::set<CellIndex> sorted;
        for (int n = random.pick(1, 60); n > 0; --n) {
            sorted.insert({random.pick(-20, 20), random.pick(-20, 20), random.pick(-20, 20)});
        }
        std::vector<CellIndex> cells(sorted.begin(), sorted.end());
        const Object straight = reference::measure_object(cells);
        ASSERT_EQ(straight.id, *sorted.begin()) << "seed " << seed << ", run " << run;
        for (std::size_t i = cells.size() - 1; i > 0; --i) {
            std::swap(
                cells[i],
                cells[static_cast<std::size_t>(random.whole(0, static_cast<std::int64_t>(i)))]);
        }
        ASSERT_EQ(reference::measure_object(cells), straight) << "seed " << seed << ", run " << run;
    }
}

} // namespace
} // namespace zonegrid
