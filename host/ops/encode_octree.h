#pragma once

#include "ops/piece_trees.h"

namespace zonegrid::ops {

/// Octrees of the pieces of labelled zones on a device (docs/model.md, section 8.4), with the
/// piece's zone as root: equal to reference::encode_octree.
class EncodeOctree : public PieceTrees {
public:
    /// `device` lives longer.
    explicit EncodeOctree(device::Device& device,
                          std::uint32_t group_items = device::default_group_items);
};

} // namespace zonegrid::ops
