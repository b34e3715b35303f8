#include "reference/integrate_scan.h"

#include "model/rays.h"
#include "model/window.h"
#include "support/oracle_compare.h"
#include "support/oracle_scenes.h"
#include "support/statements.h"
#include "zonegrid/errors.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace zonegrid {
namespace {

using oracle::CellValues;
using oracle::Random;

constexpr float sky = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Cells and counts of one scan.
struct Integrated {
    CellValues cells;
    std::uint64_t rays = 0;
    std::uint64_t missing = 0;
    std::uint64_t dropped = 0;
};

Integrated by_library(const Scan& scan, const MapperOptions& options,
                      const Eigen::Isometry3d& world_from_sensor, const Window& window) {
    const ScanRays rays = quantize_scan(scan, world_from_sensor, options, window);
    LocalMap map(window);
    reference::integrate_scan(rays, map);
    return {statements_of(map), rays.rays.size(), rays.missing, rays.dropped};
}

Window placed_window(const MapperOptions& options, const Eigen::Isometry3d& world_from_sensor) {
    Window window = make_window(options, std::nullopt);
    window.move_to(cell_of(world_from_sensor.translation(), options.cell_m).value());
    return window;
}

/// A scanner in the middle of cell (0, 0, 0), cells of 1 m, range 4 m, axes as the world's.
struct Worked {
    MapperOptions options;
    Eigen::Isometry3d world_from_sensor = Eigen::Isometry3d::Identity();

    Worked() {
        options.range_m = 4.0;
        world_from_sensor.translation() = Eigen::Vector3d(0.5, 0.5, 0.5);
    }

