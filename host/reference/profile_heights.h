#pragma once

#include "model/lattice.h"
#include "model/zone_bits.h"
#include "zonegrid/objects.h"

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace zonegrid::reference {

/// Highest occupied cell of each column (docs/model.md, section 9), sorted by x, then y.
/// Cells with z < `z_least` are left out.
class HeightProfiler {
public:
    explicit HeightProfiler(std::int32_t zone_edge,
                            std::int32_t z_least = std::numeric_limits<std::int32_t>::min())
        : zone_edge_(zone_edge), z_least_(z_least) {}

    /// Takes in one zone's occupied cells; zones come in any order, each once.
    void add_zone(const ZoneIndex& zone, const ZoneBits& occupied);

    [[nodiscard]] std::vector<ProfileColumn> columns() const;

private:
    std::int32_t zone_edge_;
    std::int32_t z_least_;
    /// By zone column (z = 0): least z of its columns, order [y][x].
    std::map<ZoneIndex, std::vector<std::int32_t>> tiles_;
};

} // namespace zonegrid::reference
