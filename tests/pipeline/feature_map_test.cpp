#include "pipeline/feature_map.h"

#include "support/oracle_random.h"
#include "support/scenes.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace zonegrid {
namespace {

using Cells = std::vector<CellIndex>;

constexpr int edge = 8;

TEST(FeatureMap, HandsOverWhatItRemembersOnce) {
    FeatureMap features(edge);
    const Cells cells{{-8, 0, 8}, {-5, 3, 9}, {-1, 7, 15}};
    features.remember({-1, 0, 1}, cells);
    EXPECT_EQ(features.cells({-1, 0, 1}), cells);
    EXPECT_TRUE(features.cells({0, 0, 1}).empty());
    EXPECT_EQ(features.zones().size(), 1U);
    EXPECT_EQ(features.take({-1, 0, 1}), cells);
    EXPECT_TRUE(features.take({-1, 0, 1}).empty());
    EXPECT_TRUE(features.zones().empty());
}

TEST(FeatureMap, RememberingReplacesAndNothingForgets) {
    FeatureMap features(edge);
    features.remember({0, 0, 0}, Cells{{1, 1, 1}, {2, 2, 2}});
    features.remember({0, 0, 0}, Cells{{3, 3, 3}});
    EXPECT_EQ(features.cells({0, 0, 0}), (Cells{{3, 3, 3}}));
    features.remember({0, 0, 0}, {});
    EXPECT_TRUE(features.zones().empty());
}

TEST(FeatureMap, FindsTheZonesAWindowHolds) {
    FeatureMap features(edge);
    for (std::int32_t x = -4; x <= 4; ++x) {
        features.remember({x, 0, 0}, Cells{{8 * x, 0, 0}});
    }
    features.remember({0, 9, 0}, Cells{{0, 72, 0}});
    Window window(edge, 3, 4);
    EXPECT_TRUE(features.zones_in(window).empty()) << "it has no place yet";
    window.move_to({8, 0, 0}); // zones 0 .. 2 on x
    EXPECT_EQ(features.zones_in(window), (std::vector<ZoneIndex>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
}

TEST(FeatureMap, EqualsAMapOfCellLists) {
    constexpr std::uint64_t seed = 8;
    oracle::Random random(seed);
    FeatureMap features(edge);
    std::map<ZoneIndex, Cells> model;
    for (int n = 0; n < 400; ++n) {
        const ZoneIndex zone{random.pick(-1, 1), random.pick(-1, 1), 0};
        if (random.chance(0.3)) {
            ASSERT_EQ(features.take(zone), model[zone]) << "seed " << seed << ", step " << n;
            model.erase(zone);
            continue;
        }
        const CellIndex low = first_cell_of(zone, edge);
        const double density = random.real(0.0, 1.0);
        const Cells cells =
            scenes::cells_where(low, {low.x + 7, low.y + 7, low.z + 7},
                                [&](const auto&) { return random.chance(density); });
        features.remember(zone, cells);
        model[zone] = cells;
        ASSERT_EQ(scenes::difference(cells, features.cells(zone)), "") << "step " << n;
    }
}

} // namespace
} // namespace zonegrid
