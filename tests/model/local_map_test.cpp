#include "model/local_map.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

// Statements of one image, by zones of any edge.

namespace zonegrid {
namespace {

/// Five zones an axis: at 8, 16 and 32 cells a zone the window ends in the middle of a brick.
Window window_of(std::int32_t zone_edge, const CellIndex& sensor_cell) {
    Window window(zone_edge, 5, 1);
    window.move_to(sensor_cell);
    return window;
}

std::vector<std::uint8_t> zone_statements(const LocalMap& local_map, std::uint32_t place) {
    const auto edge = static_cast<std::size_t>(local_map.window().zone_edge());
    std::vector<std::uint8_t> statements(edge * edge * edge, 77);
    local_map.copy_zone(place, statements);
    return statements;
}

TEST(LocalMap, SaysNothingAtFirst) {
    const LocalMap local_map(window_of(32, {0, 0, 0}));
    EXPECT_TRUE(local_map.zones().empty());
    EXPECT_EQ(std::ranges::count(zone_statements(local_map, 124), ZG_STATEMENT_NOTHING), 32768);
}

TEST(LocalMap, TouchingSaysNothing) {
    LocalMap local_map(window_of(8, {0, 0, 0}));
    local_map.touch(0);
    EXPECT_TRUE(local_map.zones().empty());
}

TEST(LocalMap, FollowsTheWindowWithoutItsStatements) {
    LocalMap local_map(window_of(16, {0, 0, 0}));
    local_map.set({79, 0, 40}, ZG_STATEMENT_FREE);
    ASSERT_EQ(local_map.zones(), std::vector<std::uint32_t>{54});
    const Window moved = window_of(16, {1000, -1000, 500});
    local_map.move_to(moved);
    EXPECT_EQ(local_map.window().first_cell(), moved.first_cell());
    EXPECT_TRUE(local_map.zones().empty());
    local_map.touch(0);
    EXPECT_TRUE(local_map.zones().empty()) << "a brick used again still holds old statements";
}

RC_GTEST_PROP(LocalMap, KeepsEveryStatementInItsZone, ()) {
    const std::int32_t edge = 8 << *rc::gen::inRange(0, 3);
    LocalMap local_map(window_of(edge, {*rc::gen::inRange(-500, 500), 3, -70}));
    const auto cell = rc::gen::inRange(0, 5 * edge);
    const auto count = *rc::gen::inRange(0, 60);
    for (int image = 0; image < 2; ++image) {
        local_map.clear();
        std::map<std::uint32_t, std::map<std::size_t, std::uint8_t>> said; // by place, by index
        for (int i = 0; i < count; ++i) {
            const CellIndex at{*cell, *cell, *cell};
            const auto statement = static_cast<std::uint8_t>(*rc::gen::inRange(1, 3));
            local_map.set(at, statement);
            const auto place = (at.z / edge * 5 + at.y / edge) * 5 + at.x / edge;
            const auto index = (at.z % edge * edge + at.y % edge) * edge + at.x % edge;
            said[static_cast<std::uint32_t>(place)][static_cast<std::size_t>(index)] = statement;
        }
        const auto zones = local_map.zones();
        RC_ASSERT(std::ranges::is_sorted(zones));
        RC_ASSERT(zones.size() == said.size());
        for (const auto& [place, cells] : said) {
            RC_ASSERT(std::ranges::binary_search(zones, place));
            const auto statements = zone_statements(local_map, place);
            for (std::size_t i = 0; i < statements.size(); ++i) {
                const auto found = cells.find(i);
                RC_ASSERT(statements[i] == (found == cells.end() ? 0 : found->second));
            }
        }
    }
}

} // namespace
} // namespace zonegrid
