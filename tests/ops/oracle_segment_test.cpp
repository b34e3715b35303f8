#include "support/oracle_segment.h"
#include "model/segment_walk.h"
#include "support/oracle_random.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <vector>

// The walk that every backend copies, against cells found by exact intersection.

namespace zonegrid {
namespace {

using oracle::Random;

constexpr std::int32_t last_sub = (1 << 19) - 1;

oracle::SubCell wide(const SubPoint& point) {
    return {point.x, point.y, point.z};
}

std::vector<CellIndex> walked(const SubPoint& start, const SubPoint& end) {
    std::vector<CellIndex> cells;
    for_each_cell(start, end, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
        cells.push_back({x, y, z});
    });
    return cells;
}

SubPoint point(Random& random, std::int32_t low, std::int32_t high) {
    return {random.pick(low, high), random.pick(low, high), random.pick(low, high)};
}

std::string describe(const SubPoint& start, const SubPoint& end) {
    const auto text = [](const SubPoint& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); };
    return text(start) + " to " + text(end);
}

/// Both lists in order; says where they part.
testing::AssertionResult same_cells(const SubPoint& start, const SubPoint& end) {
    const auto expected = oracle::segment_cells(wide(start), wide(end));
    const auto actual = walked(start, end);
    if (expected == actual) {
        return testing::AssertionSuccess();
    }
    const auto [e, a] = std::ranges::mismatch(expected, actual);
    auto failure = testing::AssertionFailure();
    failure << describe(start, end) << ": " << expected.size() << " cells expected, "
            << actual.size() << " walked, first difference at step " << (e - expected.begin());
    if (e != expected.end() && a != actual.end()) {
        failure << ": expected (" << e->x << ", " << e->y << ", " << e->z << "), is (" << a->x
                << ", " << a->y << ", " << a->z << ")";
    }
    return failure;
}

struct Family {
    const char* name;
    int segments;
    std::function<void(Random&, SubPoint&, SubPoint&)> make;
};

std::int32_t clamp_sub(std::int32_t value) {
    return std::clamp(value, 0, last_sub);
}

/// A coordinate on one side or the other of a cell's border.
std::int32_t at_border(Random& random, int cells) {
    return 256 * random.pick(1, cells) - random.pick(0, 1);
}

/// Moves by the same distance on some axes, in either direction, and from the mirrored place in its
/// cell where it moves down: all these axes meet all their borders together.
void make_diagonal(Random& random, SubPoint& start, SubPoint& end) {
    const std::int32_t within = random.pick(0, 255);
    const std::int32_t length = random.chance(0.5) ? 256 * random.pick(1, 8) : random.pick(1, 2048);
    const auto make_axis = [&](std::int32_t& from, std::int32_t& to) {
        const int direction = random.pick(-1, 1);
        from = 256 * random.pick(8, 16) + (direction < 0 ? 255 - within : within);
        to = from + direction * length;
    };
    make_axis(start.x, end.x);
    make_axis(start.y, end.y);
    make_axis(start.z, end.z);
}

/// Through an exact corner: the corner is the middle of the segment. In half sub-cells a centre is
/// odd and a border even, so start + end = 2 * corner has a solution.
void make_corner(Random& random, SubPoint& start, SubPoint& end) {
    start = point(random, 0, 12 * 256);
    const auto mirror = [&](std::int32_t sub) {
        const std::int32_t corner = 256 * (sub / 256 + random.pick(0, 6));
        return clamp_sub(2 * corner - 1 - sub);
    };
    end = {mirror(start.x), mirror(start.y), mirror(start.z)};
    if (random.chance(0.3)) {
        end.z = clamp_sub(start.z + random.pick(-300, 300)); // through an edge only
    }
}

