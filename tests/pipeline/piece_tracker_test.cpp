#include "pipeline/piece_tracker.h"

#include "model/tree_root.h"
#include "reference/encode_octree.h"
#include "reference/encode_prism.h"
#include "reference/label_components.h"
#include "reference/measure_objects.h"
#include "support/oracle_objects.h"
#include "support/oracle_random.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Objects joined from the pieces of zones are those that union-find over all cells gives.

namespace zonegrid {
namespace {

using oracle::CellSet;
using oracle::Random;

/// What a device would tell of a zone.
ZoneSummary summary_of(const ZoneIndex& zone, const ZoneBits& occupied, std::int32_t edge) {
    auto pieces = reference::label_zone(occupied, edge);
    ZoneSummary summary;
    summary.first_layer = pieces.first_layer;
    summary.last_layer = pieces.last_layer;
    const TreeRoot root{first_cell_of(zone, edge), edge};
    for (const auto& piece : pieces.pieces) {
        std::vector<CellIndex> cells;
        for (const auto index : piece) {
            cells.push_back(cell_at(zone, index, edge));
        }
        summary.pieces.push_back(reference::measure_object(cells));
        summary.pieces.back().octree = reference::encode_octree(cells, root);
        summary.pieces.back().prism = reference::encode_prism(cells, root);
    }
    return summary;
}

void expect_objects(PieceTracker& tracker, const std::map<ZoneIndex, ZoneBits>& zones,
                    std::int32_t edge) {
    CellSet cells;
    for (const auto& [zone, bits] : zones) {
        bits.for_each([&](std::uint32_t index) { cells.insert(cell_at(zone, index, edge)); });
    }
    const auto expected = oracle::objects_of(cells, edge);
    const auto& actual = tracker.objects();
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
        ASSERT_EQ(actual[i], expected[i]) << "object " << i;
    }
}

TEST(PieceTracker, NothingAtFirst) {
    EXPECT_TRUE(PieceTracker(8).objects().empty());
}

TEST(PieceTracker, PiecesOfAZoneThatMeetInAnotherShareTheirTrees) {
    // Two teeth in one zone whose cells together fill nodes that neither fills alone.
    std::map<ZoneIndex, ZoneBits> zones;
    PieceTracker tracker(8);
    for (const ZoneIndex& zone : {ZoneIndex{0, 0, 0}, ZoneIndex{1, 0, 0}}) {
        ZoneBits bits(8);
        for (std::int32_t y = 0; y < 8; ++y) {
            for (std::int32_t x = 0; x < 8; ++x) {
                const bool comb = zone.x == 1 ? x == 0 : y % 2 == 0;
                if (comb) {
                    bits.set(index_in_zone({x, y, y % 4 == 0 ? 0 : 1}, 8));
                    bits.set(index_in_zone({x, y, y % 4 == 0 ? 1 : 0}, 8));
                }
            }
        }
        tracker.set_zone(zone, summary_of(zone, bits, 8));
        zones.emplace(zone, bits);
    }
    expect_objects(tracker, zones, 8);
    EXPECT_EQ(tracker.objects().size(), 1U);
}

TEST(PieceTracker, EqualsUnionFindOverAllCellsAfterEveryChange) {
    std::size_t objects = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::int32_t edge = 8 << random.pick(0, 1);
        std::map<ZoneIndex, ZoneBits> zones;
        PieceTracker tracker(edge);
        for (int change = 0; change < 12; ++change) {
            const ZoneIndex zone{random.pick(-2, 1), random.pick(-1, 1), random.pick(-1, 0)};
            ZoneBits bits(edge);
            const double share = random.chance(0.2)   ? 0.0
                                 : random.chance(0.2) ? 1.0
                                                      : random.real(0.1, 0.9);
            for (std::int32_t i = 0; i < edge * edge * edge; ++i) {
                if (random.chance(share)) {
                    bits.set(static_cast<std::uint32_t>(i));
                }
            }
            tracker.set_zone(zone, summary_of(zone, bits, edge));
            zones.insert_or_assign(zone, bits);
            if (change % 3 == 2) {
                expect_objects(tracker, zones, edge);
                ASSERT_FALSE(HasFatalFailure());
                objects += tracker.objects().size();
            }
        }
    }
    EXPECT_GT(objects, 1000U);
}

} // namespace
} // namespace zonegrid
