#include "ops/encode_octree.h"

#include "reference/encode_octree.h"
#include "support/each_device.h"
#include "support/piece_tree_comparison.h"

#include <gtest/gtest.h>

// Every device writes the octrees of pieces as the reference writes those of objects.

namespace zonegrid {
namespace {

class EncodeOctreeOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, EncodeOctreeOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(EncodeOctreeOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<device::Device>& device) {
        compare_piece_trees<ops::EncodeOctree>(*device, reference::encode_octree);
    });
}

} // namespace
} // namespace zonegrid
