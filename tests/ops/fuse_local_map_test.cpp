#include "reference/fuse_local_map.h"

#include "support/oracle_random.h"
#include "support/statements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

// docs/model.md, section 7.

namespace zonegrid {
namespace {

constexpr int edge = 8;

Window small_window() {
    Window window(edge, 3, 6);
    window.move_to({0, 0, 0});
    return window;
}

/// One cell, taken through a sequence of statements.
class OneCell {
public:
    explicit OneCell(const MapperOptions& options)
        : rule_(options), window_(small_window()), local_map_(window_), grid_(window_) {}

    FusionResult say(std::uint8_t statement) {
        local_map_.clear();
        say_in_zone(local_map_, place, index, statement);
        return reference::fuse_local_map(local_map_, view_, rule_, grid_);
    }
    [[nodiscard]] int value() const {
        const auto values = grid_.find(place);
        return values.empty() ? 0 : values[index];
    }
    void set(int value) { grid_.touch(place)[index] = static_cast<std::int8_t>(value); }
    void set_view(const View& view) { view_ = view; }

private:
    static constexpr std::uint32_t place = 13; // the middle zone
    static constexpr std::uint32_t index = 77; // cell (13, 9, 9) of the window
    FusionRule rule_;
    Window window_;
    LocalMap local_map_;
    Grid grid_;
    View view_;
};

TEST(FuseLocalMap, TruthTableOfTheDefaults) {
    // hit 2, miss 1, limit 4, threshold 2.
    struct Row {
        int before;
        std::uint8_t statement;
        int after;
        bool occupancy_changes;
    };
    const std::vector<Row> rows{
        {0, ZG_STATEMENT_NOTHING, 0, false},   {0, ZG_STATEMENT_FREE, -1, false},
        {0, ZG_STATEMENT_OCCUPIED, 2, true},   {1, ZG_STATEMENT_OCCUPIED, 3, true},
        {2, ZG_STATEMENT_FREE, 1, true},       {3, ZG_STATEMENT_FREE, 2, false},
        {2, ZG_STATEMENT_OCCUPIED, 4, false},  {3, ZG_STATEMENT_OCCUPIED, 4, false},
        {4, ZG_STATEMENT_OCCUPIED, 4, false},  {-3, ZG_STATEMENT_FREE, -4, false},
        {-4, ZG_STATEMENT_FREE, -4, false},    {-4, ZG_STATEMENT_OCCUPIED, -2, false},
        {-1, ZG_STATEMENT_OCCUPIED, 1, false}, {4, ZG_STATEMENT_NOTHING, 4, false},
        {-4, ZG_STATEMENT_NOTHING, -4, false},
    };
    for (const auto& row : rows) {
        OneCell cell{MapperOptions{}};
        cell.set(row.before);
        const auto result = cell.say(row.statement);
        EXPECT_EQ(cell.value(), row.after) << row.before << " and statement " << +row.statement;
        EXPECT_EQ(result.cells_changed, row.after != row.before ? 1U : 0U) << row.before;
        EXPECT_EQ(result.occupancy_changed.size(), row.occupancy_changes ? 1U : 0U) << row.before;
    }
}

/// From the middle of cell (2, 9, 9) along x, 45 degrees to all sides, up to 40 cells.
View wide_view() {
    View view;
    view.bounded = true;
    view.sides = {{{11585, 11585, 0}, {11585, -11585, 0}, {11585, 0, 11585}, {11585, 0, -11585}}};
    view.centre = {40, 152, 152};
    view.radius = 640;
    return view;
}

bool denies(const View& view) {
    OneCell cell{MapperOptions{}};
    cell.set_view(view);
    cell.set(4);
    cell.say(ZG_STATEMENT_FREE);
    return cell.value() == 3;
}

TEST(FuseLocalMap, DeniesAnObstacleOnlyIfItsWholeCellIsSeen) {
    ASSERT_TRUE(denies(wide_view()));

    // The farthest corner (14, 10, 10) is 184, 8 and 8 sixteenths away: 184.3.
    View view = wide_view();
    view.radius = 188;
    EXPECT_TRUE(denies(view));
    view.radius = 187;
    EXPECT_FALSE(denies(view));

    // Its nearest corner is 168 sixteenths ahead; the margin of 3 is 4.2 along an axis.
    const auto denied_from = [](std::int32_t y, std::int32_t z) {
        View moved = wide_view();
        moved.centre.y = y;
        moved.centre.z = z;
        return denies(moved);
    };
    EXPECT_TRUE(denied_from(144 + 163, 152)); // the corner at y = 144 is 163 to the left
    EXPECT_FALSE(denied_from(144 + 164, 152));
    EXPECT_TRUE(denied_from(160 - 163, 152)); // the corner at y = 160 is 163 to the right
    EXPECT_FALSE(denied_from(160 - 164, 152));
    EXPECT_TRUE(denied_from(152, 144 + 163));
    EXPECT_FALSE(denied_from(152, 144 + 164));
    EXPECT_TRUE(denied_from(152, 160 - 163));
    EXPECT_FALSE(denied_from(152, 160 - 164));
}

TEST(FuseLocalMap, TheBoundsThemselvesAreSeen) {
    // All of space with x above the centre's: the cell begins at x = 208.
    View view = wide_view();
    view.sides.fill({16384, 0, 0});
    view.centre.x = 208 - 3; // in front by just the margin
    EXPECT_TRUE(denies(view));
    view.centre.x = 208 - 2;
    EXPECT_FALSE(denies(view));

    // From here the farthest corner (224, 160, 160) is 32, 48 and 96 away, so 112.
    view.centre = {224 - 32, 160 - 48, 160 - 96};
    view.radius = 112 + 3;
    EXPECT_TRUE(denies(view));
    view.radius = 112 + 2;
    EXPECT_FALSE(denies(view));
}

TEST(FuseLocalMap, WhatIsNoObstacleIsFreedWhereItIsPartlySeen) {
    View view = wide_view();
    view.radius = 0;
    struct Row {
        int before;
        std::uint8_t statement;
        int after;
    };
    const std::vector<Row> rows{
        {4, ZG_STATEMENT_FREE, 4},     {2, ZG_STATEMENT_FREE, 2},      {1, ZG_STATEMENT_FREE, 0},
        {0, ZG_STATEMENT_FREE, -1},    {-4, ZG_STATEMENT_FREE, -4},    {2, ZG_STATEMENT_NOTHING, 2},
        {2, ZG_STATEMENT_OCCUPIED, 4}, {-1, ZG_STATEMENT_OCCUPIED, 1},
    };
    for (const auto& row : rows) {
        OneCell cell{MapperOptions{}};
        cell.set_view(view);
        cell.set(row.before);
        const auto result = cell.say(row.statement);
        EXPECT_EQ(cell.value(), row.after) << row.before << " and statement " << +row.statement;
        EXPECT_EQ(result.cells_changed, row.after != row.before ? 1U : 0U) << row.before;
    }
}

TEST(FuseLocalMap, WidestLimitsStayInEightBits) {
    MapperOptions options;
    options.limit = 127;
    options.hit = 127;
    options.miss = 127;
    options.threshold = 127;
    OneCell cell(options);
    for (const int expected : {127, 127}) {
        cell.say(ZG_STATEMENT_OCCUPIED);
        EXPECT_EQ(cell.value(), expected);
    }
    for (const int expected : {0, -127, -127}) {
        cell.say(ZG_STATEMENT_FREE);
        EXPECT_EQ(cell.value(), expected);
    }
}

TEST(FuseLocalMap, ForgetsAndAcceptsAfterAsManyImagesAsTheModelSays) {
    OneCell wrong_obstacle{MapperOptions{}};
    wrong_obstacle.set(4);
    int images = 0;
    for (; wrong_obstacle.value() >= 2; ++images) {
        wrong_obstacle.say(ZG_STATEMENT_FREE);
    }
    EXPECT_EQ(images, 3);

    OneCell new_obstacle{MapperOptions{}};
    new_obstacle.set(-4);
    for (images = 0; new_obstacle.value() < 2; ++images) {
        new_obstacle.say(ZG_STATEMENT_OCCUPIED);
    }
    EXPECT_EQ(images, 3);
}

TEST(FuseLocalMap, SaturationMakesTheOrderOfImagesMatter) {
    OneCell seen_first{MapperOptions{}};
    seen_first.set(4);
    seen_first.say(ZG_STATEMENT_OCCUPIED);
    seen_first.say(ZG_STATEMENT_FREE);
    EXPECT_EQ(seen_first.value(), 3);

    OneCell seen_last{MapperOptions{}};
    seen_last.set(4);
    seen_last.say(ZG_STATEMENT_FREE);
    seen_last.say(ZG_STATEMENT_OCCUPIED);
    EXPECT_EQ(seen_last.value(), 4);
}

TEST(FuseLocalMap, TouchesOnlyZonesOfTheLocalMap) {
    const Window window = small_window();
    LocalMap local_map(window);
    Grid grid(window);
    const FusionRule rule{MapperOptions{}};
    grid.touch(3)[5] = 4;
    say_in_zone(local_map, 7, 9, ZG_STATEMENT_FREE);
    const auto result = reference::fuse_local_map(local_map, {}, rule, grid);
    EXPECT_EQ(grid.held().size(), 2U);
    EXPECT_EQ(grid.find(3)[5], 4);
    EXPECT_EQ(grid.find(7)[9], -1);
    EXPECT_TRUE(grid.find(8).empty());
    EXPECT_EQ(result.cells_changed, 1U);
    EXPECT_TRUE(result.occupancy_changed.empty());
}

TEST(FuseLocalMap, OneCellLostAndOneWonStillIsAChangeOfOccupancy) {
    const Window window = small_window();
    LocalMap local_map(window);
    Grid grid(window);
    grid.touch(4)[0] = 2;
    say_in_zone(local_map, 4, 0, ZG_STATEMENT_FREE);
    say_in_zone(local_map, 4, 1, ZG_STATEMENT_OCCUPIED);
    const auto result = reference::fuse_local_map(local_map, {}, FusionRule{MapperOptions{}}, grid);
    EXPECT_EQ(result.occupancy_changed, std::vector<std::uint32_t>{4});
}

/// Values by (place, index), fused one cell at a time.
class PlainFusion {
public:
    explicit PlainFusion(const MapperOptions& options) : options_(options) {}

