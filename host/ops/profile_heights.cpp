#include "ops/profile_heights.h"

#include "kernels/params/profile_heights.h"

#include <array>
#include <bit>

namespace zonegrid::ops {

using params::ProfileHeightsParams;
static_assert(sizeof(ProfiledZone) == 8); // the kernel reads two words

namespace {

std::size_t columns(std::int32_t zone_edge) {
    return static_cast<std::size_t>(zone_edge) * static_cast<std::size_t>(zone_edge);
}

} // namespace

ProfileHeights::ProfileHeights(device::Device& device, std::int32_t zone_edge,
                               std::uint32_t group_items)
    : device_(device),
      zone_edge_(zone_edge),
      kernel_(device.make_kernel(
          {"profile_heights", "profile_heights", 3, sizeof(ProfileHeightsParams), group_items})),
      zones_(device),
      heights_(device) {}

void ProfileHeights::reserve(std::size_t zones) {
    zones_.reserve(zones * sizeof(ProfiledZone));
    heights_.reserve(zones * columns(zone_edge_));
}

void ProfileHeights::dispatch(const device::Buffer& occupied_planes,
                              std::span<const ProfiledZone> zones) {
    zone_count_ = zones.size();
    const std::array<const device::Buffer*, 3> bindings{
        &occupied_planes, &zones_.upload(zones),
        &heights_.reserve(zone_count_ * columns(zone_edge_))};
    const ProfileHeightsParams params{static_cast<std::uint32_t>(zone_count_),
                                      std::countr_zero(static_cast<std::uint32_t>(zone_edge_))};
    if (zone_count_ > 0) {
        device_.dispatch(kernel_, bindings, std::as_bytes(std::span(&params, 1)), params.zones);
    }
}

std::vector<std::uint8_t> ProfileHeights::heights() const {
    std::vector<std::uint8_t> heights(zone_count_ * columns(zone_edge_));
    heights_.download(std::span(heights));
    return heights;
}

} // namespace zonegrid::ops
