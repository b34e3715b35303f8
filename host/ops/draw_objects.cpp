#include "ops/draw_objects.h"

#include "kernels/params/draw_objects.h"
#include "model/lattice.h"

#include <array>

namespace zonegrid::ops {

using params::DrawObjectsParams;

DrawObjects::DrawObjects(device::Device& device, std::int32_t zone_edge, const FusionRule& rule,
                         std::uint32_t group_items)
    : device_(device),
      zone_edge_(zone_edge),
      layout_(zone_edge),
      rule_(rule),
      kernel_(device.make_kernel(
          {"draw_objects", "draw_objects", 3, sizeof(DrawObjectsParams), group_items})),
      cells_(device) {}

void DrawObjects::dispatch(std::span<const CellIndex> cells, std::uint32_t slot,
                           device::Buffer& grid_cells, device::Buffer& occupied_planes) {
    if (cells.empty()) {
        return;
    }
    std::vector<std::uint32_t> places;
    places.reserve(cells.size());
    for (const auto& cell : cells) {
        places.push_back(slot * layout_.zone_cells + index_in_zone(cell, zone_edge_));
    }
    const DrawObjectsParams params{static_cast<std::uint32_t>(places.size()), rule_.drawn()};
    const std::array<const device::Buffer*, 3> bindings{
        &grid_cells, &occupied_planes, &cells_.upload(std::span<const std::uint32_t>(places))};
    device_.dispatch(kernel_, bindings, std::as_bytes(std::span(&params, 1)),
                     kernel_.groups_for(params.cells));
}

} // namespace zonegrid::ops