    /// Returns whether the value changed; notes the place if its occupancy did.
    bool say(std::uint32_t place, std::uint32_t index, std::uint8_t statement,
             std::set<std::uint32_t>& occupancy_changed) {
        int& value = values_[{place, index}];
        const int before = value;
        if (statement == ZG_STATEMENT_OCCUPIED) {
            value = std::min(value + options_.hit, options_.limit);
        } else if (statement == ZG_STATEMENT_FREE) {
            value = std::max(value - options_.miss, -options_.limit);
        }
        if ((before >= options_.threshold) != (value >= options_.threshold)) {
            occupancy_changed.insert(place);
        }
        return value != before;
    }
    [[nodiscard]] int value(std::uint32_t place, std::uint32_t index) const {
        const auto found = values_.find({place, index});
        return found == values_.end() ? 0 : found->second;
    }

private:
    MapperOptions options_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> values_;
};

MapperOptions random_rule(oracle::Random& random) {
    MapperOptions options;
    options.limit = random.chance(0.2) ? 127 : random.pick(1, 12);
    options.hit = random.pick(1, options.limit);
    options.miss = random.pick(1, options.limit);
    options.threshold = random.pick(1, options.limit);
    return options;
}

TEST(FuseLocalMap, EqualsACellByCellModelOverManyImages) {
    constexpr std::uint64_t seed = 31;
    oracle::Random random(seed);
    int images = 0;
    for (int run = 0; run < 20; ++run) {
        const MapperOptions options = random_rule(random);
        const Window window = small_window();
        LocalMap local_map(window);
        Grid grid(window);
        PlainFusion plain(options);
        for (int image = 0; image < 30; ++image, ++images) {
            local_map.clear();
            std::uint64_t changed = 0;
            std::set<std::uint32_t> places;
            std::set<std::uint32_t> occupancy_changed;
            for (int zone = 0; zone < 4; ++zone) {
                const auto place = static_cast<std::uint32_t>(random.pick(0, 26));
                if (!places.insert(place).second) {
                    continue;
                }
                for (std::uint32_t i = 0; i < grid.zone_cells(); ++i) {
                    const auto statement = static_cast<std::uint8_t>(random.pick(0, 2));
                    say_in_zone(local_map, place, i, statement);
                    changed += plain.say(place, i, statement, occupancy_changed) ? 1U : 0U;
                }
            }
            const auto result = reference::fuse_local_map(local_map, {}, FusionRule(options), grid);
            ASSERT_EQ(result.cells_changed, changed) << "seed " << seed << ", run " << run;
            ASSERT_EQ(std::set(result.occupancy_changed.begin(), result.occupancy_changed.end()),
                      occupancy_changed)
                << "seed " << seed << ", run " << run << ", image " << image;
            ASSERT_EQ(result.occupancy_changed.size(), occupancy_changed.size());
        }
        for (const auto place : grid.held()) {
            for (std::uint32_t i = 0; i < grid.zone_cells(); ++i) {
                ASSERT_EQ(grid.find(place)[i], plain.value(place, i))
                    << "seed " << seed << ", run " << run << ", place " << place << ", cell " << i;
            }
        }
    }
    EXPECT_EQ(images, 600);
}

} // namespace
} // namespace zonegrid
