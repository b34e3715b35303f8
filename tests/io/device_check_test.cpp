#include "io/device_check.h"

#include "device/device.h"
#include "io/broken_engine.h"
#include "io/map_difference.h"

#include <gmock/gmock.h>

#include <map>
#include <string>

// Devices that err are played by engines that do: the reference with one fault each.

namespace zonegrid {
namespace {

using testing::BrokenEngine;
using ::testing::Contains;
using ::testing::Each;
using testing::Fault;
using ::testing::Gt;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Pair;
using ::testing::StartsWith;

GridEngineMaker broken(Fault fault) {
    return
        [fault](const MapperOptions& options, const std::optional<Camera>&, const Window& window) {
            return std::make_unique<BrokenEngine>(options, window, fault);
        };
}

/// How often each operation was found at fault in 100 flights.
std::map<std::string, int> operations_found(Fault fault) {
    std::map<std::string, int> found;
    for (std::uint64_t number = 0; number < 100; ++number) {
        const GeneratedFlight flight(3, number);
        const FlightCheck check(flight, "reference");
        if (const auto difference = check.difference_of(broken(fault))) {
            EXPECT_THAT(difference->detail, HasSubstr("expected"));
            EXPECT_THAT(difference->frame, HasSubstr(".npy"));
            ++found[difference->operation];
        }
    }
    return found;
}

int sum_of(const std::map<std::string, int>& found) {
    int sum = 0;
    for (const auto& [operation, times] : found) {
        sum += times;
    }
    return sum;
}

TEST(FlightCheck, FindsNothingWhereNothingIsWrong) {
    EXPECT_THAT(operations_found(Fault::none), IsEmpty());
}

TEST(FlightCheck, FindsLostPixels) {
    const auto found = operations_found(Fault::image_loses_a_pixel);
    EXPECT_GT(sum_of(found), 40);
    EXPECT_THAT(found, Each(Key("integrate_image")));
}

TEST(FlightCheck, FindsLostRaysOfScans) {
    const auto found = operations_found(Fault::scan_loses_a_ray);
    EXPECT_GT(sum_of(found), 8);
    EXPECT_THAT(found, Each(Key("integrate_scan")));
}

TEST(FlightCheck, FindsValuesThatFusionCannotGive) {
    const auto found = operations_found(Fault::fusion_forgets_limit);
    EXPECT_THAT(found, Each(Key(HasSubstr("fuse_local_map"))));
    EXPECT_THAT(found, Contains(Pair("fuse_local_map", Gt(40))));
}

TEST(FlightCheck, FindsObstaclesThatDoNotComeBack) {
    const auto found = operations_found(Fault::drawing_loses_cells);
    EXPECT_GT(sum_of(found), 8);
    EXPECT_THAT(found, Each(Key(HasSubstr("draw_objects"))));
}

TEST(FlightCheck, FindsObstaclesThatComeBackWithAnotherValue) {
    const auto found = operations_found(Fault::drawing_adds_one);
    EXPECT_GT(sum_of(found), 8);
    EXPECT_THAT(found, Contains(Key("draw_objects or fuse_local_map")));
}

TEST(FlightCheck, FindsWrongObjectsWhereCellsAreRight) {
    const auto found = operations_found(Fault::planes_lose_a_cell);
    EXPECT_GT(sum_of(found), 50);
    EXPECT_THAT(found, Each(Key(HasSubstr("or the occupied bits of fuse_local_map"))));
    EXPECT_THAT(found, Contains(Key(StartsWith("label_components"))));
    EXPECT_THAT(found, Contains(Key(StartsWith("measure_objects"))));
}

TEST(FlightCheck, FindsWrongCounts) {
    const auto found = operations_found(Fault::counts_one_too_many);
    EXPECT_GT(sum_of(found), 90);
    EXPECT_THAT(found, Each(Key("fuse_local_map")));
}

TEST(FlightCheck, NamesImageCellZoneAndBothValues) {
    const GeneratedFlight flight(self_test_seed, self_test_flights[0]);
    const FlightCheck check(flight, "reference");
    const auto difference = check.difference_of(broken(Fault::image_loses_a_pixel));
    ASSERT_TRUE(difference.has_value());
    EXPECT_GE(difference->images, 1U);
    EXPECT_LE(difference->images, check.images());
    EXPECT_EQ(difference->what, "local map");
    for (const char* const part : {"first cell (", "in zone (", "): ", ", expected ", " differ"}) {
        EXPECT_THAT(difference->detail, HasSubstr(part));
    }
    const auto values = check.difference_of(broken(Fault::fusion_forgets_limit));
    ASSERT_TRUE(values.has_value());
    EXPECT_EQ(values->what, "cells");
    EXPECT_THAT(values->detail, HasSubstr("): value "));
    EXPECT_THAT(values->detail, HasSubstr(", expected value "));
}

Object two_cells() {
    Object object;
    object.cell_count = 2;
    object.box_max = {1, 0, 0};
    object.cell_sum = {1, 0, 0};
    object.octree = {1, 2};
    object.prism = {3};
    return object;
}

TEST(DifferenceOfObjects, NamesTheOperationThatErred) {
    const std::vector<Object> expected{two_cells()};
    EXPECT_EQ(difference_of_objects(expected, expected).what, "");
    auto actual = expected;
    actual[0].octree = {1, 3};
    EXPECT_EQ(difference_of_objects(expected, actual).operation, "encode_octree");
    EXPECT_THAT(difference_of_objects(expected, actual).detail, HasSubstr("part at byte 1"));
    actual = expected;
    actual[0].prism = {3, 4};
    EXPECT_EQ(difference_of_objects(expected, actual).operation, "encode_prism");
    EXPECT_THAT(difference_of_objects(expected, actual).detail,
                HasSubstr("prism of 2 bytes, expected 1"));
    actual = expected;
    actual[0].box_max = {2, 0, 0};
    EXPECT_EQ(difference_of_objects(expected, actual).operation,
              "measure_objects or the occupied bits of fuse_local_map");
    EXPECT_THAT(difference_of_objects(expected, actual).detail, HasSubstr("to (2, 0, 0)"));
    actual[0].id = {1, 0, 0};
    EXPECT_THAT(difference_of_objects(expected, actual).operation, StartsWith("label_components"));
    EXPECT_THAT(difference_of_objects(expected, {}).operation, StartsWith("label_components"));
}

TEST(SelfTest, GoesThroughWhatADeviceDoes) {
    const SelfTest test = test_backend("reference");
    EXPECT_EQ(test.problem, "");
    EXPECT_GE(test.images, 8U);
    EXPECT_GT(test.cells_changed, 1000U);
    for (const Fault fault :
         {Fault::image_loses_a_pixel, Fault::scan_loses_a_ray, Fault::fusion_forgets_limit,
          Fault::drawing_loses_cells, Fault::planes_lose_a_cell, Fault::counts_one_too_many}) {
        bool found = false;
        for (const std::uint64_t number : self_test_flights) {
            const GeneratedFlight flight(self_test_seed, number);
            found = found || FlightCheck(flight, "reference").difference_of(broken(fault));
        }
        EXPECT_TRUE(found) << static_cast<int>(fault);
    }
}

TEST(SelfTest, PassesOnEveryUsableDevice) {
    for (const auto& info : device::list_devices().devices) {
        if (info.refusal.empty()) {
            EXPECT_EQ(test_backend(info.id()).problem, "") << info.id() << " " << info.name;
        }
    }
}

TEST(SelfTest, SaysWhatTheDriverThrows) {
    EXPECT_THAT(test_backend("opencl:99").problem, HasSubstr("opencl:99"));
}

} // namespace
} // namespace zonegrid
