#pragma once

#include "device/device.h"
#include "model/fusion.h"
#include "model/view.h"
#include "model/window.h"
#include "ops/growing_buffer.h"
#include "ops/zone_layout.h"

#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid::ops {

/// A zone of the local map and the zone of the grid that it is added to, by their slots.
struct ZonePair {
    std::uint32_t local_slot = 0;
    std::uint32_t grid_slot = 0;
    std::uint32_t zone = 0; ///< where both stand: of `zone_in_window`
};

/// The zone at a place in the window, for a `ZonePair`: its x, y and z from the window's first zone
/// in a byte each.
[[nodiscard]] std::uint32_t zone_in_window(const Window& window, std::uint32_t place);

/// What fusion did to a zone.
struct ZoneChange {
    std::uint32_t values_changed = 0;
    std::uint32_t occupancies_changed = 0; ///< cells that became occupied or ceased to be
    std::uint32_t cells_stated = 0;        ///< cells of which the local map says anything
};

/// Where the zones lie; each in the layout of `ZoneLayout`.
struct FusionBuffers {
    const device::Buffer& local_planes; ///< in: local maps
    device::Buffer& grid_cells;         ///< in and out: values
    /// in and out: a bit plane a zone, the cells whose value is at least the threshold
    device::Buffer& occupied_planes;
};

/// Adds local maps to the grid on a device (docs/model.md, section 7): for the zones that it is
/// given, equal to reference::fuse_local_map.
class FuseLocalMap {
public:
    /// `device` lives longer. `zone_edge`: 8, 16 or 32 cells.
    FuseLocalMap(device::Device& device, std::int32_t zone_edge, const FusionRule& rule,
                 std::uint32_t group_items = device::default_group_items);

    /// Takes memory for so many pairs a dispatch. Throws CapacityError if there is none; `dispatch`
    /// does the same, unless there is enough.
    void reserve(std::size_t pairs);

    /// Fuses each pair, without waiting; `view` is of the image that the local maps are of. No two
    /// pairs share a grid slot. Throws UsageError if they do or if a slot lies outside its buffer,
    /// CapacityError if a buffer is too large for 32-bit places.
    void dispatch(const FusionBuffers& buffers, const View& view, std::span<const ZonePair> pairs);

    /// Waits; one entry a pair of the last dispatch, in its order.
    [[nodiscard]] std::vector<ZoneChange> changes();

private:
    void check(const FusionBuffers& buffers, std::span<const ZonePair> pairs) const;

    device::Device& device_;
    ZoneLayout layout_;
    std::uint32_t zone_bits_; ///< a zone is 2^zone_bits_ cells wide
    FusionRule rule_;
    device::Kernel kernel_;
    GrowingBuffer pairs_;
    GrowingBuffer changes_;
    std::size_t pair_count_ = 0; ///< of the last dispatch
};

} // namespace zonegrid::ops
