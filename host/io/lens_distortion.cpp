#include "io/lens_distortion.h"

#include <Eigen/LU>

namespace zonegrid {
namespace {

/// Derivative of `distort` by the ideal slopes.
Eigen::Matrix2d distortion_slope(const Eigen::Vector2d& ideal, const BrownConrady& lens) {
    const double x = ideal.x();
    const double y = ideal.y();
    const double r2 = ideal.squaredNorm();
    const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
    const double radial_by_r2 = lens.k1 + r2 * (2.0 * lens.k2 + r2 * 3.0 * lens.k3);
    const double mixed = 2.0 * x * y * radial_by_r2 + 2.0 * lens.p1 * x + 2.0 * lens.p2 * y;
    Eigen::Matrix2d slope;
    slope << radial + 2.0 * x * x * radial_by_r2 + 2.0 * lens.p1 * y + 6.0 * lens.p2 * x, mixed,
        mixed, radial + 2.0 * y * y * radial_by_r2 + 6.0 * lens.p1 * y + 2.0 * lens.p2 * x;
    return slope;
}

} // namespace

Eigen::Vector2d distort(const Eigen::Vector2d& ideal, const BrownConrady& lens) {
    const double x = ideal.x();
    const double y = ideal.y();
    const double r2 = ideal.squaredNorm();
    const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
    return {x * radial + 2.0 * lens.p1 * x * y + lens.p2 * (r2 + 2.0 * x * x),
            y * radial + lens.p1 * (r2 + 2.0 * y * y) + 2.0 * lens.p2 * x * y};
}

bool undistort(const Eigen::Vector2d& shown, const BrownConrady& lens, Eigen::Vector2d& ideal) {
    constexpr int most_steps = 50;
    constexpr double tolerance = 1e-10; // slopes: far below a hundredth of a pixel
    ideal = shown;
    for (int step = 0; step < most_steps; ++step) {
        const Eigen::Vector2d error = distort(ideal, lens) - shown;
        const Eigen::Matrix2d slope = distortion_slope(ideal, lens);
        // Beyond the fold the image is turned over: a solution there is none.
        if (!(slope.determinant() > 0.0) || !(slope.trace() > 0.0)) {
            return false;
        }
        if (error.norm() < tolerance) {
            return true;
        }
        ideal -= slope.inverse() * error;
    }
    return false;
}

} // namespace zonegrid
