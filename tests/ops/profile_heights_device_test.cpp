#include "ops/profile_heights.h"

#include "reference/profile_heights.h"
#include "support/case_count.h"
#include "support/each_device.h"
#include "support/labelled_zones.h"

#include <gtest/gtest.h>

// Every device finds the highest cells that the reference finds.

namespace zonegrid {
namespace {

using device::Device;
using ops::ProfileHeights;
using oracle::Random;

class ProfileHeightsOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, ProfileHeightsOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(ProfileHeightsOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        std::size_t columns = 0;
        const std::uint64_t count = case_count(60);
        for (std::uint64_t seed = 1; seed <= count; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const std::int32_t edge = 8 << random.pick(0, 2);
            const auto zones = nasty_zones(random, edge);
            const ops::ZoneLayout layout(edge);
            auto planes = device->make_buffer((zones.size() + 1) * layout.plane_bytes());
            device->fill(planes, 0, planes.bytes(), 0xdeadbeefU);
            std::vector<ops::ProfiledZone> profiled;
            for (std::size_t i = 0; i < zones.size(); ++i) {
                profiled.push_back(
                    {static_cast<std::uint32_t>(zones.size() - i),
                     static_cast<std::uint32_t>(random.chance(0.5) ? 0 : random.pick(0, edge))});
                device->upload(planes, profiled.back().slot * layout.plane_bytes(),
                               std::as_bytes(zones[i].words()));
            }
            ProfileHeights operation(*device, edge, random.chance(0.5) ? 128 : 32);
            operation.dispatch(planes, profiled);
            const auto heights = operation.heights();
            const auto zone_columns = static_cast<std::size_t>(edge * edge);
            ASSERT_EQ(heights.size(), zones.size() * zone_columns);
            for (std::size_t i = 0; i < zones.size(); ++i) {
                reference::HeightProfiler profiler(
                    edge, static_cast<std::int32_t>(profiled[i].first_layer));
                profiler.add_zone({0, 0, 0}, zones[i]);
                std::vector<std::uint8_t> expected(zone_columns, ProfileHeights::no_height);
                for (const auto& column : profiler.columns()) {
                    expected[static_cast<std::size_t>(column.y * edge + column.x)] =
                        static_cast<std::uint8_t>(column.z);
                    ++columns;
                }
                const auto first = heights.begin() + static_cast<std::ptrdiff_t>(i * zone_columns);
                ASSERT_EQ(std::vector(first, first + edge * edge), expected) << "zone " << i;
            }
        }
        EXPECT_TRUE(columns > 30000U || count < 60) << columns;
    });
}

} // namespace
} // namespace zonegrid
