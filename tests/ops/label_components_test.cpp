#include "reference/label_components.h"

#include "support/oracle_objects.h"
#include "support/oracle_random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace zonegrid {
namespace {

using oracle::CellSet;
using oracle::Random;

/// Components by the library: each as the set of its cells, sorted by the least cell.
std::vector<CellSet> components_of(const CellSet& occupied, std::int32_t zone_edge) {
    std::map<ZoneIndex, ZoneBits> bits;
    for (const CellIndex& cell : occupied) {
        bits.try_emplace(zone_of(cell, zone_edge), zone_edge)
            .first->second.set(index_in_zone(cell, zone_edge));
    }
    std::map<ZoneIndex, reference::ZonePieces> zones;
    for (const auto& [zone, cells] : bits) {
        zones[zone] = reference::label_zone(cells, zone_edge);
    }
    std::vector<CellSet> result;
    for (const auto& component : reference::join_pieces(zones)) {
        CellSet cells;
        for (const auto& [zone, piece] : component) {
            for (const std::uint32_t index : zones.at(zone).pieces.at(piece)) {
                cells.insert(cell_at(zone, index, zone_edge));
            }
        }
        result.push_back(cells);
    }
    std::ranges::sort(result, {}, [](const CellSet& cells) { return *cells.begin(); });
    return result;
}

/// Compares counts, identifiers, boxes and sums: together with the exact number of cells a cell in
/// the wrong component shows in the sums.
void expect_equal_components(const CellSet& occupied, std::int32_t zone_edge) {
    const auto expected = oracle::objects_of(occupied, zone_edge);
    const auto actual = components_of(occupied, zone_edge);
    ASSERT_EQ(actual.size(), expected.size());
    std::size_t cells = 0;
    for (std::size_t n = 0; n < actual.size(); ++n) {
        ASSERT_EQ(*actual[n].begin(), expected[n].id) << "component " << n;
        ASSERT_EQ(actual[n].size(), expected[n].cell_count) << "component " << n;
        ASSERT_EQ(oracle::octree_of(actual[n], zone_edge), expected[n].octree) << "component " << n;
        cells += actual[n].size();
    }
    ASSERT_EQ(cells, occupied.size());
}

CellSet filled(const CellIndex& low, const CellIndex& high) {
    CellSet cells;
    for (int x = low.x; x <= high.x; ++x) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int z = low.z; z <= high.z; ++z) {
                cells.insert({x, y, z});
            }
        }
    }
    return cells;
}

TEST(LabelComponents, NothingGivesNothing) {
    EXPECT_TRUE(components_of({}, 8).empty());
    const auto pieces = reference::label_zone(ZoneBits(8), 8);
    EXPECT_TRUE(pieces.pieces.empty());
}

TEST(LabelComponents, OneCell) {
    EXPECT_EQ(components_of({{-1, 7, 8}}, 8), (std::vector<CellSet>{{{-1, 7, 8}}}));
}

TEST(LabelComponents, EdgesAndCornersDoNotConnect) {
    EXPECT_EQ(components_of({{0, 0, 0}, {1, 1, 0}}, 8).size(), 2U);
    EXPECT_EQ(components_of({{0, 0, 0}, {1, 1, 1}}, 8).size(), 2U);
    // Across a zone's face, edge and corner as well.
    EXPECT_EQ(components_of({{7, 0, 0}, {8, 0, 0}}, 8).size(), 1U);
    EXPECT_EQ(components_of({{7, 7, 0}, {8, 8, 0}}, 8).size(), 2U);
    EXPECT_EQ(components_of({{-1, -1, -1}, {0, 0, 0}}, 8).size(), 2U);
}

TEST(LabelComponents, FullZones) {
    for (const int zone : {8, 16, 32}) {
        expect_equal_components(filled({0, 0, 0}, {zone - 1, zone - 1, zone - 1}), zone);
        expect_equal_components(filled({-1, -1, -1}, {zone, zone, 0}), zone);
    }
    EXPECT_EQ(components_of(filled({-9, -9, -9}, {9, 9, 9}), 8).size(), 1U);
}

