#include "reference/fuse_local_map.h"

#include <algorithm>

namespace zonegrid::reference {

namespace {

struct ZoneChange {
    std::uint32_t values = 0;
    std::uint32_t occupancy = 0;
};

ZoneChange fuse_zone(std::span<const std::uint8_t> statements, const FusionRule& rule,
                     std::span<std::int8_t> values) {
    ZoneChange change;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::int32_t before = values[i];
        const std::int32_t delta = statements[i] == ZG_STATEMENT_OCCUPIED ? rule.hit
                                   : statements[i] == ZG_STATEMENT_FREE   ? -rule.miss
                                                                          : 0;
        const std::int32_t after = std::clamp(before + delta, -rule.limit, rule.limit);
        values[i] = static_cast<std::int8_t>(after);
        change.values += after != before ? 1U : 0U;
        change.occupancy += (after >= rule.threshold) != (before >= rule.threshold) ? 1U : 0U;
    }
    return change;
}

} // namespace

FusionResult fuse_local_map(const LocalMap& local_map, const FusionRule& rule, Grid& grid) {
    FusionResult result;
    for (const auto place : local_map.held()) {
        const auto change = fuse_zone(local_map.find(place), rule, grid.touch(place));
        result.cells_changed += change.values;
        if (change.occupancy != 0) {
            result.occupancy_changed.push_back(place);
        }
    }
    return result;
}

} // namespace zonegrid::reference
