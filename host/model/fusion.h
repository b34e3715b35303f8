#pragma once

#include "zonegrid/options.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace zonegrid {

/// Numbers of the saturating fusion (docs/model.md, section 7).
struct FusionRule {
    std::int32_t hit = 0;
    std::int32_t miss = 0;
    std::int32_t limit = 0;
    std::int32_t threshold = 0; ///< a cell is occupied from this value on

    explicit FusionRule(const MapperOptions& options)
        : hit(options.hit),
          miss(options.miss),
          limit(options.limit),
          threshold(options.threshold) {}

    /// Value of a remembered obstacle's cell when its zone returns to the window.
    [[nodiscard]] std::int32_t drawn() const { return (threshold + limit + 1) / 2; }
};

/// What adding a local map did to the grid.
struct FusionResult {
    std::uint64_t cells_changed = 0;
    /// Places of zones in which a cell has another value than before, ascending.
    std::vector<std::uint32_t> values_changed;
    /// Places of zones in which a cell became occupied or ceased to be, ascending.
    std::vector<std::uint32_t> occupancy_changed;
};

} // namespace zonegrid
