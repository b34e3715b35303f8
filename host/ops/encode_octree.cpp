#include "ops/encode_octree.h"

namespace zonegrid::ops {

EncodeOctree::EncodeOctree(device::Device& device, std::uint32_t group_items)
    : PieceTrees(device, "encode_octree", 2, group_items) {}

} // namespace zonegrid::ops
