#pragma once

#include <Eigen/Core>

#include <vector>

namespace zonegrid {

/// An ideal pinhole behind a lens after Brown and Conrady, as OpenCV numbers the coefficients.
/// With (x, y) the ideal slopes and r^2 = x^2 + y^2, the lens shows them at
///   x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)
///   y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y
struct BrownConrady {
    double k1 = 0.0;
    double k2 = 0.0;
    double p1 = 0.0;
    double p2 = 0.0;
    double k3 = 0.0;
};

/// What the lens makes of the ideal slopes (x/z, y/z).
[[nodiscard]] Eigen::Vector2d distort(const Eigen::Vector2d& ideal, const BrownConrady& lens);

/// The ideal slopes that the lens shows at `shown`, by Newton's iteration.
/// Returns false where there are none: beyond the radius up to which the lens is one-to-one.
[[nodiscard]] bool undistort(const Eigen::Vector2d& shown, const BrownConrady& lens,
                             Eigen::Vector2d& ideal);

} // namespace zonegrid
