#include "pipeline/device_engine.h"

#include "ops/reached_zones.h"
#include "pipeline/device_memory.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace zonegrid {

namespace {

device::DeviceOptions device_options(const MapperOptions& options) {
    device::DeviceOptions chosen;
    chosen.memory_limit_bytes = options.device_memory_bytes;
    chosen.unified_memory = options.device_shared_memory;
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
      label_components_(*device_, options.zone),
      measure_objects_(*device_),
      encode_octree_(*device_),
      encode_prism_(*device_),
      profile_heights_(*device_, options.zone),
      tracker_(options.zone),
      values_(ops::ZoneLayout(options.zone).zone_cells) {
    // What the objects of one zone need is taken first, so that there are objects wherever there is
    // a map.
    take_memory([&] {
        const std::size_t cells = values_.size();
        label_components_.reserve(1);
        measure_objects_.reserve(1, cells / 2);
        encode_octree_.reserve(cells / 2, cells, options.zone);
        encode_prism_.reserve(cells / 2, cells, options.zone);
        profile_heights_.reserve(1);
    });
}

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
    drawn_ = false;
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
    view_ = rays.view;
    drawn_ = true;
}

void DeviceEngine::integrate_scan(const ScanRays& scan) {
    reserve(ops::reached_zones(scan, window_));
    take_memory([&] { integrate_scan_.dispatch(scan, local_map_); });
    local_map_.check();
    view_ = {};
    drawn_ = true;
}

void DeviceEngine::reserve(std::vector<std::uint32_t> places) {
    reserved_ = std::move(places);
    drawn_ = false;
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
    std::ranges::sort(result.values_changed);
    std::ranges::sort(result.occupancy_changed);
    note_held();
    return result;
}

void DeviceEngine::fuse_chunk(std::uint32_t chunk, std::span<const std::size_t> reserved,
                              FusionResult& result) {
    std::vector<ops::ZonePair> pairs;
    pairs.reserve(reserved.size());
    for (const auto i : reserved) {
        pairs.push_back({ops::DeviceLocalMap::slot_of(i), slots_.at(reserved_[i]).index,
                         ops::zone_in_window(window_, reserved_[i])});
    }
    auto& buffers = grid_.chunk(chunk);
    fuse_local_map_.dispatch({local_map_.planes(), buffers.cells, buffers.occupied_planes}, view_,
                             pairs);
    const auto changes = fuse_local_map_.changes();
    for (std::size_t n = 0; n < changes.size(); ++n) {
        const auto place = reserved_[reserved[n]];
        result.cells_changed += changes[n].values_changed;
        if (changes[n].values_changed != 0) {
            result.values_changed.push_back(place);
        }
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

void DeviceEngine::visit_local_map(
    const std::function<void(std::uint32_t, std::span<const std::uint8_t>)>& visit) {
    if (!drawn_) {
        return;
    }
    std::map<std::uint32_t, std::size_t> by_place;
    for (std::size_t i = 0; i < reserved_.size(); ++i) {
        by_place.emplace(reserved_[i], i);
    }
    std::vector<std::uint8_t> statements(values_.size());
    for (const auto& [place, i] : by_place) {
        local_map_.download_zone(i, statements);
        if (std::ranges::any_of(statements, [](auto statement) { return statement != 0; })) {
            visit(place, statements);
        }
    }
}

void DeviceEngine::track(std::span<const ZoneIndex> changed) {
    std::vector<std::vector<ZoneIndex>> by_chunk(grid_.chunk_count());
    for (const auto& zone : changed) {
        by_chunk[slots_.at(window_.place_of(zone)).chunk].push_back(zone);
    }
    for (std::uint32_t chunk = 0; chunk < by_chunk.size(); ++chunk) {
        std::span<const ZoneIndex> zones(by_chunk[chunk]);
        while (!zones.empty()) {
            const auto batch = zones.first(std::min(zones.size(), zones_at_once()));
            take_memory([&] { track_in(grid_.chunk(chunk), batch); });
            zones = zones.subspan(batch.size());
        }
    }
}

std::size_t DeviceEngine::zones_at_once() const {
    const auto room = device_->spare_bytes() / object_bytes_at_most(window_.zone_edge());
    return std::clamp<std::size_t>(room, 1, ops::LabelComponents::most_zones);
}

void DeviceEngine::track_in(ops::DeviceGrid::Chunk& chunk, std::span<const ZoneIndex> zones) {
    std::vector<std::uint32_t> slots;
    for (const auto& zone : zones) {
        slots.push_back(slots_.at(window_.place_of(zone)).index);
    }
    label_components_.dispatch(chunk.occupied_planes, slots);
    measure_objects_.dispatch(label_components_);
    encode_octree_.dispatch(label_components_, measure_objects_);
    encode_prism_.dispatch(label_components_, measure_objects_);
    const auto layers = label_components_.layers();
    const auto measures = measure_objects_.measures();
    auto octrees = encode_octree_.trees();
    auto prisms = encode_prism_.trees();

    const auto zone_edge = static_cast<std::size_t>(window_.zone_edge());
    const std::size_t layer_cells = zone_edge * zone_edge;
    std::size_t piece = 0;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const CellIndex first = first_cell_of(zones[i], window_.zone_edge());
        const auto in_world = [&first](const CellIndex& cell) {
            return CellIndex{first.x + cell.x, first.y + cell.y, first.z + cell.z};
        };
        ZoneSummary summary;
        for (auto left = label_components_.zones()[i].pieces; left > 0; --left, ++piece) {
            const auto& measure = measures[piece];
            const std::int64_t cells = measure.cell_count;
            summary.pieces.push_back(
                {in_world(measure.least),
                 measure.cell_count,
                 in_world(measure.box_min),
                 in_world(measure.box_max),
                 {measure.cell_sum[0] + cells * first.x, measure.cell_sum[1] + cells * first.y,
                  measure.cell_sum[2] + cells * first.z},
                 std::move(octrees[piece]),
                 std::move(prisms[piece])});
        }
        auto numbers = std::span(layers).subspan(6 * layer_cells * i);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (auto* layer : {&summary.first_layer[axis], &summary.last_layer[axis]}) {
                *layer = border_layer(numbers.first(layer_cells));
                numbers = numbers.subspan(layer_cells);
            }
        }
        tracker_.set_zone(zones[i], std::move(summary));
    }
}

std::vector<ProfileColumn> DeviceEngine::profile_heights(std::int32_t z_least) {
    const std::int32_t edge = window_.zone_edge();
    std::vector<std::vector<std::pair<CellIndex, ops::ProfiledZone>>> by_chunk(grid_.chunk_count());
    for (const auto& [place, slot] : slots_) {
        const CellIndex first = first_cell_of(window_.zone_at(place), edge);
        const std::int64_t left_out = std::int64_t{z_least} - first.z;
        if (left_out < edge) {
            by_chunk[slot.chunk].push_back(
                {first,
                 {slot.index, static_cast<std::uint32_t>(std::max<std::int64_t>(left_out, 0))}});
        }
    }
    Columns columns;
    for (std::uint32_t chunk = 0; chunk < by_chunk.size(); ++chunk) {
        std::span zones(std::as_const(by_chunk[chunk]));
        while (!zones.empty()) {
            const auto batch = zones.first(std::min(zones.size(), zones_at_once()));
            take_memory([&] { profile_in(grid_.chunk(chunk), batch, columns); });
            zones = zones.subspan(batch.size());
        }
    }
    std::vector<ProfileColumn> result;
    result.reserve(columns.size());
    for (const auto& [column, z] : columns) {
        result.push_back({column.first, column.second, z});
    }
    return result;
}

void DeviceEngine::profile_in(ops::DeviceGrid::Chunk& chunk,
                              std::span<const std::pair<CellIndex, ops::ProfiledZone>> zones,
                              Columns& columns) {
    std::vector<ops::ProfiledZone> profiled;
    for (const auto& [first, zone] : zones) {
        profiled.push_back(zone);
    }
    profile_heights_.dispatch(chunk.occupied_planes, profiled);
    const auto heights = profile_heights_.heights();
    const std::int32_t edge = window_.zone_edge();
    const std::size_t zone_columns =
        static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (heights[i] == ops::ProfileHeights::no_height) {
            continue;
        }
        const CellIndex& first = zones[i / zone_columns].first;
        const auto column = static_cast<std::int32_t>(i % zone_columns);
        const std::int32_t z = first.z + heights[i];
        const auto [found, entered] =
            columns.try_emplace({first.x + column % edge, first.y + column / edge}, z);
        found->second = std::min(found->second, z);
    }
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
