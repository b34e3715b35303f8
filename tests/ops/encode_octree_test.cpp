#include "reference/encode_octree.h"

#include "support/oracle_objects.h"
#include "support/oracle_random.h"
#include "support/scenes.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

// docs/model.md, section 8.4.

namespace zonegrid {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Cells = std::vector<CellIndex>;
using testing::HasSubstr;

Bytes encode(const Cells& cells, const TreeRoot& root) {
    return reference::encode_octree(cells, root);
}

TEST(EncodeOctree, SingleCellByHand) {
    // Edge 8, cell (0, 0, 0): child 0 "some" twice, then "all".
    EXPECT_EQ(encode({{0, 0, 0}}, {{0, 0, 0}, 8}), (Bytes{0x02, 0x00, 0x02, 0x00, 0x01, 0x00}));
    // Cell (7, 7, 7): child 7, bits 14 and 15 of each node.
    EXPECT_EQ(encode({{7, 7, 7}}, {{0, 0, 0}, 8}), (Bytes{0x00, 0x80, 0x00, 0x80, 0x00, 0x40}));
    // Cell (4, 2, 1): x in the upper half: child 1; then y: child 2; then z: child 4.
    EXPECT_EQ(encode({{4, 2, 1}}, {{0, 0, 0}, 8}), (Bytes{0x08, 0x00, 0x20, 0x00, 0x00, 0x01}));
}

TEST(EncodeOctree, FullCubeIsOneNode) {
    EXPECT_EQ(encode(scenes::box_of_cells({-8, 0, 8}, {-1, 7, 15}), {{-8, 0, 8}, 8}),
              (Bytes{0x55, 0x55}));
}

TEST(EncodeOctree, SubtreesFollowInTheOrderOfTheirIndex) {
    // Child 0 is full, child 1 (x 4 .. 7) holds (7, 0, 0), child 6 (y and z 4 .. 7) holds (0, 4,
    // 4).
    auto cells = scenes::box_of_cells({0, 0, 0}, {3, 3, 3});
    cells.push_back({0, 4, 4});
    cells.push_back({7, 0, 0});
    EXPECT_EQ(encode(cells, {{0, 0, 0}, 8}),
              (Bytes{0x09, 0x20,                // 0: all, 1: some, 6: some
                     0x08, 0x00, 0x04, 0x00,    // (7, 0, 0): child 1, then child 1
                     0x02, 0x00, 0x01, 0x00})); // (0, 4, 4): child 0, then child 0
}

TEST(EncodeOctree, NothingIsOneEmptyNode) {
    EXPECT_EQ(encode({}, {{0, 0, 0}, 8}), (Bytes{0x00, 0x00}));
    EXPECT_TRUE(reference::decode_octree(Bytes{0x00, 0x00}, {{0, 0, 0}, 8}).empty());
}

TEST(EncodeOctree, RootIsTheLeastCubeOfZonesOverTheBox) {
    const auto check = [](const CellIndex& low, const CellIndex& high, const CellIndex& origin,
                          int edge) {
        const TreeRoot root = octree_root(low, high, 8);
        EXPECT_EQ(root.origin, origin);
        EXPECT_EQ(root.edge, edge);
    };
    check({0, 0, 0}, {7, 7, 7}, {0, 0, 0}, 8);
    check({7, 7, 7}, {8, 7, 7}, {0, 0, 0}, 16);
    check({8, 3, -1}, {8, 3, -1}, {8, 0, -8}, 8);
    check({-1, 0, 0}, {0, 0, 0}, {-8, 0, 0}, 16);  // crosses 0
    check({-9, 0, 0}, {0, 0, 0}, {-16, 0, 0}, 32); // three zones
    check({5, 5, 5}, {5, 5, 21}, {0, 0, 0}, 32);   // z alone decides
}

/// Encodes, compares with the counting oracle, decodes.
testing::AssertionResult round_trip(const Cells& cells, int zone) {
    const auto [x_low, x_high] = std::ranges::minmax(cells, {}, &CellIndex::x);
    const auto [y_low, y_high] = std::ranges::minmax(cells, {}, &CellIndex::y);
    const auto [z_low, z_high] = std::ranges::minmax(cells, {}, &CellIndex::z);
    const TreeRoot root =
        octree_root({x_low.x, y_low.y, z_low.z}, {x_high.x, y_high.y, z_high.z}, zone);
    const Bytes octree = encode(cells, root);
    const oracle::CellSet sorted(cells.begin(), cells.end());
    if (octree != oracle::octree_of(sorted, zone)) {
        return testing::AssertionFailure() << "the bytes are not those of the oracle";
    }
    const Cells decoded = reference::decode_octree(octree, root);
    const auto difference = scenes::difference(Cells(sorted.begin(), sorted.end()), decoded);
    return difference.empty() ? testing::AssertionSuccess()
                              : testing::AssertionFailure() << "decoded: " << difference;
}

TEST(EncodeOctree, NastySetsComeBack) {
    const auto checkers = [](const CellIndex& cell) {
        return ((cell.x + cell.y + cell.z) & 1) == 0;
    };
    const auto shell = [](const CellIndex& cell) {
        return cell.x == -16 || cell.x == 15 || cell.y == -16 || cell.y == 15 || cell.z == -16 ||
               cell.z == 15;
    };
    EXPECT_TRUE(round_trip(scenes::cells_where({-8, -8, -8}, {7, 7, 7}, checkers), 8));
    EXPECT_TRUE(round_trip(scenes::cells_where({-16, -16, -16}, {15, 15, 15}, shell), 16));
    EXPECT_TRUE(round_trip(scenes::box_of_cells({-1, -1, -1}, {0, 0, 0}), 32));
    EXPECT_TRUE(round_trip(scenes::box_of_cells({-32, -32, -32}, {-1, -1, -1}), 32));
    EXPECT_TRUE(round_trip(scenes::box_of_cells({0, 0, 0}, {0, 0, 100}), 8));
    EXPECT_TRUE(round_trip({{-1, -1, -1}}, 8));
    EXPECT_TRUE(round_trip({{-100, 0, 0}, {100, 0, 0}}, 8));
}

TEST(EncodeOctree, RandomSetsComeBack) {
    constexpr std::uint64_t seed = 77;
    oracle::Random random(seed);
    int sets = 0;
    for (int run = 0; run < 300; ++run) {
        const int zone = std::array{8, 16, 32}[static_cast<std::size_t>(random.pick(0, 2))];
        const CellIndex low{random.pick(-40, 20), random.pick(-40, 20), random.pick(-40, 20)};
        const CellIndex high{low.x + random.pick(0, 11), low.y + random.pick(0, 11),
                             low.z + random.pick(0, 11)};
        const double density = random.real(0.05, 1.0);
        const auto cells = scenes::cells_where(
            low, high, [&](const CellIndex&) { return random.chance(density); });
        if (!cells.empty()) {
            ASSERT_TRUE(round_trip(cells, zone)) << "seed " << seed << ", run " << run;
            ++sets;
        }
    }
    EXPECT_GT(sets, 250);
}

TEST(EncodeOctree, TheOrderOfTheCellsDoesNotMatter) {
    auto cells = scenes::cells_where({0, 0, 0}, {15, 15, 15}, [](const CellIndex& cell) {
        return cell.x * cell.x + cell.y * cell.y + cell.z * cell.z < 150;
    });
    const TreeRoot root{{0, 0, 0}, 16};
    const Bytes straight = encode(cells, root);
    std::ranges::reverse(cells);
    EXPECT_EQ(encode(cells, root), straight);
}

void expect_refused(const Bytes& octree, int edge, const char* problem) {
    try {
        const auto cells = reference::decode_octree(octree, {{0, 0, 0}, edge});
        ADD_FAILURE() << "accepted with " << cells.size() << " cells: " << problem;
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("octree"));
        EXPECT_THAT(error.what(), HasSubstr(problem));
        EXPECT_THAT(error.what(), HasSubstr("store it again"));
    }
}

