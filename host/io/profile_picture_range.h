#pragma once

#include "zonegrid/objects.h"

#include <Eigen/Core>

#include <span>
#include <string>

namespace zonegrid {

/// A ground-plan rectangle in metres, world frame.
struct GroundPlan {
    double north_min_m = 0.0;
    double north_max_m = 0.0;
    double east_min_m = 0.0;
    double east_max_m = 0.0;
    [[nodiscard]] double north_extent_m() const { return north_max_m - north_min_m; }
    [[nodiscard]] double east_extent_m() const { return east_max_m - east_min_m; }
};

/// Whether a point of the trajectory can be drawn: finite, and within a million metres of the
/// world's origin, so that a wild value does not shrink the picture to nothing.
[[nodiscard]] bool is_drawable(const Eigen::Vector3d& point_m);

/// The rectangle around all columns and all drawable points of the trajectory, at least ten cells a
/// side, with a margin of 2 percent. The profile must have columns.
[[nodiscard]] GroundPlan ground_plan(const HeightProfile& profile,
                                     std::span<const Eigen::Vector3d> trajectory_m);

/// Height of a column's top in metres above the world's origin.
[[nodiscard]] inline double top_m(const ProfileColumn& column, double cell_m) {
    return -static_cast<double>(column.z) * cell_m;
}

/// A range of heights, and whether columns lie beyond its ends.
struct HeightRange {
    double low_m = 0.0;
    double high_m = 0.0;
    bool some_below = false;
    bool some_above = false;
};

/// The two ranges a picture needs; both come from the order of heights, so that a few wild cells
/// do not change them.
struct HeightRanges {
    HeightRange colour; ///< 0.5th to 99.5th percentile; extremes included if they are near
    HeightRange drawn;  ///< what a perspective view keeps: wider above, e.g. a mast on a field
};

/// The profile must have columns. Cost: linear in the columns.
[[nodiscard]] HeightRanges height_ranges(const HeightProfile& profile, const GroundPlan& plan);

/// "heights outside -0.2..11.5 m clipped", or empty if no column lies beyond.
[[nodiscard]] std::string clipping_note(const HeightRange& range);

/// The value with as many decimals as a step of `step` needs, with a true minus sign.
[[nodiscard]] std::string number_text(double value, double step);

/// 1, 2 or 5 times a power of ten: the least such step that gives at most `most` intervals.
[[nodiscard]] double round_step(double extent, int most);

} // namespace zonegrid
