#include "ops/measure_objects.h"

#include "reference/measure_objects.h"
#include "support/case_count.h"
#include "support/each_device.h"
#include "support/labelled_zones.h"

#include <gtest/gtest.h>

// Every device measures pieces as the reference measures objects.

namespace zonegrid {
namespace {

using device::Device;
using oracle::Random;

class MeasureObjectsOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, MeasureObjectsOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(MeasureObjectsOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        ops::MeasureObjects wide(*device);
        ops::MeasureObjects narrow(*device, 32);
        std::size_t compared = 0;
        const std::uint64_t count = case_count(60);
        for (std::uint64_t seed = 1; seed <= count; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const std::int32_t edge = 8 << random.pick(0, 2);
            auto& operation = random.chance(0.5) ? wide : narrow;
            ops::LabelComponents labels(*device, edge);
            const auto zones = nasty_zones(random, edge);
            label(*device, zones, labels);
            operation.dispatch(labels);
            const auto measures = operation.measures();
            const auto pieces = pieces_of(zones, edge);
            ASSERT_EQ(measures.size(), pieces.size());
            for (std::size_t i = 0; i < pieces.size(); ++i, ++compared) {
                const Object expected = reference::measure_object(pieces[i]);
                const auto& sum = measures[i].cell_sum;
                ASSERT_EQ(measures[i].cell_count, expected.cell_count) << "piece " << i;
                ASSERT_EQ(measures[i].least, expected.id) << "piece " << i;
                ASSERT_EQ(measures[i].box_min, expected.box_min) << "piece " << i;
                ASSERT_EQ(measures[i].box_max, expected.box_max) << "piece " << i;
                ASSERT_EQ((std::array<std::int64_t, 3>{sum[0], sum[1], sum[2]}), expected.cell_sum)
                    << "piece " << i;
            }
        }
        EXPECT_TRUE(compared > 20000U || count < 60) << compared;
    });
}

} // namespace
} // namespace zonegrid
