#include "pipeline/wall_flight.h"

#include "support/scenes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

// docs/model.md, sections 6 and 8: what stays when the vehicle flies away and comes back.

namespace zonegrid {
namespace {

std::map<CellIndex, int> wall_with_value(int value) {
    std::map<CellIndex, int> values;
    for (const auto& cell : WallFlight::wall_cells()) {
        values.emplace(cell, value);
    }
    return values;
}

std::size_t zones_with_values(const Mapper& mapper) {
    std::set<ZoneIndex> zones;
    for (const auto& [cell, value] : scenes::values_of(mapper)) {
        zones.insert(zone_of(cell, mapper.options().zone));
    }
    return zones.size();
}

TEST(MapperMemory, AWallIsOneObject) {
    WallFlight flight;
    const auto result = flight.see_wall();
    EXPECT_EQ(result.status, ImageStatus::integrated);
    EXPECT_EQ(result.rays, 192U);
    EXPECT_EQ(result.missing, 0U);
    const auto objects = flight.mapper().objects();
    ASSERT_EQ(objects.size(), 1U);
    EXPECT_EQ(objects[0].id, (CellIndex{10, -5, -3}));
    EXPECT_EQ(objects[0].cell_count, 77U);
    EXPECT_EQ(objects[0].box_min, (CellIndex{10, -5, -3}));
    EXPECT_EQ(objects[0].box_max, (CellIndex{10, 5, 3}));
    EXPECT_EQ(objects[0].cell_sum, (std::array<std::int64_t, 3>{770, 0, 0}));
    EXPECT_TRUE(objects[0].centre_m(1.0).isApprox(Eigen::Vector3d(10.5, 0.5, 0.5)));
    for (const auto& cell : WallFlight::wall_cells()) {
        EXPECT_EQ(flight.mapper().value(cell), 2);
    }
    EXPECT_EQ(flight.mapper().value({5, 0, 0}), -1);
    EXPECT_EQ(flight.mapper().value({11, 0, 0}), 0);
    EXPECT_EQ(flight.mapper().value({1000, 0, 0}), 0);
}

TEST(MapperMemory, ObjectsStayWhenAllTheirZonesLeave) {
    WallFlight flight;
    flight.see_wall();
    const auto before = flight.mapper().objects();
    const auto profile = flight.mapper().height_profile().columns;
    const auto away = flight.fly_to(WallFlight::far_away_m);
    EXPECT_GT(away.zones_left, 0U);
    EXPECT_EQ(away.zones_entered, 0U);
    EXPECT_EQ(scenes::difference(before, flight.mapper().objects()), "");
    EXPECT_EQ(flight.mapper().height_profile().columns, profile);
    const auto statistics = flight.mapper().statistics();
    EXPECT_EQ(statistics.cells_occupied, 0U);
    EXPECT_EQ(statistics.zones_held, 0U);
    EXPECT_EQ(statistics.zones_remembered, 4U); // y and z cross 0
    EXPECT_EQ(flight.mapper().value({10, 0, 0}), 0) << "outside the window";
    EXPECT_TRUE(scenes::values_of(flight.mapper()).empty());
}

TEST(MapperMemory, ObjectsAreKeptEvenIfNobodyAskedForThemBefore) {
    WallFlight asked;
    asked.see_wall();
    const auto expected = asked.mapper().objects();
    WallFlight flight;
    flight.see_wall();
    flight.fly_to(WallFlight::far_away_m);
    EXPECT_EQ(scenes::difference(expected, flight.mapper().objects()), "");
}

TEST(MapperMemory, CellsAreDrawnBackBetweenThresholdAndLimit) {
    WallFlight flight;
    flight.see_wall();
    const auto before = flight.mapper().objects();
    flight.fly_to(WallFlight::far_away_m);
    const auto back = flight.fly_to(WallFlight::home_m);
    EXPECT_EQ(back.zones_entered, 4U);
    EXPECT_EQ(back.cells_changed, 0U);
    EXPECT_EQ(scenes::values_of(flight.mapper()), wall_with_value(5)); // (2 + 8 + 1) / 2
    EXPECT_EQ(scenes::difference(before, flight.mapper().objects()), "");
    EXPECT_EQ(flight.mapper().statistics().zones_remembered, 0U);
    EXPECT_EQ(flight.mapper().statistics().cells_occupied, 77U);
}

TEST(MapperMemory, ANewMeasurementConfirms) {
    WallFlight flight;
    flight.see_wall();
    const auto before = flight.mapper().objects();
    flight.fly_to(WallFlight::far_away_m);
    flight.see_wall();
    for (const auto& cell : WallFlight::wall_cells()) {
        EXPECT_EQ(flight.mapper().value(cell), 7);
    }
    EXPECT_EQ(scenes::difference(before, flight.mapper().objects()), "");
}

TEST(MapperMemory, NewMeasurementsClear) {
    WallFlight flight;
    flight.see_panel();
    const auto before = flight.mapper().objects();
    ASSERT_EQ(before.at(0).cell_count, 25U);
    flight.fly_to(WallFlight::far_away_m);
    for (int image = 0; image < 3; ++image) { // 5 to 2
        flight.see_sky(WallFlight::home_m);
        EXPECT_EQ(scenes::difference(before, flight.mapper().objects()), "");
    }
    flight.see_sky(WallFlight::home_m); // to 1
    EXPECT_TRUE(flight.mapper().objects().empty());
    EXPECT_TRUE(flight.mapper().height_profile().columns.empty());
    // What was cleared is not remembered from before.
    flight.fly_to(WallFlight::far_away_m);
    EXPECT_EQ(flight.mapper().statistics().zones_remembered, 0U);
    flight.fly_to(WallFlight::home_m);
    EXPECT_TRUE(flight.mapper().objects().empty());
    EXPECT_TRUE(scenes::values_of(flight.mapper()).empty());
}

TEST(MapperMemory, AWallThatLeavesTheImageStays) {
    // Level flight along the wall: each image sees sky beyond the end of what is left in view.
    WallFlight flight;
    flight.see_wall();
    const auto before = flight.mapper().objects();
    for (int image = 0; image < 100; ++image) {
        flight.see_sky({0.5, 10.2, 0.5}); // y = 5 lies across the image's left edge
    }
    EXPECT_EQ(scenes::difference(before, flight.mapper().objects()), "");
    EXPECT_EQ(flight.mapper().value({10, 5, 0}), 2);
    EXPECT_EQ(flight.mapper().value({10, 6, 0}), -8) << "no obstacle: free at once";
}

TEST(MapperMemory, AnObjectAcrossTheWindowsEdgeIsOneObject) {
    WallFlight flight;
    flight.see_wall();
    const auto before = flight.mapper().objects();
    flight.fly_to(WallFlight::beside_m);
    const auto statistics = flight.mapper().statistics();
    EXPECT_EQ(statistics.window_first_cell.y, 0);
    EXPECT_EQ(statistics.cells_occupied, 42U); // y = 0 .. 5
    EXPECT_EQ(statistics.zones_remembered, 2U);
    EXPECT_EQ(flight.mapper().value({10, 0, 0}), 2);
    EXPECT_EQ(flight.mapper().value({10, -1, 0}), 0);
    EXPECT_EQ(scenes::difference(before, flight.mapper().objects()), "");
    // Back: the part that stayed has its values, the part that left is drawn.
    flight.fly_to(WallFlight::home_m);
    EXPECT_EQ(flight.mapper().value({10, 0, 0}), 2);
    EXPECT_EQ(flight.mapper().value({10, -1, 0}), 5);
    EXPECT_EQ(scenes::difference(before, flight.mapper().objects()), "");
}

TEST(MapperMemory, ClearingThePartInTheWindowLeavesTheRememberedPart) {
    WallFlight flight;
    flight.see_wall();
    flight.fly_to(WallFlight::beside_m);
    // From the window's edge, looking at the right part of the wall only: y = 0 .. 9 at x = 10.
    for (int image = 0; image < 2; ++image) {
        flight.see_sky({0.5, 26.5, 0.5});
    }
    ASSERT_EQ(flight.mapper().objects().size(), 1U) << "nothing was looked at there";
    EXPECT_EQ(flight.mapper().objects()[0].cell_count, 77U);
    flight.see_sky({0.5, 9.0, 0.5}); // of y = 5 it sees all but the ends: 2 to 1
    const auto objects = flight.mapper().objects();
    ASSERT_EQ(objects.size(), 1U);
    EXPECT_EQ(objects[0].id, (CellIndex{10, -5, -3}));
    EXPECT_EQ(objects[0].cell_count, 72U);
    EXPECT_EQ(objects[0].box_min.y, -5);
    EXPECT_EQ(objects[0].box_max.y, 5); // the ends
}

TEST(MapperMemory, AZoneNeverTouchedCostsNothing) {
    WallFlight flight;
    EXPECT_EQ(flight.mapper().statistics().zones_held, 0U);
    flight.fly_to(WallFlight::home_m);
    EXPECT_EQ(flight.mapper().statistics().zones_held, 0U);
    EXPECT_EQ(flight.mapper().statistics().window_cells, 48);
    flight.see_wall();
    const auto statistics = flight.mapper().statistics();
    EXPECT_EQ(statistics.zones_held, zones_with_values(flight.mapper()));
    EXPECT_LT(statistics.zones_held, 20U); // of 216
    EXPECT_EQ(statistics.zones_held_most, statistics.zones_held);
    flight.fly_to(WallFlight::far_away_m);
    EXPECT_EQ(flight.mapper().statistics().zones_held, 0U);
    EXPECT_EQ(flight.mapper().statistics().zones_held_most, statistics.zones_held);
    // On the way back only zones with obstacles are held again.
    flight.fly_to(WallFlight::home_m);
    EXPECT_EQ(flight.mapper().statistics().zones_held, 4U);
}

TEST(MapperMemory, HeightProfileAndItsCut) {
    WallFlight flight;
    flight.see_wall();
    const auto columns_at = [](std::int32_t z) {
        std::vector<ProfileColumn> columns;
        for (std::int32_t y = -5; y <= 5; ++y) {
            columns.push_back({10, y, z});
        }
        return columns;
    };
    const auto check_all = [&](const char* where) {
        EXPECT_EQ(flight.mapper().height_profile().columns, columns_at(-3)) << where;
        EXPECT_EQ(flight.mapper().height_profile(1e300).columns, columns_at(-3)) << where;
        EXPECT_EQ(flight.mapper().height_profile(1.0).columns, columns_at(-1)) << where;
        EXPECT_EQ(flight.mapper().height_profile(1.9).columns, columns_at(-1)) << where;
        EXPECT_EQ(flight.mapper().height_profile(2.0).columns, columns_at(-2)) << where;
        EXPECT_EQ(flight.mapper().height_profile(-3.0).columns, columns_at(3)) << where;
        EXPECT_TRUE(flight.mapper().height_profile(-3.1).columns.empty()) << where;
        EXPECT_TRUE(flight.mapper().height_profile(-1e300).columns.empty()) << where;
        EXPECT_EQ(flight.mapper().height_profile().cell_m, 1.0) << where;
    };
    check_all("in the window");
    flight.fly_to(WallFlight::beside_m);
    check_all("half remembered");
    flight.fly_to(WallFlight::far_away_m);
    check_all("remembered");
}

TEST(MapperMemory, CellsComeInOrderAndAgreeWithValuesAndStatistics) {
    WallFlight flight;
    flight.see_wall();
    std::vector<CellIndex> cells;
    std::uint64_t occupied = 0;
    std::uint64_t free = 0;
    flight.mapper().for_each_cell([&](const CellIndex& cell, int value) {
        cells.push_back(cell);
        EXPECT_EQ(value, flight.mapper().value(cell));
        EXPECT_NE(value, 0);
        occupied += value >= 2 ? 1U : 0U;
        free += value < 0 ? 1U : 0U;
    });
    EXPECT_TRUE(std::ranges::is_sorted(cells));
    EXPECT_EQ(std::set(cells.begin(), cells.end()).size(), cells.size());
    EXPECT_GT(free, 100U);
    EXPECT_EQ(flight.mapper().statistics().cells_occupied, occupied);
    EXPECT_EQ(flight.mapper().statistics().cells_free, free);
}

} // namespace
} // namespace zonegrid
