#include "pipeline/device_memory.h"

#include "ops/device_grid.h"

#include <algorithm>
#include <cmath>

namespace zonegrid {

std::uint64_t object_bytes_at_most(std::int32_t zone_edge) {
    // A cell's parent and number 8; half as many pieces as cells, of 68 bytes (place, measure, two
    // trees' places and beginnings); nodes of at most five levels 15; outer layers and profile less
    // than 2.
    constexpr std::uint64_t cell_bytes = 64;
    return cell_bytes * ops::ZoneLayout(zone_edge).zone_cells;
}

std::uint64_t device_bytes_at_most(const Window& window, std::uint64_t pixels) {
    const ops::ZoneLayout layout(window.zone_edge());
    const std::uint64_t zones = window.zone_count();
    const std::uint64_t tables = 3 * sizeof(std::uint32_t) * zones;
    const std::uint64_t local_map = 2 * (zones + 1) * layout.local_bytes(); // doubled as it grows
    const std::uint64_t grid = zones * (layout.grid_bytes() + layout.plane_bytes());
    const std::uint64_t fusion = zones * sizeof(std::uint32_t) * 2 * 5; // doubled: pair, change
    const std::uint64_t remembered = layout.zone_cells * sizeof(std::uint32_t);
    const std::uint64_t objects = object_bytes_at_most(window.zone_edge());
    // Depths 8, directions 12, windows at most 10, skips less than 1.
    constexpr std::uint64_t pixel_bytes = 32;
    const auto used =
        tables + local_map + grid + fusion + remembered + objects + pixel_bytes * pixels;
    // The grid's last chunk may be all but empty: values and planes, of a sixteenth of the memory.
    return used + std::min(ops::DeviceGrid::chunk_bytes / 8 * 9, used * 9 / (8 * 16 - 9) + 1);
}

std::optional<double> longest_range_m(const MapperOptions& options,
                                      const std::optional<Camera>& camera, std::uint64_t bytes) {
    const std::uint64_t pixels = camera ? static_cast<std::uint64_t>(camera->width_px) *
                                              static_cast<std::uint64_t>(camera->height_px)
                                        : 0;
    // Cell by cell: the window grows by whole zones, at most 2048 cells.
    MapperOptions shorter = options;
    for (double cells = std::ceil(options.range_m / options.cell_m) - 1.0; cells >= 1.0; --cells) {
        shorter.range_m = cells * options.cell_m;
        if (device_bytes_at_most(make_window(shorter, camera), pixels) <= bytes) {
            return shorter.range_m;
        }
    }
    return std::nullopt;
}

} // namespace zonegrid
