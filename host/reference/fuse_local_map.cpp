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

} // namespace

FusionResult fuse_local_map(const LocalMap& local_map, const FusionRule& rule, Grid& grid) {
    FusionResult result;
    std::vector<std::uint8_t> statements(grid.zone_cells());
    for (const auto place : local_map.zones()) {
        local_map.copy_zone(place, statements);
        const auto change = fuse_zone(statements, rule, grid.touch(place));
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
