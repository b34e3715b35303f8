#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace zonegrid {

/// A curve and its derivatives by time.
struct SplinePoint {
    Eigen::Vector4d value = Eigen::Vector4d::Zero();
    Eigen::Vector4d first = Eigen::Vector4d::Zero();
    Eigen::Vector4d second = Eigen::Vector4d::Zero();
    Eigen::Vector4d third = Eigen::Vector4d::Zero();
};

/// A uniform B-spline of degree 5: four times continuously differentiable, and each derivative lies
/// within the hull of the control points' differences, so that limits on these hold for the curve
/// (C. de Boor, A Practical Guide to Splines, ch. IX).
class UniformSpline {
public:
    /// Control point i stands for the time i * `step_s`; outside, the ends go on for ever.
    UniformSpline(std::vector<Eigen::Vector4d> control, double step_s);

    [[nodiscard]] SplinePoint at(double time_s) const;

private:
    [[nodiscard]] const Eigen::Vector4d& control(std::ptrdiff_t i) const;

    std::vector<Eigen::Vector4d> control_;
    double step_s_;
};

} // namespace zonegrid