std::vector<Family> families() {
    return {
        {"anywhere near", 4000,
         [](Random& random, SubPoint& start, SubPoint& end) {
             start = point(random, 0, 2600);
             end = point(random, 0, 2600);
         }},
        {"within a few cells", 3000,
         [](Random& random, SubPoint& start, SubPoint& end) {
             start = point(random, 0, 700);
             end = point(random, 0, 700);
         }},
        {"along one axis or none", 1000,
         [](Random& random, SubPoint& start, SubPoint& end) {
             start = point(random, 0, 5000);
             end = start;
             (random.chance(0.5) ? end.x : (random.chance(0.5) ? end.y : end.z)) =
                 random.pick(0, 5000);
             if (random.chance(0.1)) {
                 end = start;
             }
         }},
        {"in a plane", 1500,
         [](Random& random, SubPoint& start, SubPoint& end) {
             start = point(random, 0, 3000);
             end = point(random, 0, 3000);
             const int still = random.pick(0, 2);
             (still == 0 ? end.x : (still == 1 ? end.y : end.z)) =
                 still == 0 ? start.x : (still == 1 ? start.y : start.z);
         }},
        {"from border to border", 2000,
         [](Random& random, SubPoint& start, SubPoint& end) {
             start = {at_border(random, 8), at_border(random, 8), at_border(random, 8)};
             end = {at_border(random, 8), at_border(random, 8), at_border(random, 8)};
         }},
        {"diagonal", 2000, make_diagonal},
        {"through a corner or edge", 2000, make_corner},
        {"long and thin", 400,
         [](Random& random, SubPoint& start, SubPoint& end) {
             start = point(random, 0, 700);
             end = point(random, 0, 700);
             const int axis = random.pick(0, 2);
             (axis == 0 ? end.x : (axis == 1 ? end.y : end.z)) = random.pick(60000, last_sub);
             if (random.chance(0.5)) {
                 std::swap(start, end);
             }
         }},
    };
}

TEST(OracleSegment, WalkPassesTheCellsOfTheExactSegmentInOrder) {
    constexpr std::uint64_t seed = 20240611;
    RecordProperty("seed", std::to_string(seed));
    Random random(seed);
    int segments = 0;
    for (const Family& family : families()) {
        for (int n = 0; n < family.segments; ++n, ++segments) {
            SubPoint start;
            SubPoint end;
            family.make(random, start, end);
            ASSERT_TRUE(same_cells(start, end))
                << "seed " << seed << ", " << family.name << ", segment " << n;
        }
    }
    EXPECT_EQ(segments, 15900);
}

/// The oracle against itself: the cells it lists are those of the whole bounding box, and one more
/// layer around it, for which it answers yes.
TEST(OracleSegment, ListedCellsAreTheCrossedOnesOfTheBox) {
    Random random(3);
    int segments = 0;
    for (const Family& family : families()) {
        for (int n = 0; n < 250; ++n) {
            SubPoint start;
            SubPoint end;
            family.make(random, start, end);
            const CellIndex a = oracle::cell_of(wide(start));
            const CellIndex b = oracle::cell_of(wide(end));
            if (std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) > 20) {
                continue;
            }
            auto listed = oracle::segment_cells(wide(start), wide(end));
            std::ranges::sort(listed);
            std::vector<CellIndex> crossed;
            for (int x = std::min(a.x, b.x) - 1; x <= std::max(a.x, b.x) + 1; ++x) {
                for (int y = std::min(a.y, b.y) - 1; y <= std::max(a.y, b.y) + 1; ++y) {
                    for (int z = std::min(a.z, b.z) - 1; z <= std::max(a.z, b.z) + 1; ++z) {
                        if (oracle::crossed(wide(start), wide(end), {x, y, z})) {
                            crossed.push_back({x, y, z});
                        }
                    }
                }
            }
            ASSERT_EQ(listed, crossed) << family.name << ", segment " << n;
            ++segments;
        }
    }
    EXPECT_GT(segments, 1600);
}

TEST(OracleSegment, FamiliesHoldManyTies) {
    Random random(7);
    int with_tie = 0;
    for (int n = 0; n < 1000; ++n) {
        SubPoint start;
        SubPoint end;
        make_corner(random, start, end);
        // A tie taken the other way round gives other cells: mirror the axes' order.
        const auto cells = oracle::segment_cells(wide(start), wide(end));
        const auto turned =
            oracle::segment_cells({start.z, start.y, start.x}, {end.z, end.y, end.x});
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (cells[i] != CellIndex{turned[i].z, turned[i].y, turned[i].x}) {
                ++with_tie;
                break;
            }
        }
    }
    EXPECT_GT(with_tie, 500);
}

