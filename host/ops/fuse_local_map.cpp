#include "ops/fuse_local_map.h"

#include "kernels/params/fuse_local_map.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace zonegrid::ops {

namespace {

using params::FuseLocalMapParams;
static_assert(sizeof(FuseLocalMapParams) <= device::max_params_bytes);

// The kernel reads and writes these as three words.
static_assert(sizeof(ZonePair) == 12 && sizeof(ZoneChange) == 12);

device::KernelSpec kernel_spec(std::uint32_t group_items) {
    return {"fuse_local_map", "fuse_local_map", 5, sizeof(FuseLocalMapParams), group_items};
}

void require_slot(std::uint32_t slot, std::uint64_t zone_bytes, const device::Buffer& buffer,
                  const char* name) {
    if (slot >= buffer.bytes() / zone_bytes) {
        throw UsageError(fmt::format("{} slot {}: the buffer of {} bytes holds {} zones", name,
                                     slot, buffer.bytes(), buffer.bytes() / zone_bytes));
    }
}

void set_view(const View& view, FuseLocalMapParams& params) {
    params.view_bounded = view.bounded ? 1 : 0;
    for (std::size_t i = 0; i < view.sides.size(); ++i) {
        params.view_side_x[i] = view.sides[i].x;
        params.view_side_y[i] = view.sides[i].y;
        params.view_side_z[i] = view.sides[i].z;
    }
    params.view_centre[0] = view.centre.x;
    params.view_centre[1] = view.centre.y;
    params.view_centre[2] = view.centre.z;
    params.view_radius = view.radius;
}

} // namespace

std::uint32_t zone_in_window(const Window& window, std::uint32_t place) {
    const auto zones = static_cast<std::uint32_t>(window.zones_per_axis());
    return place % zones | place / zones % zones << 8U | place / (zones * zones) << 16U;
}

FuseLocalMap::FuseLocalMap(device::Device& device, std::int32_t zone_edge, const FusionRule& rule,
                           std::uint32_t group_items)
    : device_(device),
      layout_(zone_edge),
      zone_bits_(
          static_cast<std::uint32_t>(std::countr_zero(static_cast<std::uint32_t>(zone_edge)))),
      rule_(rule),
      kernel_(device.make_kernel(kernel_spec(group_items))),
      pairs_(device),
      changes_(device) {}

void FuseLocalMap::dispatch(const FusionBuffers& buffers, const View& view,
                            std::span<const ZonePair> pairs) {
    check(buffers, pairs);
    pair_count_ = pairs.size();
    if (pairs.empty()) {
        return;
    }
    FuseLocalMapParams params{};
    params.pair_count = static_cast<std::uint32_t>(pairs.size());
    params.plane_words = layout_.plane_words();
    params.hit = rule_.hit;
    params.miss = rule_.miss;
    params.limit = rule_.limit;
    params.threshold = rule_.threshold;
    params.zone_bits = zone_bits_;
    set_view(view, params);
    const std::array<const device::Buffer*, 5> bindings{
        &buffers.local_planes, &buffers.grid_cells, &buffers.occupied_planes, &pairs_.upload(pairs),
        &changes_.reserve(pairs.size() * sizeof(ZoneChange))};
    device_.dispatch(kernel_, bindings, std::as_bytes(std::span(&params, 1)), params.pair_count);
}

std::vector<ZoneChange> FuseLocalMap::changes() {
    std::vector<ZoneChange> changes(pair_count_);
    changes_.download(std::span(changes));
    return changes;
}

void FuseLocalMap::check(const FusionBuffers& buffers, std::span<const ZonePair> pairs) const {
    constexpr std::uint64_t most_words = std::numeric_limits<std::uint32_t>::max();
    const std::array<const device::Buffer*, 3> all{&buffers.local_planes, &buffers.grid_cells,
                                                   &buffers.occupied_planes};
    for (const auto* buffer : all) {
        if (buffer->bytes() / 4 > most_words) {
            throw CapacityError(
                fmt::format("a buffer of {} bytes: fusion reaches {} words, so split it",
                            buffer->bytes(), most_words));
        }
    }
    std::vector<std::uint32_t> grid_slots;
    grid_slots.reserve(pairs.size());
    for (const auto& pair : pairs) {
        require_slot(pair.local_slot, layout_.local_bytes(), buffers.local_planes, "local map's");
        require_slot(pair.grid_slot, layout_.grid_bytes(), buffers.grid_cells, "grid's");
        require_slot(pair.grid_slot, layout_.plane_bytes(), buffers.occupied_planes,
                     "occupied plane's");
        grid_slots.push_back(pair.grid_slot);
    }
    std::ranges::sort(grid_slots);
    const auto twice = std::ranges::adjacent_find(grid_slots);
    if (twice != grid_slots.end()) {
        throw UsageError(
            fmt::format("grid's slot {} stands in two pairs: fuse one local map a zone", *twice));
    }
}

void FuseLocalMap::reserve(std::size_t pairs) {
    pairs_.reserve(pairs * sizeof(ZonePair));
    changes_.reserve(pairs * sizeof(ZoneChange));
}

} // namespace zonegrid::ops
