#include "pipeline/device_engine.h"

#include "ops/reached_zones.h"
#include "pipeline/device_memory.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace zonegrid {

namespace {

device::DeviceOptions device_options(const MapperOptions& options) {
    device::DeviceOptions chosen;
    chosen.memory_limit_bytes = options.device_memory_bytes;
    return chosen;
}

double megabytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / (1U << 20U);
}

} // namespace

template <class Step>
auto DeviceEngine::take_memory(const Step& step) const {
    try {
        return step();
    } catch (const CapacityError& error) {
        const auto pixels = camera_ ? static_cast<std::uint64_t>(camera_->width_px) *
                                          static_cast<std::uint64_t>(camera_->height_px)
                                    : 0;
        // Without a limit, what the driver gave so far is what there is.
        const auto available = options_.device_memory_bytes != 0 ? options_.device_memory_bytes
                                                                 : device_->held_bytes();
        const auto range_m = longest_range_m(options_, camera_, available);
        throw CapacityError(fmt::format(
            "{}; {:.1f} MB surely hold {} of {:g} m cells, {:.1f} MB hold the range of {:g} m: "
            "choose a shorter range or larger cells, or let it take more memory",
            error.what(), megabytes(available),
            range_m ? fmt::format("a range of {:g} m", *range_m) : "no range", options_.cell_m,
            megabytes(device_bytes_at_most(window_, pixels)), options_.range_m));
    }
}

DeviceEngine::DeviceEngine(const MapperOptions& options, const std::optional<Camera>& camera,
                           const Window& window)
    : options_(options),
      camera_(camera),
      window_(window),
      device_(device::open_device(options.backend, device_options(options))),
      grid_(*device_, options.zone),
      local_map_(take_memory([&] { return ops::DeviceLocalMap(*device_, window); })),
      integrate_image_(*device_),
      integrate_scan_(*device_),
      fuse_local_map_(*device_, options.zone, FusionRule(options)),
      draw_objects_(*device_, options.zone, FusionRule(options)),
      values_(ops::ZoneLayout(options.zone).zone_cells) {}

void DeviceEngine::move_to(const Window& window,
                           const std::function<void(const ZoneIndex&, const ZoneBits&)>& leave) {
    std::map<std::uint32_t, Slot> slots;
    for (const auto& [place, slot] : slots_) {
        const ZoneIndex zone = window_.zone_at(place);
        if (window.holds(zone)) {
            slots.emplace(window.place_of(zone), slot);
        } else {
            leave(zone, occupied_in(slot));
            grid_.give_back(slot);
        }
    }
    slots_ = std::move(slots);
    window_ = window;
    note_held();
}

void DeviceEngine::draw_objects(const ZoneIndex& zone, std::span<const CellIndex> cells) {
    const Slot slot = take_memory([&] { return grid_.take(); });
    auto& chunk = grid_.chunk(slot.chunk);
    try {
        take_memory(
            [&] { draw_objects_.dispatch(cells, slot.index, chunk.cells, chunk.occupied_planes); });
    } catch (const CapacityError&) {
        grid_.give_back(slot);
        throw;
    }
    slots_.emplace(window_.place_of(zone), slot);
    note_held();
}

void DeviceEngine::integrate_image(const ImageRays& rays) {
    reserve(ops::reached_zones(rays, window_));
    take_memory([&] { integrate_image_.dispatch(rays, local_map_); });
    local_map_.check();
}

void DeviceEngine::integrate_scan(const ScanRays& scan) {
    reserve(ops::reached_zones(scan, window_));
    take_memory([&] { integrate_scan_.dispatch(scan, local_map_); });
    local_map_.check();
}

void DeviceEngine::reserve(std::vector<std::uint32_t> places) {
    reserved_ = std::move(places);
    take_memory([&] { local_map_.reserve(reserved_); });
}

void DeviceEngine::take_slots() {
    std::vector<std::uint32_t> taken;
    try {
        take_memory([&] {
            for (const auto place : reserved_) {
                if (!slots_.contains(place)) {
                    slots_.emplace(place, grid_.take());
                    taken.push_back(place);
                }
            }
            fuse_local_map_.reserve(reserved_.size());
        });
    } catch (const CapacityError&) {
        for (const auto place : taken) {
            grid_.give_back(slots_.at(place));
            slots_.erase(place);
        }
        throw;
    }
}

FusionResult DeviceEngine::fuse_local_map() {
    take_slots(); // all memory that fusion needs, before it changes a cell
    std::vector<std::vector<std::size_t>> by_chunk(grid_.chunk_count());
    for (std::size_t i = 0; i < reserved_.size(); ++i) {
        by_chunk[slots_.at(reserved_[i]).chunk].push_back(i);
    }
    FusionResult result;
    for (std::uint32_t chunk = 0; chunk < by_chunk.size(); ++chunk) {
        fuse_chunk(chunk, by_chunk[chunk], result);
    }
    std::ranges::sort(result.occupancy_changed);
    note_held();
    return result;
}

void DeviceEngine::fuse_chunk(std::uint32_t chunk, std::span<const std::size_t> reserved,
                              FusionResult& result) {
    std::vector<ops::ZonePair> pairs;
    pairs.reserve(reserved.size());
    for (const auto i : reserved) {
        pairs.push_back({ops::DeviceLocalMap::slot_of(i), slots_.at(reserved_[i]).index});
    }
    auto& buffers = grid_.chunk(chunk);
    fuse_local_map_.dispatch({local_map_.planes(), buffers.cells, buffers.occupied_planes}, pairs);
    const auto changes = fuse_local_map_.changes();
    for (std::size_t n = 0; n < changes.size(); ++n) {
        const auto place = reserved_[reserved[n]];
        result.cells_changed += changes[n].values_changed;
        if (changes[n].occupancies_changed != 0) {
            result.occupancy_changed.push_back(place);
        }
        // More zones are reserved than rays enter. One of which nothing was ever said holds none.
        if (changes[n].cells_stated == 0 && !std::ranges::binary_search(held_, place)) {
            grid_.give_back(slots_.at(place));
            slots_.erase(place);
        }
    }
}

ZoneBits DeviceEngine::occupied(std::uint32_t place) {
    return occupied_in(slots_.at(place));
}

ZoneBits DeviceEngine::occupied_in(const Slot& slot) {
    ZoneBits bits(window_.zone_edge());
    grid_.download_occupied(slot, bits.words());
    return bits;
}

std::span<const std::int8_t> DeviceEngine::values(std::uint32_t place) {
    grid_.download_values(slots_.at(place), values_);
    return values_;
}

void DeviceEngine::note_held() {
    held_.clear();
    for (const auto& [place, slot] : slots_) {
        held_.push_back(place);
    }
}

} // namespace zonegrid
