#pragma once

#include "support/oracle_pose.h"
#include "support/oracle_segment.h"
#include "zonegrid/options.h"
#include "zonegrid/sensors.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

namespace zonegrid::oracle {

enum class Statement { free, occupied };

/// World cells with a statement; a cell that is absent has none.
using StatementMap = std::map<CellIndex, Statement>;

/// A cube of cells, `first` inclusive, `edge` cells on each axis.
struct Window {
    std::array<std::int64_t, 3> first{};
    std::int64_t edge = 0;
    [[nodiscard]] bool holds(const CellIndex& cell) const;
};

/// What an image or scan says, and how many of its pixels or points said nothing.
struct LocalMap {
    StatementMap cells;
    std::uint64_t missing = 0;
    std::uint64_t dropped = 0; ///< rays of a scan with an end outside the window
};

/// Sub-cell of a position in metres on one axis; nothing if not finite or beyond +-2^31 cells.
[[nodiscard]] std::optional<std::int64_t> sub_of(double position_m, double cell_m);

/// Whether a depth is none (section 3, "Depth").
[[nodiscard]] bool is_missing(float depth_m);

/// Where a pixel stands in an image or in a table of directions.
[[nodiscard]] std::size_t pixel_at(const Camera& camera, int u, int v);

/// `dir(u, v)` of section 3, its third component 1.
[[nodiscard]] Triple pixel_direction(const Camera& camera, int u, int v);

/// Local map of one depth image (docs/model.md, sections 3 and 5). `pose` must be in range.
[[nodiscard]] LocalMap image_local_map(const Camera& camera, const MapperOptions& options,
                                       const Pose& pose, std::span<const float> depth_m);

/// Local map of one scan; always the `line` model.
[[nodiscard]] LocalMap scan_local_map(const Scan& scan, const MapperOptions& options,
                                      const Pose& pose, const Window& window);

} // namespace zonegrid::oracle
