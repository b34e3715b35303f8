#include "model/lattice.h"

#include "model/zone_bits.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace zonegrid {
namespace {

TEST(Lattice, FloorDivRoundsTowardsMinusInfinity) {
    EXPECT_EQ(floor_div(7, 8), 0);
    EXPECT_EQ(floor_div(8, 8), 1);
    EXPECT_EQ(floor_div(-1, 8), -1);
    EXPECT_EQ(floor_div(-8, 8), -1);
    EXPECT_EQ(floor_div(-9, 8), -2);
    EXPECT_EQ(floor_div(std::int64_t{-1} << 40, std::int64_t{3}), -366503875926);
}

TEST(Lattice, ZoneAndPlaceOfACellAcrossTheOrigin) {
    EXPECT_EQ(zone_of({-1, 0, 31}, 32), (ZoneIndex{-1, 0, 0}));
    EXPECT_EQ(zone_of({-32, -33, 32}, 32), (ZoneIndex{-1, -2, 1}));
    EXPECT_EQ(first_cell_of({-1, -2, 1}, 32), (CellIndex{-32, -64, 32}));
    // Order [z][y][x]: (31, 2, 1) in its zone.
    EXPECT_EQ(index_in_zone({-1, 2, 1}, 32), 1U * 1024 + 2U * 32 + 31U);
}

TEST(Lattice, CellAtIsTheInverseOfIndexInZone) {
    for (const std::int32_t edge : {8, 16, 32}) {
        const ZoneIndex zone{-3, 0, 5};
        const auto cells = static_cast<std::uint32_t>(edge * edge * edge);
        for (std::uint32_t i = 0; i < cells; ++i) {
            const CellIndex cell = cell_at(zone, i, edge);
            ASSERT_EQ(zone_of(cell, edge), zone);
            ASSERT_EQ(index_in_zone(cell, edge), i);
        }
    }
}

TEST(ZoneBits, SetResetTestAndVisit) {
    ZoneBits bits(8);
    EXPECT_FALSE(bits.any());
    for (const std::uint32_t index : {511U, 0U, 31U, 32U, 63U}) {
        bits.set(index);
    }
    bits.reset(31);
    bits.reset(200);
    std::vector<std::uint32_t> visited;
    bits.for_each([&](std::uint32_t index) { visited.push_back(index); });
    EXPECT_EQ(visited, (std::vector<std::uint32_t>{0, 32, 63, 511}));
    EXPECT_TRUE(bits.test(63));
    EXPECT_FALSE(bits.test(31));
    EXPECT_TRUE(bits.any());
}

TEST(ZoneBits, OccupiedFromTheThresholdOn) {
    std::vector<std::int8_t> values(512);
    values[5] = 2;
    values[6] = 1;
    values[7] = 127;
    values[8] = -127;
    ZoneBits expected(8);
    expected.set(5);
    expected.set(7);
    EXPECT_EQ(occupied_bits(values, 2, 8), expected);
    EXPECT_FALSE(occupied_bits({}, 2, 8).any());
}

} // namespace
} // namespace zonegrid
