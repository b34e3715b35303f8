#include "io/profile_picture_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace zonegrid {
namespace {

/// Widens [low, high] to at least `extent` about its middle.
void widen(double& low, double& high, double extent) {
    if (high - low < extent) {
        const double middle = 0.5 * (low + high);
        low = middle - 0.5 * extent;
        high = middle + 0.5 * extent;
    }
}

/// Takes in an extreme if it lies within reach of the range's end; else it counts as beyond.
void take_in_extremes(HeightRange& range, double least_m, double reach_below_m, double most_m,
                      double reach_above_m) {
    range.some_below = least_m < range.low_m - reach_below_m;
    range.some_above = most_m > range.high_m + reach_above_m;
    if (!range.some_below) {
        range.low_m = std::min(range.low_m, least_m);
    }
    if (!range.some_above) {
        range.high_m = std::max(range.high_m, most_m);
    }
}

} // namespace

bool is_drawable(const Eigen::Vector3d& point_m) {
    return point_m.allFinite() && point_m.cwiseAbs().maxCoeff() <= 1e6;
}

GroundPlan ground_plan(const HeightProfile& profile,
                       std::span<const Eigen::Vector3d> trajectory_m) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    GroundPlan plan{infinity, -infinity, infinity, -infinity};
    const auto include = [&plan](double north_m, double east_m) {
        plan.north_min_m = std::min(plan.north_min_m, north_m);
        plan.north_max_m = std::max(plan.north_max_m, north_m);
        plan.east_min_m = std::min(plan.east_min_m, east_m);
        plan.east_max_m = std::max(plan.east_max_m, east_m);
    };
    for (const ProfileColumn& column : profile.columns) {
        include(column.x * profile.cell_m, column.y * profile.cell_m);
        include((column.x + 1.0) * profile.cell_m, (column.y + 1.0) * profile.cell_m);
    }
    for (const Eigen::Vector3d& point : trajectory_m) {
        if (is_drawable(point)) {
            include(point.x(), point.y());
        }
    }
    const double margin_m = 0.02 * std::max(plan.north_extent_m(), plan.east_extent_m());
    plan = {plan.north_min_m - margin_m, plan.north_max_m + margin_m, plan.east_min_m - margin_m,
            plan.east_max_m + margin_m};
    widen(plan.north_min_m, plan.north_max_m, 10.0 * profile.cell_m);
    widen(plan.east_min_m, plan.east_max_m, 10.0 * profile.cell_m);
    return plan;
}

HeightRanges height_ranges(const HeightProfile& profile, const GroundPlan& plan) {
    std::vector<double> tops_m;
    tops_m.reserve(profile.columns.size());
    for (const ProfileColumn& column : profile.columns) {
        tops_m.push_back(top_m(column, profile.cell_m));
    }
    const auto [least, most] = std::ranges::minmax(tops_m);
    const auto percentile = [&tops_m](double fraction) {
        const auto rank = std::lround(fraction * static_cast<double>(tops_m.size() - 1));
        std::ranges::nth_element(tops_m, tops_m.begin() + rank);
        return tops_m[static_cast<std::size_t>(rank)];
    };
    HeightRanges ranges;
    ranges.colour.low_m = percentile(0.005);
    ranges.colour.high_m = percentile(0.995);
    ranges.drawn = ranges.colour;
    const double bulk_m = ranges.colour.high_m - ranges.colour.low_m;
    const double near_m = 0.25 * bulk_m;
    take_in_extremes(ranges.colour, least, near_m, most, near_m);

    // A few cells far above may be a mast; far below the ground there is nothing to see.
    const double extent_m = std::max(plan.north_extent_m(), plan.east_extent_m());
    const double mast_m = std::max(0.5 * bulk_m, 0.1 * extent_m);
    take_in_extremes(ranges.drawn, least, near_m, most, mast_m);
    ranges.drawn.high_m += ranges.drawn.some_above ? mast_m : 0.0;
    // Level ground keeps the lowest colour, and the bar its two ends.
    ranges.colour.high_m =
        std::max(ranges.colour.high_m, ranges.colour.low_m + 4.0 * profile.cell_m);
    return ranges;
}

double round_step(double extent, int most) {
    const double least = extent / most;
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= least * (1.0 - 1e-9)) {
            return factor * decade;
        }
    }
    return 10.0 * decade;
}

std::string number_text(double value, double step) {
    const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 6);
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
    const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
    return value < 0.0 && !is_zero ? "\u2212" + digits : digits;
}

std::string clipping_note(const HeightRange& range) {
    if (!range.some_below && !range.some_above) {
        return {};
    }
    const double extent_m = range.high_m - range.low_m;
    const double step = round_step(extent_m > 0.0 ? extent_m : 1.0, 100); // level ground has none
    return fmt::format("heights outside {}..{} m clipped", number_text(range.low_m, step),
                       number_text(range.high_m, step));
}

} // namespace zonegrid