TEST(LabelComponents, CheckerboardIsAllSingles) {
    CellSet cells;
    for (const CellIndex& cell : filled({-8, 0, 0}, {23, 15, 15})) {
        if (((cell.x + cell.y + cell.z) & 1) == 0) {
            cells.insert(cell);
        }
    }
    EXPECT_EQ(components_of(cells, 16).size(), 32U * 16U * 16U / 2U);
    expect_equal_components(cells, 8);
    // The most pieces that a zone can have.
    CellSet largest;
    for (const CellIndex& cell : filled({0, 0, 0}, {31, 31, 31})) {
        if (((cell.x + cell.y + cell.z) & 1) != 0) {
            largest.insert(cell);
        }
    }
    EXPECT_EQ(components_of(largest, 32).size(), 16384U);
}

/// A square spiral in the plane z, walls one cell wide with one cell between them.
CellSet spiral(int turns, std::int32_t z) {
    CellSet cells;
    CellIndex at{0, 0, z};
    int length = 2;
    int x_step = 1;
    int y_step = 0;
    for (int side = 0; side < 4 * turns; ++side) {
        for (int n = 0; n < length; ++n) {
            cells.insert(at);
            at.x += x_step;
            at.y += y_step;
        }
        const int turned = x_step;
        x_step = -y_step;
        y_step = turned;
        length += side % 2 == 1 ? 2 : 0;
    }
    return cells;
}

TEST(LabelComponents, SpiralsWindThroughManyZones) {
    // Two interleaved spirals that never touch, over zones of 8: many pieces, few components.
    CellSet cells = spiral(12, 0);
    EXPECT_EQ(components_of(cells, 8).size(), 1U);
    expect_equal_components(cells, 8);
    cells.merge(spiral(12, 2));
    EXPECT_EQ(components_of(cells, 8).size(), 2U);
    cells.insert({0, 0, 1}); // joins both at their inner ends
    EXPECT_EQ(components_of(cells, 8).size(), 1U);
    expect_equal_components(cells, 8);
    expect_equal_components(cells, 16);
}

TEST(LabelComponents, CombJoinsOnlyAtItsBack) {
    // Teeth in one zone, the back in the next: pieces of one zone joined through another.
    CellSet cells;
    for (int y = 0; y < 8; y += 2) {
        cells.merge(filled({0, y, 0}, {7, y, 0}));
    }
    EXPECT_EQ(components_of(cells, 8).size(), 4U);
    cells.merge(filled({8, 0, 0}, {8, 7, 0}));
    EXPECT_EQ(components_of(cells, 8).size(), 1U);
    cells.erase({8, 3, 0});
    EXPECT_EQ(components_of(cells, 8).size(), 2U);
    expect_equal_components(cells, 8);
}

TEST(LabelComponents, RandomGridsEqualUnionFind) {
    std::uint64_t grids = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed, ++grids) {
        Random random(seed);
        const int zone = 8 << random.pick(0, 2);
        const CellIndex low{random.pick(-40, 40), random.pick(-40, 40), random.pick(-40, 40)};
        const CellIndex high{low.x + random.pick(0, 20), low.y + random.pick(0, 20),
                             low.z + random.pick(0, 20)};
        // Around 0.31 the lattice percolates: components of every size.
        const double density = random.chance(0.5) ? random.real(0.25, 0.4) : random.real(0.0, 1.0);
        CellSet cells;
        for (const CellIndex& cell : filled(low, high)) {
            if (random.chance(density)) {
                cells.insert(cell);
            }
        }
        ASSERT_NO_FATAL_FAILURE(expect_equal_components(cells, zone))
            << "seed " << seed << ", zone " << zone;
    }
    EXPECT_EQ(grids, 300U);
}

TEST(LabelComponents, FarFromTheOriginInEveryOctant) {
    for (const std::int32_t far : {-(1 << 30), (1 << 30) - 20}) {
        CellSet cells = filled({far, far, -far - 20}, {far + 9, far + 1, -far - 18});
        ASSERT_NO_FATAL_FAILURE(expect_equal_components(cells, 32));
        EXPECT_EQ(components_of(cells, 8).size(), 1U);
    }
}

} // namespace
} // namespace zonegrid
