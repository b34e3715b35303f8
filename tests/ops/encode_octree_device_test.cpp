#include "ops/encode_octree.h"

#include "reference/encode_octree.h"
#include "support/case_count.h"
#include "support/each_device.h"
#include "support/labelled_zones.h"

#include <gtest/gtest.h>

// Every device writes the octrees of pieces as the reference writes those of objects.

namespace zonegrid {
namespace {

using device::Device;
using oracle::Random;

class EncodeOctreeOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, EncodeOctreeOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(EncodeOctreeOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        ops::MeasureObjects measures(*device);
        ops::EncodeOctree wide(*device);
        ops::EncodeOctree narrow(*device, 32);
        std::size_t compared = 0;
        const std::uint64_t count = case_count(40);
        for (std::uint64_t seed = 1; seed <= count; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const std::int32_t edge = 8 << random.pick(0, 2);
            auto& operation = random.chance(0.5) ? wide : narrow;
            ops::LabelComponents labels(*device, edge);
            const auto zones = nasty_zones(random, edge);
            label(*device, zones, labels);
            measures.dispatch(labels);
            operation.dispatch(labels, measures);
            const auto trees = operation.trees();
            const auto pieces = pieces_of(zones, edge);
            ASSERT_EQ(trees.size(), pieces.size());
            for (std::size_t i = 0; i < pieces.size(); ++i, ++compared) {
                ASSERT_EQ(trees[i], reference::encode_octree(pieces[i], {{0, 0, 0}, edge}))
                    << "piece " << i;
            }
        }
        EXPECT_TRUE(compared > 10000U || count < 40) << compared;
    });
}

} // namespace
} // namespace zonegrid
