#include "ops/device_grid.h"

#include <algorithm>

namespace zonegrid::ops {

// Chunks are small enough not to waste much, and large enough for few dispatches.
DeviceGrid::DeviceGrid(device::Device& device, std::int32_t zone_edge)
    : device_(device),
      layout_(zone_edge),
      chunk_zones_(static_cast<std::uint32_t>(std::max<std::uint64_t>(
          std::min({chunk_bytes, device.info().limits.buffer_bytes, device.spare_bytes() / 16}) /
              layout_.grid_bytes(),
          1))) {}

DeviceGrid::Slot DeviceGrid::take() {
    if (free_.empty()) {
        add_chunk();
    }
    const Slot slot = free_.back();
    Chunk& chunk = chunks_[slot.chunk];
    device_.fill(chunk.cells, slot.index * layout_.grid_bytes(), layout_.grid_bytes(), 0);
    device_.fill(chunk.occupied_planes, slot.index * layout_.plane_bytes(), layout_.plane_bytes(),
                 0);
    free_.pop_back();
    return slot;
}

void DeviceGrid::download_values(const Slot& slot, std::span<std::int8_t> values) {
    device_.download(chunks_[slot.chunk].cells, slot.index * layout_.grid_bytes(),
                     std::as_writable_bytes(values));
}

void DeviceGrid::download_occupied(const Slot& slot, std::span<std::uint32_t> words) {
    device_.download(chunks_[slot.chunk].occupied_planes, slot.index * layout_.plane_bytes(),
                     std::as_writable_bytes(words));
}

void DeviceGrid::add_chunk() {
    const auto chunk = chunk_count();
    chunks_.push_back({device_.make_buffer(chunk_zones_ * layout_.grid_bytes()),
                       device_.make_buffer(chunk_zones_ * layout_.plane_bytes())});
    for (std::uint32_t index = chunk_zones_; index > 0; --index) {
        free_.push_back({chunk, index - 1});
    }
}

} // namespace zonegrid::ops
