#pragma once

#include "device/device.h"
#include "model/fusion.h"
#include "ops/growing_buffer.h"
#include "ops/zone_layout.h"
#include "zonegrid/objects.h"

#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid::ops {

/// Draws remembered cells back into a zone of a device's grid (docs/model.md, section 6): equal to
/// reference::draw_objects.
class DrawObjects {
public:
    /// `device` lives longer.
    DrawObjects(device::Device& device, std::int32_t zone_edge, const FusionRule& rule,
                std::uint32_t group_items = device::default_group_items);

    /// Draws without waiting. `cells`, each given once, lie in the zone at `slot`, whose values are
    /// all 0.
    void dispatch(std::span<const CellIndex> cells, std::uint32_t slot, device::Buffer& grid_cells,
                  device::Buffer& occupied_planes);

private:
    device::Device& device_;
    std::int32_t zone_edge_;
    ZoneLayout layout_;
    FusionRule rule_;
    device::Kernel kernel_;
    GrowingBuffer cells_;
};

} // namespace zonegrid::ops
