#pragma once

#include <Eigen/Core>

#include <span>

namespace zonegrid {

/// The line through points, seen from above, from which the sum of their squared distances is
/// least. It points from the first of them to the last.
struct BestLine {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< the points' middle
    Eigen::Vector2d along = Eigen::Vector2d::UnitX(); ///< unit vector

    [[nodiscard]] Eigen::Vector2d across() const { return {-along.y(), along.x()}; }
    /// Greatest distance of one of `points` from the line.
    [[nodiscard]] double greatest_distance(std::span<const Eigen::Vector2d> points) const;
};

/// `points`: at least two.
[[nodiscard]] BestLine fit_line(std::span<const Eigen::Vector2d> points);

} // namespace zonegrid