TEST(OracleSegment, WorkedByHand) {
    using Cells = std::vector<CellIndex>;
    // Centre of cell to centre of the diagonal neighbour, all borders at once: z, then y, then x.
    EXPECT_EQ(walked({127, 127, 127}, {384, 384, 384}),
              (Cells{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}}));
    EXPECT_EQ(walked({384, 384, 384}, {127, 127, 127}),
              (Cells{{1, 1, 1}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}));
    // Last sub-cell of a cell to the first of the next.
    EXPECT_EQ(walked({255, 10, 10}, {256, 10, 10}), (Cells{{0, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(walked({256, 10, 10}, {255, 10, 10}), (Cells{{1, 0, 0}, {0, 0, 0}}));
    // No length.
    EXPECT_EQ(walked({256, 511, 1000}, {256, 511, 1000}), (Cells{{1, 1, 3}}));
    // x reaches its border after 1/2 sub-cell of 100, y after 9/2 of 300: x at 0.005, y at 0.015.
    EXPECT_EQ(walked({255, 251, 0}, {355, 551, 0}),
              (Cells{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}}));
}

/// Count, steps, ends, and `crossed` for every cell on the way and all its neighbours.
void check_long(const SubPoint& start, const SubPoint& end, Random& random, double share) {
    const auto cells = walked(start, end);
    const auto away = [](std::int32_t a, std::int32_t b) { return std::abs((a >> 8) - (b >> 8)); };
    ASSERT_EQ(cells.size(), static_cast<std::size_t>(1 + away(start.x, end.x) +
                                                     away(start.y, end.y) + away(start.z, end.z)))
        << describe(start, end);
    ASSERT_EQ(cells.front(), oracle::cell_of(wide(start)));
    ASSERT_EQ(cells.back(), oracle::cell_of(wide(end))) << describe(start, end);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!random.chance(share)) {
            continue;
        }
        const CellIndex c = cells[i];
        ASSERT_TRUE(oracle::crossed(wide(start), wide(end), c))
            << describe(start, end) << ": spurious cell " << c.x << ' ' << c.y << ' ' << c.z;
        // A cell on the way is at most 3 steps from any crossed cell that touches it.
        const auto near = std::vector<CellIndex>(
            cells.begin() + static_cast<std::ptrdiff_t>(i < 3 ? 0 : i - 3),
            cells.begin() + static_cast<std::ptrdiff_t>(std::min(i + 4, cells.size())));
        for (int n = 0; n < 27; ++n) {
            const CellIndex beside{c.x + n % 3 - 1, c.y + n / 3 % 3 - 1, c.z + n / 9 - 1};
            ASSERT_EQ(oracle::crossed(wide(start), wide(end), beside),
                      std::ranges::find(near, beside) != near.end())
                << describe(start, end) << ": beside step " << i << " of " << cells.size()
                << ", cell " << beside.x << ' ' << beside.y << ' ' << beside.z;
        }
    }
}

TEST(OracleSegment, LongestSegmentsStayExact) {
    constexpr std::uint64_t seed = 5;
    Random random(seed);
    const std::vector<std::int32_t> ends{0,       1, 254, 255, 256, last_sub - 256, last_sub - 1,
                                         last_sub};
    const auto corner = [&] {
        const auto any = [&] {
            return ends[static_cast<std::size_t>(
                random.pick(0, static_cast<int>(ends.size()) - 1))];
        };
        return SubPoint{any(), any(), any()};
    };
    int segments = 0;
    for (int n = 0; n < 500; ++n, ++segments) {
        ASSERT_NO_FATAL_FAILURE(check_long(corner(), corner(), random, 0.03)) << "seed " << seed;
    }
    for (int n = 0; n < 500; ++n, ++segments) {
        ASSERT_NO_FATAL_FAILURE(
            check_long(point(random, 0, last_sub), point(random, 0, last_sub), random, 0.03))
            << "seed " << seed;
    }
    EXPECT_EQ(segments, 1000);
    // The longest of all, both ways, every cell.
    check_long({0, 0, 0}, {last_sub, last_sub, last_sub}, random, 1.0);
    check_long({last_sub, 0, last_sub}, {0, last_sub, 1}, random, 1.0);
    check_long({0, last_sub, last_sub - 1}, {last_sub, 0, 0}, random, 1.0);
}

TEST(OracleSegment, WindowRelativeOriginChangesNothing) {
    Random random(11);
    for (int n = 0; n < 300; ++n) {
        const SubPoint start = point(random, 0, 2000);
        const SubPoint end = point(random, 0, 2000);
        const CellIndex by{random.pick(-40, 40), random.pick(-40, 40), random.pick(-40, 40)};
        const auto moved = [&](const SubPoint& p) {
            return oracle::SubCell{p.x + 256 * by.x, p.y + 256 * by.y, p.z + 256 * by.z};
        };
        auto cells = walked(start, end);
        for (CellIndex& cell : cells) {
            cell = {cell.x + by.x, cell.y + by.y, cell.z + by.z};
        }
        ASSERT_EQ(cells, oracle::segment_cells(moved(start), moved(end))) << "segment " << n;
    }
}

} // namespace
} // namespace zonegrid
