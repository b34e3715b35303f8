#include "ops/encode_prism.h"

namespace zonegrid::ops {

EncodePrism::EncodePrism(device::Device& device, std::uint32_t group_items)
    : PieceTrees(device, "encode_prism", 1, group_items) {}

} // namespace zonegrid::ops
