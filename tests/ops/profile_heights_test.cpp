#include "reference/profile_heights.h"

#include "support/oracle_objects.h"
#include "support/oracle_random.h"
#include "support/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <ranges>
#include <vector>

// docs/model.md, section 9.

namespace zonegrid {
namespace {

using Columns = std::vector<ProfileColumn>;

Columns profile(const std::vector<CellIndex>& cells, int zone_edge,
                std::int32_t z_least = std::numeric_limits<std::int32_t>::min()) {
    reference::HeightProfiler profiler(zone_edge, z_least);
    for (const auto& [zone, bits] : scenes::zones_of(cells, zone_edge)) {
        profiler.add_zone(zone, bits);
    }
    return profiler.columns();
}

TEST(ProfileHeights, KeepsTheHighestCellOfAColumnAcrossZones) {
    // z points down: the highest is the least z. Zones of 8: z -9 and 20 are in other zones.
    EXPECT_EQ(profile({{1, 2, 20}, {1, 2, 3}, {1, 2, -9}, {1, 3, 5}}, 8),
              (Columns{{1, 2, -9}, {1, 3, 5}}));
}

TEST(ProfileHeights, SortedByXThenYAcrossZones) {
    EXPECT_EQ(profile({{8, -9, 0}, {-1, 8, 0}, {-1, -1, 0}, {0, 0, 0}, {-9, 20, 0}, {7, 30, 0}}, 8),
              (Columns{{-9, 20, 0}, {-1, -1, 0}, {-1, 8, 0}, {0, 0, 0}, {7, 30, 0}, {8, -9, 0}}));
}

TEST(ProfileHeights, CutLeavesOutWhatIsHigher) {
    const std::vector<CellIndex> tree{{0, 0, -6}, {0, 0, -5}, {0, 0, -1}, {1, 0, -6}};
    EXPECT_EQ(profile(tree, 8, -5), (Columns{{0, 0, -5}}));
    EXPECT_EQ(profile(tree, 8, -6), (Columns{{0, 0, -6}, {1, 0, -6}}));
    EXPECT_EQ(profile(tree, 8, -4), (Columns{{0, 0, -1}}));
    EXPECT_EQ(profile(tree, 8, 0), Columns{});
}

TEST(ProfileHeights, NothingGivesNothing) {
    EXPECT_EQ(profile({}, 8), Columns{});
    reference::HeightProfiler profiler(8);
    profiler.add_zone({0, 0, 0}, ZoneBits(8));
    EXPECT_EQ(profiler.columns(), Columns{});
}

TEST(ProfileHeights, TheOrderOfTheZonesDoesNotMatter) {
    const auto cells = scenes::cells_where({-20, -20, -20}, {20, 20, 20}, [](const CellIndex& c) {
        return (c.x * 31 + c.y * 17 + c.z * 7) % 23 == 0;
    });
    const auto zones = scenes::zones_of(cells, 8);
    reference::HeightProfiler profiler(8);
    for (const auto& [zone, bits] : std::views::reverse(zones)) {
        profiler.add_zone(zone, bits);
    }
    EXPECT_EQ(profiler.columns(), profile(cells, 8));
}

TEST(ProfileHeights, EqualsTheOracleWithAndWithoutCut) {
    constexpr std::uint64_t seed = 12;
    oracle::Random random(seed);
    for (int run = 0; run < 200; ++run) {
        const int zone = std::array{8, 16, 32}[static_cast<std::size_t>(random.pick(0, 2))];
        oracle::CellSet cells;
        for (int n = random.pick(0, 300); n > 0; --n) {
            cells.insert({random.pick(-40, 40), random.pick(-12, 12), random.pick(-40, 40)});
        }
        std::optional<double> cut_height_m;
        std::int32_t z_least = std::numeric_limits<std::int32_t>::min();
        if (random.chance(0.7)) {
            z_least = random.pick(-40, 40);
            cut_height_m = -z_least; // cells of 1 m
        }
        ASSERT_EQ(profile({cells.begin(), cells.end()}, zone, z_least),
                  oracle::profile_of(cells, 1.0, cut_height_m))
            << "seed " << seed << ", run " << run;
    }
}

} // namespace
} // namespace zonegrid
