#include "model/zoned_cells.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

// Zones of docs/model.md, section 6: which cells live and which are dropped.

namespace zonegrid {
namespace {

constexpr int edge = 8;

Window window_at(const CellIndex& sensor_cell) {
    Window window(edge, 4, 8);
    window.move_to(sensor_cell);
    return window;
}

TEST(ZonedCells, NothingIsHeldBeforeItIsTouched) {
    Grid grid(window_at({0, 0, 0}));
    EXPECT_TRUE(grid.held().empty());
    EXPECT_TRUE(grid.find(5).empty());
    EXPECT_TRUE(grid.held().empty());
    EXPECT_EQ(grid.touch(5).size(), 512U);
    EXPECT_EQ(grid.find(5).size(), 512U);
    EXPECT_EQ(grid.held().size(), 1U);
    grid.touch(5)[3] = 9;
    EXPECT_EQ(grid.held().size(), 1U);
    EXPECT_EQ(grid.find(5)[3], 9);
}

TEST(ZonedCells, MemoryUsedAgainStartsAtZero) {
    Grid grid(window_at({0, 0, 0}));
    std::ranges::fill(grid.touch(1), std::int8_t{7});
    grid.clear();
    EXPECT_TRUE(grid.held().empty());
    EXPECT_TRUE(grid.find(1).empty());
    EXPECT_EQ(std::ranges::count(grid.touch(2), 0), 512);

    std::ranges::fill(grid.touch(2), std::int8_t{7});
    const ZoneIndex left = grid.window().zone_at(2);
    grid.move_to(window_at({1000, 0, 0}), [&](const ZoneIndex& zone, auto cells) {
        EXPECT_EQ(zone, left);
        EXPECT_EQ(std::ranges::count(cells, 7), 512);
    });
    EXPECT_TRUE(grid.held().empty());
    EXPECT_EQ(std::ranges::count(grid.touch(0), 0), 512);
}

TEST(ZonedCells, ACellKeepsItsValueWhereTheWindowMovesUnderIt) {
    Grid grid(window_at({0, 0, 0}));
    const CellIndex cell{3, -2, 7};
    const ZoneIndex zone = zone_of(cell, edge);
    grid.touch(grid.window().place_of(zone))[index_in_zone(cell, edge)] = 4;
    int left = 0;
    grid.move_to(window_at({14, 5, -3}), [&](const ZoneIndex&, auto) { ++left; });
    EXPECT_EQ(left, 0);
    EXPECT_EQ(grid.find(grid.window().place_of(zone))[index_in_zone(cell, edge)], 4);
}

/// All cells of a grid with a value other than 0.
std::map<CellIndex, int> values_in(const Grid& grid) {
    std::map<CellIndex, int> values;
    for (const auto place : grid.held()) {
        const auto cells = grid.find(place);
        for (std::uint32_t i = 0; i < cells.size(); ++i) {
            if (cells[i] != 0) {
                values.emplace(cell_at(grid.window().zone_at(place), i, edge), cells[i]);
            }
        }
    }
    return values;
}

/// Takes the cells of zones outside `window` out of `values`.
std::map<CellIndex, int> take_outside(std::map<CellIndex, int>& values, const Window& window) {
    std::map<CellIndex, int> outside;
    for (auto cell = values.begin(); cell != values.end();) {
        const auto next = std::next(cell);
        if (!window.holds(zone_of(cell->first, edge))) {
            outside.insert(values.extract(cell));
        }
        cell = next;
    }
    return outside;
}

rc::Gen<CellIndex> cells_within(std::int32_t low, std::int32_t end) {
    const auto coordinate = rc::gen::inRange<std::int32_t>(low, end);
    return rc::gen::build<CellIndex>(rc::gen::set(&CellIndex::x, coordinate),
                                     rc::gen::set(&CellIndex::y, coordinate),
                                     rc::gen::set(&CellIndex::z, coordinate));
}

RC_GTEST_PROP(ZonedCells, EqualAMapOfCellsOverRandomMovesAndWrites, ()) {
    Window window(edge, 4, 8);
    window.move_to({0, 0, 0});
    Grid grid(window);
    std::map<CellIndex, int> model;
    const int actions = *rc::gen::inRange(1, 40);
    for (int action = 0; action < actions; ++action) {
        const int kind = *rc::gen::weightedElement<int>({{8, 0}, {6, 1}, {1, 2}});
        if (kind == 0) { // write a cell of the window
            const CellIndex offset = *cells_within(0, window.edge_cells());
            const CellIndex first = window.first_cell();
            const CellIndex cell{first.x + offset.x, first.y + offset.y, first.z + offset.z};
            const int value = *rc::gen::inRange(1, 9);
            grid.touch(window.place_of(zone_of(cell, edge)))[index_in_zone(cell, edge)] =
                static_cast<std::int8_t>(value);
            model[cell] = value;
        } else if (kind == 1) {
            window.move_to(*cells_within(-30, 31));
            std::map<CellIndex, int> left;
            grid.move_to(window, [&](const ZoneIndex& zone, std::span<const std::int8_t> cells) {
                RC_ASSERT(!window.holds(zone));
                for (std::uint32_t i = 0; i < cells.size(); ++i) {
                    if (cells[i] != 0) {
                        left.emplace(cell_at(zone, i, edge), cells[i]);
                    }
                }
            });
            RC_ASSERT(left == take_outside(model, window));
        } else {
            grid.clear();
            model.clear();
        }
        RC_ASSERT(values_in(grid) == model);
    }
}

} // namespace
} // namespace zonegrid
