#include "ops/device_local_map.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace zonegrid::ops {

DeviceLocalMap::DeviceLocalMap(device::Device& device, const Window& window)
    : device_(device),
      layout_(window.zone_edge()),
      params_{std::countr_zero(static_cast<std::uint32_t>(window.zone_edge())),
              window.zones_per_axis(), layout_.plane_words()},
      slots_(device.make_buffer(window.zone_count() * sizeof(std::uint32_t))),
      places_(device.make_buffer(window.zone_count() * sizeof(std::uint32_t))),
      faults_(device.make_buffer(sizeof(std::uint32_t))),
      table_(window.zone_count()) {
    device_.fill(faults_, 0, faults_.bytes(), 0);
    reserve({});
}

void DeviceLocalMap::reserve(std::span<const std::uint32_t> places) {
    const std::uint64_t bytes = (places.size() + 1) * layout_.local_bytes();
    const std::uint64_t most = device_.info().limits.buffer_bytes;
    if (bytes > most) {
        throw CapacityError(
            fmt::format("an image reaches {} zones, {} MB of local map; a buffer of {} holds "
                        "{} MB: choose larger cells or a shorter range",
                        places.size(), bytes >> 20U, device_.info().id(), most >> 20U));
    }
    if (!planes_ || planes_->bytes() < bytes) {
        // Twice what is needed, so that a growing map does not come here every image; but not where
        // memory is scarce, which the grid needs too.
        planes_.reset();
        const auto ample = std::min(2 * bytes, most);
        planes_.emplace(device_.make_buffer(ample <= device_.spare_bytes() / 4 ? ample : bytes));
    }
    device_.fill(*planes_, 0, bytes, 0);
    std::ranges::fill(table_, 0U);
    for (std::size_t i = 0; i < places.size(); ++i) {
        table_[places[i]] = slot_of(i);
    }
    device_.upload(slots_, 0, std::as_bytes(std::span(table_)));
    zone_count_ = static_cast<std::uint32_t>(places.size());
    if (!places.empty()) {
        device_.upload(places_, 0, std::as_bytes(places));
    }
}

void DeviceLocalMap::download_zone(std::size_t i, std::span<std::uint8_t> statements) const {
    const std::size_t plane = layout_.plane_words();
    std::vector<std::uint32_t> planes(2 * plane);
    device_.download(*planes_, slot_of(i) * layout_.local_bytes(),
                     std::as_writable_bytes(std::span(planes)));
    for (std::size_t cell = 0; cell < statements.size(); ++cell) {
        const auto says = [&](std::size_t first) {
            return (planes[first + cell / 32] >> (cell % 32) & 1U) != 0;
        };
        statements[cell] = says(plane) ? ZG_STATEMENT_OCCUPIED
                           : says(0)   ? ZG_STATEMENT_FREE
                                       : ZG_STATEMENT_NOTHING;
    }
}

void DeviceLocalMap::check() {
    std::uint32_t faults = 0;
    device_.download(faults_, 0, std::as_writable_bytes(std::span(&faults, 1)));
    if (faults != 0) {
        throw std::logic_error(
            fmt::format("{}: rays entered zones that were not reserved, {} times: the map on it "
                        "cannot be trusted; please report this recording",
                        device_.info().id(), faults));
    }
}

} // namespace zonegrid::ops
