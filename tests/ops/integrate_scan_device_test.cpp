#include "ops/integrate_scan.h"

#include "ops/reached_zones.h"
#include "reference/integrate_scan.h"
#include "support/case_count.h"
#include "support/device_statements.h"
#include "support/each_device.h"
#include "support/oracle_random.h"
#include "support/statements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

// Every device draws the cells that the reference draws, no more and no fewer.

namespace zonegrid {
namespace {

using device::Device;
using oracle::Random;

Window random_window(Random& random) {
    const int zone_edge = 8 << random.pick(0, 2);
    // The widest that the model has costs time: now and then.
    const int zones = random.chance(0.005) ? 2048 / zone_edge : random.pick(1, 4);
    Window window(zone_edge, zones, 1);
    window.move_to({random.pick(-9000, 9000), random.pick(-9000, 9000), random.pick(-9000, 9000)});
    return window;
}

/// Anywhere in the window, often on the border of a cell or a zone or at the window's end.
std::int32_t random_sub(Random& random, const Window& window) {
    const int last = window.edge_cells() * ZG_SUB_PER_CELL - 1;
    if (random.chance(0.1)) {
        return random.chance(0.5) ? 0 : last;
    }
    if (random.chance(0.3)) {
        const int border =
            random.pick(0, window.zones_per_axis()) * window.zone_edge() * ZG_SUB_PER_CELL;
        return std::clamp(border + random.pick(-1, 1), 0, last);
    }
    return random.pick(0, last);
}

ScanRays random_rays(Random& random, const Window& window) {
    ScanRays scan;
    const int count = random.pick(0, 12);
    for (int i = 0; i < count; ++i) {
        const auto point = [&] {
            return SubPoint{random_sub(random, window), random_sub(random, window),
                            random_sub(random, window)};
        };
        ScanRay ray{point(), point(), random.chance(0.7)};
        if (random.chance(0.2)) { // along an axis or a diagonal, or no way at all
            ray.end = ray.start;
            ray.end.x = random_sub(random, window);
            if (random.chance(0.5)) {
                ray.end.y = std::clamp(ray.start.y + ray.end.x - ray.start.x, 0,
                                       window.edge_cells() * ZG_SUB_PER_CELL - 1);
            }
        }
        scan.rays.push_back(ray);
    }
    return scan;
}

class IntegrateScanOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, IntegrateScanOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(IntegrateScanOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        const std::uint64_t count = case_count(2000);
        ops::IntegrateScan operation(*device);
        std::uint64_t compared = 0;
        std::uint64_t stated = 0;
        for (std::uint64_t seed = 1; seed <= count; ++seed, ++compared) {
            Random random(seed);
            const Window window = random_window(random);
            const ScanRays scan = random_rays(random, window);
            LocalMap expected(window);
            reference::integrate_scan(scan, expected);

            ops::DeviceLocalMap local_map(*device, window);
            const auto places = ops::reached_zones(scan, window);
            local_map.reserve(places);
            operation.dispatch(scan, local_map);
            local_map.check();
            const auto actual = statements_of(local_map, places, window);
            ASSERT_EQ(oracle::difference(statements_of(expected), actual, window.zone_edge()), "")
                << "seed " << seed;
            stated += actual.size();
        }
        EXPECT_EQ(compared, count);
        EXPECT_TRUE(stated > 300000U || count < 2000) << stated;
    });
}

} // namespace
} // namespace zonegrid
