#pragma once

#include "device/device.h"
#include "ops/growing_buffer.h"
#include "ops/zone_layout.h"

#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid::ops {

/// A zone to profile.
struct ProfiledZone {
    std::uint32_t slot = 0;
    std::uint32_t first_layer = 0; ///< cells above it, with a lesser z in the zone, are left out
};

/// The highest occupied cells of zones on a device (docs/model.md, section 9).
class ProfileHeights {
public:
    /// In place of the height of a column without a cell.
    static constexpr std::uint8_t no_height = 255;

    /// `device` lives longer.
    ProfileHeights(device::Device& device, std::int32_t zone_edge,
                   std::uint32_t group_items = device::default_group_items);

    /// Takes memory for so many zones. Throws CapacityError if there is none.
    void reserve(std::size_t zones);

    /// Profiles zones of a buffer of occupied planes, without waiting.
    void dispatch(const device::Buffer& occupied_planes, std::span<const ProfiledZone> zones);

    /// Waits. Zone after zone, columns in the order [y][x]: least z within the zone, or
    /// `no_height`.
    [[nodiscard]] std::vector<std::uint8_t> heights() const;

private:
    device::Device& device_;
    std::int32_t zone_edge_;
    device::Kernel kernel_;
    GrowingBuffer zones_;
    GrowingBuffer heights_;
    std::size_t zone_count_ = 0;
};

} // namespace zonegrid::ops