    [[nodiscard]] Integrated operator()(const std::vector<Eigen::Vector3f>& ends,
                                        const std::vector<Eigen::Vector3f>& starts = {}) const {
        Scan scan;
        scan.ends_m = ends;
        scan.starts_m = starts;
        return by_library(scan, options, world_from_sensor,
                          placed_window(options, world_from_sensor));
    }
};

TEST(IntegrateScan, HitOccupiesItsCellAndFreesTheWay) {
    const auto scan = Worked{}({{3.0F, 0.0F, 0.0F}});
    EXPECT_EQ(scan.cells,
              (CellValues{{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{2, 0, 0}, 1}, {{3, 0, 0}, 2}}));
    EXPECT_EQ(scan.rays, 1U);
}

TEST(IntegrateScan, BeyondRangeFreesToTheRange) {
    const CellValues expected{
        {{0, 0, 0}, 1}, {{0, 0, -1}, 1}, {{0, 0, -2}, 1}, {{0, 0, -3}, 1}, {{0, 0, -4}, 1}};
    EXPECT_EQ(Worked{}({{0.0F, 0.0F, -4.001F}}).cells, expected);
    EXPECT_EQ(Worked{}({{0.0F, 0.0F, -1e30F}}).cells, expected);
    CellValues hit = expected;
    hit[{0, 0, -4}] = 2;
    EXPECT_EQ(Worked{}({{0.0F, 0.0F, -4.0F}}).cells, hit); // the range's end belongs to it
}

TEST(IntegrateScan, MissingSaysNothing) {
    const auto scan = Worked{}({{not_a_number, 0.0F, 0.0F}, {sky, 1.0F, 0.0F}, {0.0F, 0.0F, 0.0F}});
    EXPECT_TRUE(scan.cells.empty());
    EXPECT_EQ(scan.missing, 3U);
    EXPECT_EQ(scan.rays, 0U);
}

TEST(IntegrateScan, RaysWithOwnStartsOutsideTheWindowAreDropped) {
    const auto scan = Worked{}({{1.0F, 0.0F, 0.0F}, {100.0F, 1.0F, 0.0F}, {100.0F, 1.0F, 0.0F}},
                               {{0.0F, 1.0F, 0.0F}, {99.0F, 1.0F, 0.0F}, {1e30F, 1.0F, 0.0F}});
    // From 128 in its cell up in x (255 half sub-cells to the border) and down in y (257): x first.
    EXPECT_EQ(scan.cells, (CellValues{{{0, 1, 0}, 1}, {{1, 1, 0}, 1}, {{1, 0, 0}, 2}}));
    EXPECT_EQ(scan.dropped, 2U);
}

TEST(IntegrateScan, WindowEndsAtItsLastSubCell) {
    const Worked scan; // reach 6, three zones of 32 from cell -32: cells -32 .. 63
    EXPECT_EQ(scan({{63.499F, 0.0F, 0.0F}}, {{62.5F, 0.0F, 0.0F}}).rays, 1U);
    EXPECT_EQ(scan({{63.5F, 0.0F, 0.0F}}, {{62.5F, 0.0F, 0.0F}}).dropped, 1U);
    EXPECT_EQ(scan({{62.5F, 0.0F, 0.0F}}, {{63.5F, 0.0F, 0.0F}}).dropped, 1U);
    EXPECT_EQ(scan({{0.0F, 0.0F, -32.5F}}, {{0.0F, 0.0F, -31.5F}}).rays, 1U);
    EXPECT_EQ(scan({{0.0F, 0.0F, -32.501F}}, {{0.0F, 0.0F, -31.5F}}).dropped, 1U);
}

TEST(IntegrateScan, OccupiedBeatsFreeWhateverTheOrder) {
    const std::vector<Eigen::Vector3f> there{{1.0F, 0.0F, 0.0F}, {3.0F, 0.0F, 0.0F}};
    const std::vector<Eigen::Vector3f> back{there[1], there[0]};
    EXPECT_EQ(Worked{}(there).cells.at({1, 0, 0}), ZG_STATEMENT_OCCUPIED);
    EXPECT_EQ(Worked{}(there).cells, Worked{}(back).cells);
}

TEST(IntegrateScan, UnequalNumberOfStartsIsRefused) {
    EXPECT_THROW(Worked{}({{1.0F, 0.0F, 0.0F}}, {{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}}),
                 UsageError);
}

/// Points at all distances, some on cell borders, some no points at all.
std::vector<Eigen::Vector3f> random_points(Random& random, std::size_t count, double reach_m,
                                           double cell_m) {
    std::vector<Eigen::Vector3f> points;
    for (std::size_t n = 0; n < count; ++n) {
        const auto coordinate = [&]() -> float {
            if (random.chance(0.2)) {
                const auto most = static_cast<std::int64_t>(reach_m / cell_m);
                return static_cast<float>(static_cast<double>(random.whole(-most, most)) * cell_m);
            }
            if (random.chance(0.01)) {
                return random.chance(0.5) ? not_a_number : 1e37F;
            }
            return static_cast<float>(random.real(-reach_m, reach_m));
        };
        const float x_m = coordinate();
        const float y_m = coordinate();
        points.emplace_back(x_m, y_m, coordinate());
    }
    if (count > 0 && random.chance(0.2)) {
        points.front().setZero();
    }
    return points;
}

TEST(IntegrateScan, EqualsTheOracle) {
    constexpr std::uint64_t scans = 800;
    std::uint64_t compared = 0;
    Integrated sum;
    for (std::uint64_t seed = 1; seed <= scans; ++seed, ++compared) {
        Random random(seed);
        const MapperOptions options = oracle::random_options(random, 14.0);
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = oracle::random_attitude(random).toRotationMatrix();
        pose.translation() = oracle::random_position(random, options.cell_m, 3000.0);
        const auto count = static_cast<std::size_t>(random.pick(0, 60));
        const double reach_m = options.range_m * random.real(0.5, 1.5);
        const auto ends = random_points(random, count, reach_m, options.cell_m);
        const auto starts = random_points(random, count, reach_m, options.cell_m);
        Scan scan;
        scan.ends_m = ends;
        if (random.chance(0.5)) {
            scan.starts_m = starts;
        }
        const Window window = placed_window(options, pose);
        const CellIndex first = window.first_cell();
        const auto expected =
            oracle::scan_local_map(scan, options, oracle::pose_of(pose),
                                   {{first.x, first.y, first.z}, window.edge_cells()});
        const auto actual = by_library(scan, options, pose, window);
        ASSERT_EQ(oracle::difference(oracle::as_values(expected.cells), actual.cells, options.zone),
                  "")
            << "seed " << seed;
        ASSERT_EQ(actual.missing, expected.missing) << "seed " << seed;
        ASSERT_EQ(actual.dropped, expected.dropped) << "seed " << seed;
        ASSERT_EQ(actual.rays, count - expected.missing - expected.dropped) << "seed " << seed;
        sum.rays += actual.rays;
        sum.missing += actual.missing;
        sum.dropped += actual.dropped;
    }
    EXPECT_EQ(compared, scans);
    EXPECT_GT(sum.rays, 10000U);
    EXPECT_GT(sum.missing, 100U);
    EXPECT_GT(sum.dropped, 100U);
}

} // namespace
} // namespace zonegrid
