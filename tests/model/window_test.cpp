#include "model/window.h"

#include "support/scenes.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <set>
#include <string>

// docs/model.md, section 6.

namespace zonegrid {
namespace {

using testing::HasSubstr;

MapperOptions options_with(double cell_m, double range_m, int zone) {
    MapperOptions options;
    options.cell_m = cell_m;
    options.range_m = range_m;
    options.zone = zone;
    return options;
}

TEST(Window, SizeOfAScannersWindow) {
    // reach 40 + 2, twice that 84 cells: 3 zones of 32, and two more.
    EXPECT_EQ(make_window(options_with(1.0, 40.0, 32), {}).zones_per_axis(), 5);
    EXPECT_EQ(make_window(options_with(1.0, 40.0, 32), {}).edge_cells(), 160);
    // reach 14 + 2: exactly one zone of 32 across, or four of 8.
    EXPECT_EQ(make_window(options_with(1.0, 14.0, 32), {}).zones_per_axis(), 3);
    EXPECT_EQ(make_window(options_with(1.0, 14.0, 8), {}).zones_per_axis(), 6);
    EXPECT_EQ(make_window(options_with(1.0, 15.0, 8), {}).zones_per_axis(), 7);
    // 2.9 cells of range count as 2.
    EXPECT_EQ(make_window(options_with(1.0, 2.9, 8), {}).zones_per_axis(), 3);
}

TEST(Window, ACamerasSubRaysReachFurther) {
    // fx = fy = 10: stretch 1.1, reach floor(15.4) + 2 = 17, 34 cells: 5 zones of 8, and two more.
    const auto options = options_with(1.0, 14.0, 8);
    EXPECT_EQ(make_window(options, scenes::forward_camera(4, 4, 10.0)).zones_per_axis(), 7);
    EXPECT_EQ(make_window(options, scenes::forward_camera(4, 4, 1000.0)).zones_per_axis(), 6);
}

TEST(Window, MovesAsWorkedByHand) {
    Window window = make_window(options_with(1.0, 40.0, 32), {}); // reach 42, 5 zones of 32
    EXPECT_FALSE(window.placed());
    EXPECT_FALSE(window.holds({0, 0, 0}));
    EXPECT_TRUE(window.move_to({0, 0, 0}));
    EXPECT_EQ(window.first_zone(), (ZoneIndex{-2, -2, -2})); // floor(-42 / 32)
    EXPECT_EQ(window.first_cell(), (CellIndex{-64, -64, -64}));
    // Zones -2 .. 2 hold cells up to 95: the sensor's reach ends there at x = 53.
    EXPECT_FALSE(window.move_to({53, 0, 0}));
    EXPECT_TRUE(window.move_to({54, 0, 0}));
    EXPECT_EQ(window.first_zone(), (ZoneIndex{-1, -2, -2}));
    // Zones from -1 hold cells from -32: back to x = 10 nothing moves, at 9 it does.
    EXPECT_FALSE(window.move_to({10, 0, 0}));
    EXPECT_TRUE(window.move_to({9, 0, 0}));
    EXPECT_EQ(window.first_zone(), (ZoneIndex{-2, -2, -2}));
    // A jump on all axes: down on y to floor((-1000 - 42) / 32) = -33, up on z to
    // floor((1000 + 42) / 32) - 4 = 28.
    EXPECT_TRUE(window.move_to({9, -1000, 1000}));
    EXPECT_EQ(window.first_zone(), (ZoneIndex{-2, -33, 28}));
}

TEST(Window, HoveringAtAZoneBorderMovesNothing) {
    Window window = make_window(options_with(0.25, 20.0, 16), {});
    window.move_to({0, 0, 0});
    int moves = 0;
    for (int n = 0; n < 100; ++n) {
        moves += window.move_to({n % 2 == 0 ? -1 : 0, n % 3, n % 2 == 0 ? 16 : 15}) ? 1 : 0;
    }
    EXPECT_LE(moves, 1);
}

struct Case {
    double cell_m;
    double range_m;
    int zone;
    double focal_px; ///< 0: a scanner
};

std::optional<Camera> camera_of(const Case& c) {
    return c.focal_px > 0.0 ? std::optional(scenes::forward_camera(8, 8, c.focal_px))
                            : std::nullopt;
}

/// Empty if such a window can be made, else why not.
std::string refusal(double cell_m, double range_m, const Case& c) {
    try {
        return make_window(options_with(cell_m, range_m, c.zone), camera_of(c)).placed() ? "?" : "";
    } catch (const CapacityError& error) {
        return error.what();
    }
}

TEST(Window, TooLargeANeedIsRefusedWithARemedyThatWorks) {
    int refused = 0;
    for (const Case& c :
         {Case{0.03, 40.0, 32, 0.0}, Case{0.01, 40.0, 8, 500.0}, Case{0.05, 60.0, 16, 30.0},
          Case{1.0, 5000.0, 32, 2.0}, Case{0.0333, 33.3, 32, 333.0}, Case{2.5, 1e7, 8, 0.0}}) {
        const std::string message = refusal(c.cell_m, c.range_m, c);
        std::smatch remedy;
        ASSERT_TRUE(std::regex_search(
            message, remedy,
            std::regex("use a cell of ([0-9.e+-]+) m or more, or a range of ([0-9.e+-]+) m")))
            << "cell " << c.cell_m << ", range " << c.range_m << ": " << message;
        EXPECT_THAT(message, HasSubstr("2048"));
        const double cell_m = std::stod(remedy[1]);
        const double range_m = std::stod(remedy[2]);
        EXPECT_GT(cell_m, c.cell_m);
        EXPECT_LT(range_m, c.range_m);
        EXPECT_EQ(refusal(cell_m, c.range_m, c), "") << message;
        EXPECT_EQ(refusal(c.cell_m, range_m, c), "") << message;
        // The remedy gives away next to nothing.
        EXPECT_NE(refusal(cell_m * 0.99, c.range_m, c), "") << message;
        EXPECT_NE(refusal(c.cell_m, range_m * 1.01, c), "") << message;
        ++refused;
    }
    EXPECT_EQ(refused, 6);
}

TEST(Window, LargestAllowedIsAllowed) {
    // 64 zones of 32: reach 62 * 32 / 2 = 992 cells, 990 of them range.
    const Case scanner{1.0, 990.0, 32, 0.0};
    EXPECT_EQ(make_window(options_with(1.0, 990.0, 32), {}).edge_cells(), 2048);
    EXPECT_THAT(refusal(1.0, 991.0, scanner), HasSubstr("a window of 2080 cells an axis"));
}

/// A scanner's window with a reach of 2 + `range` cells, moved to each of a list of cells.
struct Walk {
    int zone = 8;
    int range = 1;
    std::vector<CellIndex> sensor_cells;
};

Walk random_walk() {
    Walk walk;
    walk.zone = *rc::gen::element(8, 16, 32);
    walk.range = *rc::gen::inRange(1, 40);
    const int spread = *rc::gen::element(3, 40, 1000000);
    const auto coordinate = rc::gen::inRange<std::int32_t>(-spread, spread + 1);
    walk.sensor_cells =
        *rc::gen::nonEmpty(rc::gen::container<std::vector<CellIndex>>(rc::gen::build<CellIndex>(
            rc::gen::set(&CellIndex::x, coordinate), rc::gen::set(&CellIndex::y, coordinate),
            rc::gen::set(&CellIndex::z, coordinate))));
    return walk;
}

Window window_of(const Walk& walk) {
    return make_window(options_with(1.0, walk.range, walk.zone), {});
}

RC_GTEST_PROP(Window, AlwaysHoldsTheSensorsReach, ()) {
    const Walk walk = random_walk();
    Window window = window_of(walk);
    const int reach = walk.range + 2;
    for (const auto& cell : walk.sensor_cells) {
        window.move_to(cell);
        RC_ASSERT(
            window.holds(zone_of({cell.x - reach, cell.y - reach, cell.z - reach}, walk.zone)));
        RC_ASSERT(
            window.holds(zone_of({cell.x + reach, cell.y + reach, cell.z + reach}, walk.zone)));
    }
}

RC_GTEST_PROP(Window, MovesNoFurtherThanItMust, ()) {
    const Walk walk = random_walk();
    Window window = window_of(walk);
    window.move_to(walk.sensor_cells.front());
    const int reach = walk.range + 2;
    for (const auto& cell : walk.sensor_cells) {
        const ZoneIndex before = window.first_zone();
        const bool moved = window.move_to(cell);
        const ZoneIndex after = window.first_zone();
        RC_ASSERT(moved == (before != after));
        // Of all positions that hold the reach, the one nearest to the old.
        const auto nearest = [&](std::int32_t sensor, std::int32_t first) {
            const std::int32_t most = floor_div(sensor - reach, walk.zone);
            const std::int32_t least =
                floor_div(sensor + reach, walk.zone) - window.zones_per_axis() + 1;
            return std::clamp(first, least, most);
        };
        RC_ASSERT(after.x == nearest(cell.x, before.x));
        RC_ASSERT(after.y == nearest(cell.y, before.y));
        RC_ASSERT(after.z == nearest(cell.z, before.z));
    }
}

RC_GTEST_PROP(Window, PlacesOfZonesAreABijection, ()) {
    const Walk walk = random_walk();
    Window window = window_of(walk);
    window.move_to(walk.sensor_cells.front());
    std::set<ZoneIndex> zones;
    for (std::uint32_t place = 0; place < window.zone_count(); ++place) {
        const ZoneIndex zone = window.zone_at(place);
        RC_ASSERT(window.holds(zone));
        RC_ASSERT(window.place_of(zone) == place);
        zones.insert(zone);
    }
    RC_ASSERT(zones.size() == window.zone_count());
    const ZoneIndex first = window.first_zone();
    const std::int32_t zones_per_axis = window.zones_per_axis();
    RC_ASSERT(!window.holds({first.x - 1, first.y, first.z}));
    RC_ASSERT(!window.holds({first.x, first.y + zones_per_axis, first.z}));
    RC_ASSERT(!window.holds({first.x, first.y, first.z - 1}));
}

} // namespace
} // namespace zonegrid
