#pragma once

#include "device/device.h"
#include "ops/growing_buffer.h"
#include "ops/zone_layout.h"

#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid::ops {

/// What labelling found in a zone.
struct LabelledZone {
    std::uint32_t pieces = 0;
    std::uint32_t cells = 0; ///< occupied ones
};

/// A piece by its zone's place among those that were labelled, and its number there.
struct LabelledPiece {
    std::uint32_t zone = 0;
    std::uint32_t number = 0; ///< from 1 on, in the order of their first cells
};

/// Numbers the pieces of zones on a device (docs/model.md, section 8.2): zone by zone, equal to
/// reference::label_zone.
class LabelComponents {
public:
    /// How many zones may be labelled at once: 16 MB of scratch memory with zones of 32.
    static constexpr std::size_t most_zones = 64;

    /// `device` lives longer.
    LabelComponents(device::Device& device, std::int32_t zone_edge,
                    std::uint32_t group_items = device::default_group_items);

    /// Takes memory for so many zones, whatever is in them. Throws CapacityError if there is none;
    /// `dispatch` does the same, unless there is enough.
    void reserve(std::size_t zones);

    /// Labels the zones at `slots`, at most `most_zones`, of a buffer of occupied planes. Waits for
    /// the counts.
    void dispatch(const device::Buffer& occupied_planes, std::span<const std::uint32_t> slots);

    /// Of the last dispatch: zones in its order, and all their pieces, zone after zone.
    [[nodiscard]] std::span<const LabelledZone> zones() const { return zones_; }
    [[nodiscard]] std::span<const LabelledPiece> pieces() const { return pieces_; }

    /// Waits. Zone after zone: numbers in the first and last layer of x, of y and of z, 0 for cells
    /// that are not occupied; a layer is ordered by the two other axes, the lesser first.
    [[nodiscard]] std::vector<std::uint16_t> layers() const;

    /// On the device: each cell's number as a word, zone after zone; LabelledPieces.
    [[nodiscard]] const device::Buffer& number_buffer() const { return numbers_.get(); }
    [[nodiscard]] const device::Buffer& piece_buffer() const { return piece_buffer_.get(); }
    [[nodiscard]] const ZoneLayout& layout() const { return layout_; }
    [[nodiscard]] std::int32_t zone_edge() const { return zone_edge_; }

private:
    device::Device& device_;
    std::int32_t zone_edge_;
    ZoneLayout layout_;
    device::Kernel kernel_;
    GrowingBuffer slots_;
    GrowingBuffer parents_;
    GrowingBuffer numbers_;
    GrowingBuffer layers_;
    GrowingBuffer counts_;
    GrowingBuffer piece_buffer_;
    std::vector<LabelledZone> zones_;
    std::vector<LabelledPiece> pieces_;
};

} // namespace zonegrid::ops
