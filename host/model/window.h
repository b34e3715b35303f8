#pragma once

#include "model/lattice.h"
#include "zonegrid/options.h"
#include "zonegrid/sensors.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace zonegrid {

/// The zones that exist now: a cube of `zones_per_axis` zones an edge (docs/model.md, section 6).
class Window {
public:
    /// `reach_cells`: how far from the sensor's cell a statement can lie, on any axis.
    Window(std::int32_t zone_edge, std::int32_t zones_per_axis, std::int32_t reach_cells)
        : zone_edge_(zone_edge), zones_per_axis_(zones_per_axis), reach_cells_(reach_cells) {}

    [[nodiscard]] std::int32_t zone_edge() const { return zone_edge_; }
    [[nodiscard]] std::int32_t zones_per_axis() const { return zones_per_axis_; }
    [[nodiscard]] std::int32_t edge_cells() const { return zones_per_axis_ * zone_edge_; }
    [[nodiscard]] std::size_t zone_count() const {
        const auto axis = static_cast<std::size_t>(zones_per_axis_);
        return axis * axis * axis;
    }
    [[nodiscard]] const ZoneIndex& first_zone() const { return first_; }
    [[nodiscard]] CellIndex first_cell() const { return first_cell_of(first_, zone_edge_); }
    [[nodiscard]] bool placed() const { return placed_; }

    /// Moves the window so that it holds everything within reach of the sensor's cell, by as few
    /// zones as possible. Returns whether it moved (placing it the first time counts).
    bool move_to(const CellIndex& sensor_cell);

    [[nodiscard]] bool holds(const ZoneIndex& zone) const {
        const auto inside = [this](std::int32_t z, std::int32_t first) {
            return z >= first && z - first < zones_per_axis_;
        };
        return placed_ && inside(zone.x, first_.x) && inside(zone.y, first_.y) &&
               inside(zone.z, first_.z);
    }

    /// Place of a zone in a table over the window, order [z][y][x]; the zone is in the window.
    [[nodiscard]] std::uint32_t place_of(const ZoneIndex& zone) const {
        return static_cast<std::uint32_t>(
            ((zone.z - first_.z) * zones_per_axis_ + (zone.y - first_.y)) * zones_per_axis_ +
            (zone.x - first_.x));
    }

    /// Inverse of `place_of`.
    [[nodiscard]] ZoneIndex zone_at(std::uint32_t place) const {
        const auto p = static_cast<std::int32_t>(place);
        return {first_.x + p % zones_per_axis_, first_.y + p / zones_per_axis_ % zones_per_axis_,
                first_.z + p / (zones_per_axis_ * zones_per_axis_)};
    }

    /// First cell of the zone at a place, relative to the window's first cell.
    [[nodiscard]] CellIndex first_cell_at(std::uint32_t place) const {
        const auto p = static_cast<std::int32_t>(place);
        return {p % zones_per_axis_ * zone_edge_,
                p / zones_per_axis_ % zones_per_axis_ * zone_edge_,
                p / (zones_per_axis_ * zones_per_axis_) * zone_edge_};
    }

private:
    std::int32_t zone_edge_;
    std::int32_t zones_per_axis_;
    std::int32_t reach_cells_;
    ZoneIndex first_;
    bool placed_ = false;
};

/// The window for these options and this camera (none: a scanner).
/// Throws CapacityError if it would need more than 2048 cells an axis.
[[nodiscard]] Window make_window(const MapperOptions& options, const std::optional<Camera>& camera);

} // namespace zonegrid
