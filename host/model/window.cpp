#include "model/window.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <cmath>

namespace zonegrid {

namespace {

/// One axis of `Window::move_to`.
std::int32_t first_zone_on_axis(std::int32_t cell, std::int32_t reach, std::int32_t zone_edge,
                                std::int32_t zones, std::int32_t first, bool placed) {
    const std::int32_t low = floor_div(cell - reach, zone_edge);
    const std::int32_t high = floor_div(cell + reach, zone_edge);
    if (!placed || low < first) {
        return low;
    }
    return high > first + zones - 1 ? high - zones + 1 : first;
}

} // namespace

bool Window::move_to(const CellIndex& sensor_cell) {
    const auto axis = [this](std::int32_t cell, std::int32_t first) {
        return first_zone_on_axis(cell, reach_cells_, zone_edge_, zones_per_axis_, first, placed_);
    };
    const ZoneIndex first{axis(sensor_cell.x, first_.x), axis(sensor_cell.y, first_.y),
                          axis(sensor_cell.z, first_.z)};
    const bool moved = !placed_ || first != first_;
    first_ = first;
    placed_ = true;
    return moved;
}

Window make_window(const MapperOptions& options, const std::optional<Camera>& camera) {
    // A sub-ray leaves its pixel's centre by up to half a pixel.
    const double stretch = camera ? 1.0 + 0.5 / camera->fx_px + 0.5 / camera->fy_px : 1.0;
    const double reach_m = options.range_m * stretch;
    const double reach = std::floor(reach_m / options.cell_m) + 2.0;
    const double zones = std::ceil(2.0 * reach / options.zone) + 2.0;
    if (zones * options.zone > ZG_MAX_WINDOW_CELLS) {
        const int zones_most = ZG_MAX_WINDOW_CELLS / options.zone;
        const int reach_most = (zones_most - 2) * options.zone / 2 - 2;
        throw CapacityError(
            fmt::format("cell {} m and range {} m need a window of {:.0f} cells an axis, more than "
                        "{}; use a cell "
                        "of {:.4g} m or more, or a range of {:.4g} m or less",
                        options.cell_m, options.range_m, zones * options.zone, ZG_MAX_WINDOW_CELLS,
                        std::ceil(reach_m / reach_most * 1e4) / 1e4,
                        std::floor(reach_most * options.cell_m / stretch * 1e3) / 1e3));
    }
    return {options.zone, static_cast<std::int32_t>(zones), static_cast<std::int32_t>(reach)};
}

} // namespace zonegrid
