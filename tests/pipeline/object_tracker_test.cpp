#include "pipeline/object_tracker.h"

#include "support/oracle_objects.h"
#include "support/oracle_random.h"
#include "support/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

// docs/model.md, section 8, zone by zone.

namespace zonegrid {
namespace {

constexpr int edge = 8;

void set_zones(ObjectTracker& tracker, std::span<const CellIndex> cells) {
    for (const auto& [zone, bits] : scenes::zones_of(cells, edge)) {
        tracker.set_zone(zone, bits);
    }
}

TEST(ObjectTracker, NothingAtFirst) {
    ObjectTracker tracker(edge);
    EXPECT_TRUE(tracker.objects().empty());
}

TEST(ObjectTracker, JoinsAcrossZonesThroughFacesOnly) {
    ObjectTracker tracker(edge);
    // (7, 0, 0) and (8, 0, 0) share a face between zones; (8, 8, 0) touches neither but by an edge.
    const std::vector<CellIndex> cells{{7, 7, 0}, {8, 7, 0}, {9, 8, 0}, {7, 8, 1}};
    set_zones(tracker, cells);
    const auto objects = tracker.objects();
    ASSERT_EQ(objects.size(), 3U);
    EXPECT_EQ(objects[0].id, (CellIndex{7, 7, 0}));
    EXPECT_EQ(objects[0].cell_count, 2U);
    EXPECT_EQ(objects[1].id, (CellIndex{7, 8, 1}));
    EXPECT_EQ(objects[2].id, (CellIndex{9, 8, 0}));
}

TEST(ObjectTracker, ARingThroughFourZonesIsOneObject) {
    // A level ring around the corner of four zones, open nowhere.
    const auto ring = scenes::cells_where({-3, -3, 0}, {2, 2, 0}, [](const CellIndex& cell) {
        return cell.x == -3 || cell.x == 2 || cell.y == -3 || cell.y == 2;
    });
    ObjectTracker tracker(edge);
    set_zones(tracker, ring);
    ASSERT_EQ(tracker.objects().size(), 1U);
    EXPECT_EQ(tracker.objects()[0].cell_count, 20U);
}

TEST(ObjectTracker, TwoPiecesOfAZoneJoinThroughAnother) {
    // A U: both arms in zone 0, the bend in zone 1.
    const std::vector<CellIndex> cells{{6, 0, 0}, {7, 0, 0}, {8, 0, 0}, {8, 1, 0},
                                       {8, 2, 0}, {7, 2, 0}, {6, 2, 0}};
    ObjectTracker tracker(edge);
    set_zones(tracker, cells);
    EXPECT_EQ(tracker.objects().size(), 1U);
    tracker.set_zone({1, 0, 0}, ZoneBits(edge));
    EXPECT_EQ(tracker.objects().size(), 2U);
}

TEST(ObjectTracker, SettingAZoneReplacesWhatWasKnown) {
    ObjectTracker tracker(edge);
    const std::vector<CellIndex> before{{1, 1, 1}};
    const std::vector<CellIndex> after{{5, 5, 5}, {5, 5, 6}};
    set_zones(tracker, before);
    EXPECT_EQ(tracker.objects().size(), 1U);
    set_zones(tracker, after);
    ASSERT_EQ(tracker.objects().size(), 1U);
    EXPECT_EQ(tracker.objects()[0].id, (CellIndex{5, 5, 5}));
    tracker.set_zone({0, 0, 0}, ZoneBits(edge));
    EXPECT_TRUE(tracker.objects().empty());
}

/// Cells of one random zone near the origin, between empty and full.
std::vector<CellIndex> random_zone(oracle::Random& random, ZoneIndex& zone) {
    zone = {random.pick(-1, 1), random.pick(-1, 0), random.pick(-1, 0)};
    const CellIndex low = first_cell_of(zone, edge);
    const double density =
        std::array{0.0, 0.1, 0.35, 0.7, 1.0}[static_cast<std::size_t>(random.pick(0, 4))];
    return scenes::cells_where(low, {low.x + edge - 1, low.y + edge - 1, low.z + edge - 1},
                               [&](const CellIndex&) { return random.chance(density); });
}

TEST(ObjectTracker, EqualsUnionFindOverAllCellsAfterEveryChange) {
    constexpr std::uint64_t seed = 55;
    oracle::Random random(seed);
    int comparisons = 0;
    for (int run = 0; run < 12; ++run) {
        ObjectTracker tracker(edge);
        oracle::CellSet cells;
        for (int change = 0; change < 15; ++change) {
            for (int zones = random.pick(1, 3); zones > 0; --zones) {
                ZoneIndex zone;
                const auto in_zone = random_zone(random, zone);
                std::erase_if(cells, [&](const auto& cell) { return zone_of(cell, edge) == zone; });
                cells.insert(in_zone.begin(), in_zone.end());
                ZoneBits bits(edge);
                for (const auto& cell : in_zone) {
                    bits.set(index_in_zone(cell, edge));
                }
                tracker.set_zone(zone, bits);
            }
            ASSERT_EQ(scenes::difference(oracle::objects_of(cells, edge), tracker.objects()), "")
                << "seed " << seed << ", run " << run << ", change " << change;
            ++comparisons;
        }
    }
    EXPECT_EQ(comparisons, 180);
}

} // namespace
} // namespace zonegrid
