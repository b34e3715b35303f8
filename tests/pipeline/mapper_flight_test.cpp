#include "support/oracle_random.h"
#include "support/scenes.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

// Properties over random flights. Agreement with the model is in tests/ops/oracle_flight_test.

namespace zonegrid {
namespace {

using oracle::Random;

Camera camera() {
    return scenes::forward_camera(8, 6, 6.0);
}

struct Image {
    double time_s = 0.0;
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    double yaw_rad = 0.0;
    std::vector<float> depth_m;
};

/// Steps of a few cells, so that zones leave and come back; now and then a jump far away or home.
std::vector<Image> random_flight(Random& random, int images) {
    std::vector<Image> flight;
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    for (int n = 0; n < images; ++n) {
        if (random.chance(0.1)) {
            position_m.setZero();
        } else if (random.chance(0.1)) {
            position_m += Eigen::Vector3d(random.real(-60.0, 60.0), random.real(-60.0, 60.0), 0.0);
        } else {
            position_m += Eigen::Vector3d(random.real(-6.0, 6.0), random.real(-6.0, 6.0),
                                          random.real(-2.0, 2.0));
        }
        Image image{0.1 * n, position_m, random.real(-3.2, 3.2), {}};
        const float wall_m = random.real(1.0F, 10.0F);
        for (int pixel = 0; pixel < 48; ++pixel) {
            image.depth_m.push_back(random.chance(0.1)   ? std::numeric_limits<float>::quiet_NaN()
                                    : random.chance(0.2) ? std::numeric_limits<float>::infinity()
                                    : random.chance(0.5) ? wall_m
                                                         : random.real(0.5F, 12.0F));
        }
        flight.push_back(std::move(image));
    }
    return flight;
}

MapperOptions random_options(Random& random) {
    MapperOptions options;
    options.range_m = 8.0;
    options.zone = 8;
    options.model = random.chance(0.5) ? SensorModel::span : SensorModel::line;
    options.threshold = random.pick(1, 4);
    return options;
}

ImageResult show(Mapper& mapper, const Image& image) {
    return scenes::show(mapper, image.time_s, image.position_m, image.depth_m, image.yaw_rad);
}

TEST(MapperFlight, ObjectsAskedForAfterEveryImageEqualObjectsAskedForOnce) {
    constexpr std::uint64_t seed = 99;
    Random random(seed);
    std::uint64_t zones_left = 0;
    std::uint64_t zones_entered = 0;
    std::size_t objects = 0;
    for (int run = 0; run < 60; ++run) {
        const MapperOptions options = random_options(random);
        Mapper asked_always(options, camera());
        Mapper asked_once(options, camera());
        for (const auto& image : random_flight(random, random.pick(2, 40))) {
            const auto result = show(asked_always, image);
            ASSERT_EQ(result.status, ImageStatus::integrated);
            zones_left += result.zones_left;
            zones_entered += result.zones_entered;
            objects += asked_always.objects().size();
            show(asked_once, image);
        }
        ASSERT_EQ(scenes::difference(asked_once.objects(), asked_always.objects()), "")
            << "seed " << seed << ", run " << run;
    }
    // The flights were worth flying.
    EXPECT_GT(zones_left, 1000U);
    EXPECT_GT(zones_entered, 200U);
    EXPECT_GT(objects, 10000U);
}

TEST(MapperFlight, TwoMappersWithTheSameInputAreEqual) {
    constexpr std::uint64_t seed = 100;
    Random random(seed);
    for (int run = 0; run < 10; ++run) {
        const MapperOptions options = random_options(random);
        Mapper first(options, camera());
        Mapper second(options, camera());
        for (const auto& image : random_flight(random, 20)) {
            const auto first_result = show(first, image);
            const auto second_result = show(second, image);
            ASSERT_EQ(first_result.cells_changed, second_result.cells_changed);
            ASSERT_EQ(first_result.zones_left, second_result.zones_left);
        }
        ASSERT_EQ(scenes::values_of(first), scenes::values_of(second)) << "run " << run;
        ASSERT_EQ(scenes::difference(first.objects(), second.objects()), "") << "run " << run;
        ASSERT_EQ(first.height_profile().columns, second.height_profile().columns);
    }
}

TEST(MapperFlight, ObjectsHoldTheOccupiedCellsOfTheWindowAndTheRememberedOnes) {
    constexpr std::uint64_t seed = 101;
    Random random(seed);
    int remembering = 0;
    for (int run = 0; run < 20; ++run) {
        Mapper mapper(random_options(random), camera());
        for (const auto& image : random_flight(random, 15)) {
            show(mapper, image);
            std::uint64_t in_objects = 0;
            for (const auto& object : mapper.objects()) {
                in_objects += object.cell_count;
            }
            const auto statistics = mapper.statistics();
            if (statistics.zones_remembered == 0) {
                ASSERT_EQ(in_objects, statistics.cells_occupied) << "seed " << seed << run;
            } else {
                ++remembering;
                ASSERT_GE(in_objects, statistics.cells_occupied + statistics.zones_remembered);
            }
        }
    }
    EXPECT_GT(remembering, 50);
}

} // namespace
} // namespace zonegrid
