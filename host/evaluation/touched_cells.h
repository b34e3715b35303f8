#pragma once

#include "evaluation/cell_set.h"
#include "evaluation/triangle_cells.h"
#include "truth/surfaces.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace zonegrid {

/// Cells that surfaces touch, and which obstacles do so. Obstacles are named by their index in
/// Surfaces::obstacles.
class TouchedCells {
public:
    explicit TouchedCells(std::size_t obstacles) : of_(obstacles) {}

    void add(std::uint32_t obstacle, const CellIndex& cell);

    [[nodiscard]] const CellSet& all() const { return all_; }
    [[nodiscard]] const CellSet& of(std::uint32_t obstacle) const { return of_[obstacle]; }
    [[nodiscard]] std::size_t obstacles() const { return of_.size(); }

    /// The obstacles with a cell at most `reach` cells away on every axis, ascending.
    [[nodiscard]] std::vector<std::uint32_t> obstacles_within(const CellIndex& cell,
                                                              std::int32_t reach) const;

private:
    CellSet all_;
    std::vector<CellSet> of_;
    std::unordered_map<ZoneIndex, std::vector<std::uint32_t>, ZoneHash> in_zone_;
};

/// Cells of the box that one obstacle touches, standing at `world_from_obstacle`.
[[nodiscard]] CellSet touch_cells(const Surfaces& surfaces, std::uint32_t obstacle,
                                  const Eigen::Isometry3d& world_from_obstacle, double cell_m,
                                  const CellBox& box);

/// Cells of the box that the obstacles which do not move touch.
[[nodiscard]] TouchedCells touch_cells(const Surfaces& surfaces, double cell_m, const CellBox& box);

/// The least box that holds the obstacles which do not move; nothing if there are none.
[[nodiscard]] std::optional<Eigen::AlignedBox3d> extent_m(const Surfaces& surfaces);

/// Floor of a place in cells, kept within +-2^30.
[[nodiscard]] CellIndex cell_at_m(const Eigen::Vector3d& place_m, double cell_m);

} // namespace zonegrid
