#include "zonegrid/mapper.h"

#include "support/case_count.h"
#include "support/each_device.h"
#include "support/oracle_random.h"
#include "support/oracle_scenes.h"
#include "support/scenes.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// A Mapper gives the same map on every device as by the reference: cells, objects, profile, counts.

namespace zonegrid {
namespace {

using oracle::Picture;
using oracle::Random;

/// What the flights went through; a flight that meets nothing tests nothing.
struct Seen {
    std::uint64_t steps = 0;
    std::uint64_t entered = 0;
    std::uint64_t left = 0;
    std::uint64_t changed = 0;
    std::uint64_t objects = 0;
    std::uint64_t statements = 0;
};

/// A mapper on the reference and one on a device that get the same calls.
class MapperPair {
public:
    MapperPair(MapperOptions options, const Camera& camera, const std::string& device)
        : reference_(options, camera), device_(on(options, device), camera) {}

    void add_image(double time_s, const Eigen::Vector3d& position_m, double yaw_rad,
                   const std::vector<float>& depth_m, Seen& seen) {
        compare(scenes::show(reference_, time_s, position_m, depth_m, yaw_rad),
                scenes::show(device_, time_s, position_m, depth_m, yaw_rad), seen);
    }

    void add_scan(double time_s, const Eigen::Vector3d& position_m,
                  const std::vector<Eigen::Vector3f>& ends_m, Seen& seen) {
        Scan scan;
        scan.time_s = time_s;
        scan.ends_m = ends_m;
        const auto sample = scenes::resting_at(time_s, position_m);
        reference_.add_navigation(sample);
        device_.add_navigation(sample);
        compare(reference_.add_scan(scan), device_.add_scan(scan), seen);
    }

    void compare_maps(Seen& seen) {
        ASSERT_EQ(scenes::values_of(reference_), scenes::values_of(device_));
        const auto statements = statements_of(reference_);
        ASSERT_EQ(statements, statements_of(device_));
        seen.statements += statements.size();
        const auto objects = reference_.objects();
        ASSERT_EQ(scenes::difference(objects, device_.objects()), "");
        seen.objects += objects.size();
        ASSERT_EQ(reference_.height_profile().columns, device_.height_profile().columns);
        const auto expected = reference_.statistics();
        const auto actual = device_.statistics();
        EXPECT_EQ(expected.zones_held, actual.zones_held);
        EXPECT_EQ(expected.zones_held_most, actual.zones_held_most);
        EXPECT_EQ(expected.zones_remembered, actual.zones_remembered);
        EXPECT_EQ(expected.cells_occupied, actual.cells_occupied);
        EXPECT_EQ(expected.cells_free, actual.cells_free);
    }

private:
    /// In the order in which the mapper tells them, which is the same on every backend.
    static std::vector<std::pair<CellIndex, bool>> statements_of(const Mapper& mapper) {
        std::vector<std::pair<CellIndex, bool>> statements;
        mapper.for_each_statement(
            [&](const CellIndex& cell, bool occupied) { statements.emplace_back(cell, occupied); });
        return statements;
    }

    static MapperOptions on(MapperOptions options, const std::string& device) {
        options.backend = device;
        return options;
    }

    static void compare(const ImageResult& expected, const ImageResult& actual, Seen& seen) {
        ASSERT_EQ(expected.cells_changed, actual.cells_changed);
        ASSERT_EQ(expected.zones_entered, actual.zones_entered);
        ASSERT_EQ(expected.zones_left, actual.zones_left);
        ASSERT_EQ(expected.dropped, actual.dropped);
        ++seen.steps;
        seen.entered += expected.zones_entered;
        seen.left += expected.zones_left;
        seen.changed += expected.cells_changed;
    }

    Mapper reference_;
    Mapper device_;
};

/// Out and back again, in jumps of up to several zones, so that zones leave and return.
void fly(std::uint64_t seed, const std::string& device, Seen& seen) {
    constexpr int steps = 12;
    Random random(seed);
    const Camera camera = scenes::forward_camera(random.pick(3, 24), random.pick(2, 16), 12.0);
    MapperOptions options;
    options.cell_m = random.real(0.2, 1.5);
    options.range_m = options.cell_m * random.real(6.0, 20.0);
    options.zone = 8 << random.pick(0, 1);
    options.model = random.chance(0.5) ? SensorModel::span : SensorModel::line;
    options.limit = random.chance(0.3) ? 127 : 4;
    options.hit = random.pick(1, 4);
    MapperPair pair(options, camera, device);
    // Some fly where cells end: the sensor may be 2^30 cells from the origin at most.
    const double edge_m = (1073741824.0 - 200.0) * options.cell_m;
    const double base_m = random.chance(0.2) ? (random.chance(0.5) ? edge_m : -edge_m) : 0.0;
    double x_m = base_m;
    double time_s = 0.0;
    for (int step = 0; step < steps; ++step) {
        x_m += (step < steps / 2 ? 1.0 : -1.0) * random.real(0.0, 12.0) * options.cell_m;
        time_s += 0.1;
        const Eigen::Vector3d position_m(x_m, base_m + random.real(-1.0, 1.0), -3.0 - base_m);
        if (random.chance(0.25)) {
            std::vector<Eigen::Vector3f> ends_m;
            for (int i = 0; i < 40; ++i) {
                const auto share = static_cast<float>(options.range_m);
                ends_m.emplace_back(random.real(-share, share), random.real(-share, share),
                                    random.real(-share, share));
            }
            pair.add_scan(time_s, position_m, ends_m, seen);
        } else {
            const auto picture = random.chance(0.7) ? Picture::step : Picture::mixed;
            pair.add_image(time_s, position_m, random.real(-3.0, 3.0),
                           oracle::random_depths(random, camera, options, picture), seen);
        }
        if (step % 4 == 3) {
            pair.compare_maps(seen);
        }
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

class MapperOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, MapperOn, testing::Values("opencl", "vulkan"), backend_name);

TEST_P(MapperOn, MapsAsTheReferenceDoes) {
    for (const auto& info : devices()) {
        Seen seen;
        const std::uint64_t count = case_count(40);
        for (std::uint64_t seed = 1; seed <= count; ++seed) {
            SCOPED_TRACE(describe(info) + ", seed " + std::to_string(seed));
            fly(seed, info.id(), seen);
            ASSERT_FALSE(HasFatalFailure());
        }
        EXPECT_EQ(seen.steps, 12 * count);
        if (count < 40) {
            continue;
        }
        EXPECT_GT(seen.entered, 40U);
        EXPECT_GT(seen.left, 200U);
        EXPECT_GT(seen.changed, 100000U);
        EXPECT_GT(seen.objects, 1000U);
        EXPECT_GT(seen.statements, 10000U);
    }
}

TEST(MapperBackend, ThatIsMissingIsAnErrorThatNamesIt) {
    for (const std::string name : {"opencl:99", "vulkan:99"}) {
        MapperOptions options;
        options.backend = name;
        try {
            Mapper mapper(options);
            ADD_FAILURE() << name << " was opened";
        } catch (const DeviceError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(name));
        }
    }
}

} // namespace
} // namespace zonegrid
