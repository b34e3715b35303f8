#include "ops/encode_prism.h"

#include "reference/encode_prism.h"
#include "support/each_device.h"
#include "support/piece_tree_comparison.h"

#include <gtest/gtest.h>

// Every device writes the prisms of pieces as the reference writes those of objects.

namespace zonegrid {
namespace {

class EncodePrismOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, EncodePrismOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(EncodePrismOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<device::Device>& device) {
        compare_piece_trees<ops::EncodePrism>(*device, reference::encode_prism);
    });
}

} // namespace
} // namespace zonegrid
