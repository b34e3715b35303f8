#include "reference/encode_prism.h"

#include "support/oracle_objects.h"
#include "support/oracle_random.h"
#include "support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

// docs/model.md, section 8.5.

namespace zonegrid {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Cells = std::vector<CellIndex>;

TEST(EncodePrism, SingleCellByHand) {
    const auto encode = [](const CellIndex& cell) {
        return reference::encode_prism(Cells{cell}, {{0, 0, 0}, 8});
    };
    EXPECT_EQ(encode({0, 0, 0}), (Bytes{0x02, 0x02, 0x01}));
    EXPECT_EQ(encode({7, 7, 0}), (Bytes{0x80, 0x80, 0x40}));
    // (4, 2): x in the upper half: child 1; then y: child 2; then neither: child 0.
    EXPECT_EQ(encode({4, 2, 0}), (Bytes{0x08, 0x20, 0x01}));
}

TEST(EncodePrism, HeightDoesNotMatter) {
    const auto wall = scenes::box_of_cells({0, 3, -50}, {7, 3, 50});
    const auto line = scenes::box_of_cells({0, 3, 7}, {7, 3, 7});
    const TreeRoot root{{0, 0, 0}, 8};
    EXPECT_EQ(reference::encode_prism(wall, root), reference::encode_prism(line, root));
    // Row y = 3 of 8: children 0 and 1 "some"; in each, children 2 and 3 (y 2 .. 3) "some"; there
    // the two upper columns (y = 3).
    EXPECT_EQ(reference::encode_prism(wall, root),
              (Bytes{0x0A, 0xA0, 0x50, 0x50, 0xA0, 0x50, 0x50}));
}

TEST(EncodePrism, FullGroundPlanIsOneNode) {
    // Every column has one cell, each at another height.
    const auto stairs = scenes::cells_where({-8, 8, 0}, {-1, 15, 22}, [](const CellIndex& cell) {
        return cell.z == (cell.x + 8) + 2 * (cell.y - 8) - (cell.x + 8) / 2;
    });
    ASSERT_EQ(stairs.size(), 64U);
    EXPECT_EQ(reference::encode_prism(stairs, {{-8, 8, 0}, 8}), Bytes{0x55});
}

TEST(EncodePrism, RootTakesItsEdgeFromTheGroundPlanAlone) {
    const TreeRoot root = prism_root({-1, 5, -100}, {0, 6, 300}, 8);
    EXPECT_EQ(root.origin.x, -8);
    EXPECT_EQ(root.origin.y, 0);
    EXPECT_EQ(root.edge, 16);
}

TEST(EncodePrism, EqualsTheCountingOracle) {
    constexpr std::uint64_t seed = 78;
    oracle::Random random(seed);
    int sets = 0;
    for (int run = 0; run < 400; ++run) {
        const int zone = std::array{8, 16, 32}[static_cast<std::size_t>(random.pick(0, 2))];
        const CellIndex low{random.pick(-40, 20), random.pick(-40, 20), random.pick(-40, 20)};
        const CellIndex high{low.x + random.pick(0, 20), low.y + random.pick(0, 20),
                             low.z + random.pick(0, 3)};
        const double density = random.real(0.02, 1.0);
        const auto cells = scenes::cells_where(
            low, high, [&](const CellIndex&) { return random.chance(density); });
        if (cells.empty()) {
            continue;
        }
        const auto [x_low, x_high] = std::ranges::minmax(cells, {}, &CellIndex::x);
        const auto [y_low, y_high] = std::ranges::minmax(cells, {}, &CellIndex::y);
        const TreeRoot root = prism_root({x_low.x, y_low.y, 0}, {x_high.x, y_high.y, 0}, zone);
        ASSERT_EQ(reference::encode_prism(cells, root),
                  oracle::prism_of(oracle::CellSet(cells.begin(), cells.end()), zone))
            << "seed " << seed << ", run " << run << ", zone " << zone;
        ++sets;
    }
    EXPECT_GT(sets, 350);
}

} // namespace
} // namespace zonegrid