TEST(EncodeOctree, DamagedOctreesAreRefused) {
    expect_refused({}, 8, "ends in the middle of a node");
    expect_refused({0x55}, 8, "ends in the middle of a node");
    expect_refused({0x02, 0x00}, 8, "ends in the middle of a node");
    expect_refused({0x02, 0x00, 0x01}, 8, "ends in the middle of a node");
    expect_refused({0x03, 0x00}, 8, "a child has the state 3");
    expect_refused({0x00, 0x00, 0x00}, 8, "bytes are left over");
    // Edge 8, 4, 2: a third "some" would divide single cells.
    expect_refused({0x02, 0x00, 0x02, 0x00, 0x02, 0x00, 0x01, 0x00}, 8, "divides a single cell");
}

TEST(EncodeOctree, EveryTruncationIsRefused) {
    const auto cells = scenes::cells_where({0, 0, 0}, {7, 7, 7}, [](const CellIndex& cell) {
        return (cell.x * 7 + cell.y * 5 + cell.z * 3) % 4 == 0;
    });
    const Bytes octree = encode(cells, {{0, 0, 0}, 8});
    ASSERT_GT(octree.size(), 20U);
    for (std::size_t length = 0; length < octree.size(); ++length) {
        const Bytes cut(octree.begin(), octree.begin() + static_cast<std::ptrdiff_t>(length));
        expect_refused(cut, 8, "ends in the middle of a node");
    }
}

} // namespace
} // namespace zonegrid
