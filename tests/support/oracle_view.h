#pragma once

#include "support/oracle_local_map.h"
#include "support/oracle_pose.h"
#include "zonegrid/objects.h"
#include "zonegrid/options.h"
#include "zonegrid/sensors.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace zonegrid::oracle {

/// The view of one image (docs/model.md, section 3, "View"). In world cells: the
/// window starts at a whole cell, so every difference is that of the window-relative numbers.
class View {
public:
    /// `pose` must be in range.
    View(const Camera& camera, const MapperOptions& options, const Pose& pose,
         std::span<const float> depth_m);

    /// Whether each of the cell's eight corners is inside all four planes and the range.
    [[nodiscard]] bool holds_whole(const CellIndex& cell) const;

private:
    using Whole = std::array<std::int64_t, 3>;

    [[nodiscard]] bool holds_corner(const Whole& corner) const;

    std::optional<std::array<Whole, 4>> inwards_; ///< normals, 1/2^14; absent: all pixels missing
    Whole centre_{};                              ///< of the camera, in 1/16 cell
    std::int64_t radius_ = 0;                     ///< of the range, in 1/16 cell
};

} // namespace zonegrid::oracle
