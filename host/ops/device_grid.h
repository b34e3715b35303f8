#pragma once

#include "device/device.h"
#include "ops/zone_layout.h"

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace zonegrid::ops {

/// Memory for the grid's zones on a device: values, and the bit plane of the occupied cells. Zones
/// lie in slots, slots in chunks, each of which fits into the device's buffers.
class DeviceGrid {
public:
    struct Slot {
        std::uint32_t chunk = 0;
        std::uint32_t index = 0; ///< in the chunk
    };

    struct Chunk {
        device::Buffer cells;
        device::Buffer occupied_planes;
    };

    /// What the values of a chunk's zones take at most.
    static constexpr std::uint64_t chunk_bytes = std::uint64_t{16} << 20U;

    /// `device` lives longer.
    DeviceGrid(device::Device& device, std::int32_t zone_edge);

    /// A slot with all cells 0. Throws CapacityError, and changes nothing, if the device has no
    /// more memory.
    [[nodiscard]] Slot take();
    void give_back(const Slot& slot) { free_.push_back(slot); }

    [[nodiscard]] std::uint32_t chunk_count() const {
        return static_cast<std::uint32_t>(chunks_.size());
    }
    [[nodiscard]] Chunk& chunk(std::uint32_t index) { return chunks_[index]; }

    /// Waits; copies a zone's values, order [z][y][x], or the words of its occupied plane.
    void download_values(const Slot& slot, std::span<std::int8_t> values);
    void download_occupied(const Slot& slot, std::span<std::uint32_t> words);

private:
    void add_chunk();

    device::Device& device_;
    ZoneLayout layout_;
    std::uint32_t chunk_zones_;
    std::deque<Chunk> chunks_; ///< never moved: buffers are bound by reference
    std::vector<Slot> free_;
};

} // namespace zonegrid::ops
