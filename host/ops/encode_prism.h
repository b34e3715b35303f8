#pragma once

#include "ops/piece_trees.h"

namespace zonegrid::ops {

/// Prisms of the pieces of labelled zones on a device (docs/model.md, section 8.5), with the
/// piece's zone as root: equal to reference::encode_prism.
class EncodePrism : public PieceTrees {
public:
    /// `device` lives longer.
    explicit EncodePrism(device::Device& device,
                         std::uint32_t group_items = device::default_group_items);
};

} // namespace zonegrid::ops
