#include "evaluation/triangle_cells.h"

#include "support/oracle_random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace zonegrid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr CellBox everywhere{{-1000, -1000, -1000}, {1000, 1000, 1000}};

std::set<CellIndex> cells_of(const CellTriangle& triangle, const CellBox& box = everywhere) {
    std::set<CellIndex> cells;
    for_each_touched_cell(triangle, box, [&](const CellIndex& cell) {
        EXPECT_TRUE(cells.insert(cell).second) << "twice";
    });
    return cells;
}

TEST(TriangleCells, OfAPointAreThoseThatItLiesInOrOn) {
    const Eigen::Vector3d point(2.5, -0.5, 7.0);
    EXPECT_THAT(cells_of({point, point, point}),
                ElementsAre(CellIndex{2, -1, 6}, CellIndex{2, -1, 7}));
}

TEST(TriangleCells, AreTouchedByWhatComesWithinHalfASubCell) {
    for (const double z : {7.0019, 6.9981}) {
        const Eigen::Vector3d point(2.5, -0.5, z);
        EXPECT_EQ(cells_of({point, point, point}).size(), 2U) << z;
    }
    const Eigen::Vector3d above(2.5, -0.5, 6.998); // 1 / 512 = 0.00195
    EXPECT_THAT(cells_of({above, above, above}), ElementsAre(CellIndex{2, -1, 6}));
}

TEST(TriangleCells, OfAPlaneOnABorderLieOnBothSides) {
    const auto cells = cells_of({Eigen::Vector3d(0.5, 0.5, 0.0), {2.4, 0.5, 0.0}, {0.5, 2.4, 0.0}});
    // The hypotenuse, x + y = 2.9, passes (1, 1), but neither (2, 1) nor (1, 2), whose least
    // corners have the sum 3.
    for (const std::int32_t z : {-1, 0}) {
        for (const auto& [x, y] : {std::pair{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {2, 0}}) {
            EXPECT_TRUE(cells.contains({x, y, z})) << x << " " << y << " " << z;
        }
    }
    EXPECT_EQ(cells.size(), 12U);
}

TEST(TriangleCells, OfASlantAreOnlyThoseItPasses) {
    // The plane x + y + z = 1.6, of which the part with coordinates above 0.05: it cuts (0, 0, 0),
    // and passes (1, 1, 1), whose nearest corner has the sum 3, at a distance.
    const CellTriangle slant{
        Eigen::Vector3d(1.5, 0.05, 0.05), {0.05, 1.5, 0.05}, {0.05, 0.05, 1.5}};
    EXPECT_TRUE(touches_cube(slant, {0, 0, 0}, 1.0));
    EXPECT_TRUE(touches_cube(slant, {1, 0, 0}, 1.0));
    EXPECT_FALSE(touches_cube(slant, {1, 1, 0}, 1.0)); // sum 2 at its least corner
    EXPECT_FALSE(touches_cube(slant, {1, 1, 1}, 1.0));
    EXPECT_TRUE(touches_cube(slant, {0, 0, 0}, 8.0));
    EXPECT_THAT(cells_of(slant), ElementsAre(CellIndex{0, 0, 0}, CellIndex{0, 0, 1},
                                             CellIndex{0, 1, 0}, CellIndex{1, 0, 0}));
}

TEST(TriangleCells, StayInTheBox) {
    const CellTriangle floor{Eigen::Vector3d(-1e6, -1e6, 0.5), {1e6, -1e6, 0.5}, {0.0, 1e6, 0.5}};
    EXPECT_THAT(cells_of(floor, {{3, 4, -2}, {4, 4, 5}}),
                ElementsAre(CellIndex{3, 4, 0}, CellIndex{4, 4, 0}));
    EXPECT_THAT(cells_of(floor, {{3, 4, 1}, {4, 4, 5}}), IsEmpty());
}

/// What is left of a polygon on one side of a plane across an axis (Sutherland and Hodgman).
std::vector<Eigen::Vector3d> cut(const std::vector<Eigen::Vector3d>& polygon, int axis, double at,
                                 double sign) {
    std::vector<Eigen::Vector3d> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector3d& a = polygon[i];
        const Eigen::Vector3d& b = polygon[(i + 1) % polygon.size()];
        const double from = sign * (a[axis] - at);
        const double to = sign * (b[axis] - at);
        if (from >= 0.0) {
            left.push_back(a);
        }
        if ((from >= 0.0) != (to >= 0.0)) {
            left.emplace_back(a + (b - a) * (from / (from - to)));
        }
    }
    return left;
}

/// Whether anything is left of a triangle that is cut to a cube.
bool touches_by_cutting(const CellTriangle& triangle, const Eigen::Vector3d& low, double edge) {
    std::vector<Eigen::Vector3d> polygon(triangle.begin(), triangle.end());
    for (int axis = 0; axis < 3; ++axis) {
        polygon = cut(polygon, axis, low[axis], 1.0);
        polygon = cut(polygon, axis, low[axis] + edge, -1.0);
    }
    return !polygon.empty();
}

TEST(TriangleCells, EqualWhatIsLeftWhenTrianglesAreCut) {
    oracle::Random random(5);
    std::size_t touched = 0;
    std::size_t missed = 0;
    for (int n = 0; n < 300; ++n) {
        CellTriangle triangle;
        const double size = random.real(0.01, 5.0);
        const Eigen::Vector3d middle(random.real(-4.0, 4.0), random.real(-4.0, 4.0),
                                     random.real(-4.0, 4.0));
        for (auto& corner : triangle) {
            corner = middle + Eigen::Vector3d(random.real(-size, size), random.real(-size, size),
                                              random.real(-size, size));
        }
        std::set<CellIndex> expected;
        for (std::int32_t z = -10; z < 10; ++z) {
            for (std::int32_t y = -10; y < 10; ++y) {
                for (std::int32_t x = -10; x < 10; ++x) {
                    if (touches_by_cutting(triangle, Eigen::Vector3d(x, y, z).array() - touch_slack,
                                           1.0 + 2.0 * touch_slack)) {
                        expected.insert({x, y, z});
                        ++touched;
                    } else {
                        ++missed;
                    }
                }
            }
        }
        ASSERT_EQ(cells_of(triangle), expected) << "triangle " << n;
    }
    EXPECT_GT(touched, 5000U);
    EXPECT_GT(missed, 1000000U);
}

} // namespace
} // namespace zonegrid::testing
