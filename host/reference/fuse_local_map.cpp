#include "reference/fuse_local_map.h"

#include <algorithm>

namespace zonegrid::reference {

namespace {

struct ZoneChange {
    std::uint32_t values = 0;
    std::uint32_t occupancy = 0;
};

/// Sixteen bits hold every sum of a value and a change, and a count of cells in a run of this many:
/// so narrow, the compiler takes eight cells at once.
constexpr std::size_t run_cells = 512;

// The rule by value: a reference might lie in the bytes written, and be read anew for each.
ZoneChange fuse_zone(std::span<const std::uint8_t> statements, const FusionRule rule,
                     std::span<std::int8_t> values) {
    const auto hit = static_cast<std::int16_t>(rule.hit);
    const auto miss = static_cast<std::int16_t>(-rule.miss);
    const auto highest = static_cast<std::int16_t>(rule.limit);
    const auto lowest = static_cast<std::int16_t>(-rule.limit);
    const auto threshold = static_cast<std::int16_t>(rule.threshold);
    ZoneChange change;
    for (std::size_t run = 0; run < values.size(); run += run_cells) {
        std::uint16_t values_changed = 0;
        std::uint16_t occupancy_changed = 0;
        for (std::size_t i = run; i < run + run_cells; ++i) {
            const std::int16_t before = values[i];
            const std::int16_t delta = statements[i] == ZG_STATEMENT_OCCUPIED ? hit
                                       : statements[i] == ZG_STATEMENT_FREE   ? miss
                                                                              : std::int16_t{0};
            const auto sum = static_cast<std::int16_t>(before + delta);
            const std::int16_t after = std::clamp(sum, lowest, highest);
            values[i] = static_cast<std::int8_t>(after);
            values_changed = static_cast<std::uint16_t>(values_changed + (after != before ? 1 : 0));
            occupancy_changed = static_cast<std::uint16_t>(
                occupancy_changed + ((after >= threshold) != (before >= threshold) ? 1 : 0));
        }
        change.values += values_changed;
        change.occupancy += occupancy_changed;
    }
    return change;
}

/// Whether all of a cell, given relative to the window's first, lies in the view.
bool sees_whole(const View& view, const CellIndex& cell) {
    for (int corner = 0; corner < 8; ++corner) {
        const std::int64_t x =
            std::int64_t{ZG_VIEW_PER_CELL} * (cell.x + (corner & 1)) - view.centre.x;
        const std::int64_t y =
            std::int64_t{ZG_VIEW_PER_CELL} * (cell.y + (corner >> 1 & 1)) - view.centre.y;
        const std::int64_t z =
            std::int64_t{ZG_VIEW_PER_CELL} * (cell.z + (corner >> 2)) - view.centre.z;
        const std::int64_t radius = view.radius - ZG_VIEW_MARGIN;
        if (x * x + y * y + z * z > radius * radius) {
            return false;
        }
        for (const auto& side : view.sides) {
            if (side.x * x + side.y * y + side.z * z < ZG_VIEW_MARGIN << ZG_VIEW_NORMAL_BITS) {
                return false;
            }
        }
    }
    return true;
}

/// Whether a run of cells has an obstacle that is stated free. That is rare, and to look for one
/// the compiler takes many cells at once if all is in bytes.
bool denies(std::span<const std::uint8_t> statements, std::span<const std::int8_t> values,
            std::int8_t threshold) {
    std::uint8_t any = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto free = static_cast<std::uint8_t>(statements[i] == ZG_STATEMENT_FREE ? 1 : 0);
        const auto occupied = static_cast<std::uint8_t>(values[i] >= threshold ? 1 : 0);
        any |= static_cast<std::uint8_t>(free & occupied);
    }
    return any != 0;
}

/// Takes back what is said against obstacles of whose cells the view holds only a part.
void keep_partly_seen(const View& view, const CellIndex& first_of_zone, std::int32_t zone_edge,
                      std::int32_t threshold, std::span<const std::int8_t> values,
                      std::span<std::uint8_t> statements) {
    for (std::size_t run = 0; run < values.size(); run += run_cells) {
        if (!denies(statements.subspan(run, run_cells), values.subspan(run, run_cells),
                    static_cast<std::int8_t>(threshold))) {
            continue;
        }
        for (std::size_t i = run; i < run + run_cells; ++i) {
            if (statements[i] != ZG_STATEMENT_FREE || values[i] < threshold) {
                continue;
            }
            const CellIndex in_zone = cell_at({}, static_cast<std::uint32_t>(i), zone_edge);
            const CellIndex cell{first_of_zone.x + in_zone.x, first_of_zone.y + in_zone.y,
                                 first_of_zone.z + in_zone.z};
            if (!sees_whole(view, cell)) {
                statements[i] = ZG_STATEMENT_NOTHING;
            }
        }
    }
}

} // namespace

FusionResult fuse_local_map(const LocalMap& local_map, const View& view, const FusionRule& rule,
                            Grid& grid) {
    FusionResult result;
    std::vector<std::uint8_t> statements(grid.zone_cells());
    for (const auto place : local_map.zones()) {
        local_map.copy_zone(place, statements);
        const auto values = grid.touch(place);
        if (view.bounded) {
            keep_partly_seen(view, grid.window().first_cell_at(place), grid.window().zone_edge(),
                             rule.threshold, values, statements);
        }
        const auto change = fuse_zone(statements, rule, values);
        result.cells_changed += change.values;
        if (change.values != 0) {
            result.values_changed.push_back(place);
        }
        if (change.occupancy != 0) {
            result.occupancy_changed.push_back(place);
        }
    }
    return result;
}

} // namespace zonegrid::reference
