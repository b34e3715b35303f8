#include "simulation/uniform_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace zonegrid {
namespace {

constexpr std::ptrdiff_t degree = 5;

/// Values of the six blending functions at `t` in [0, 1] of the piece between control points 0 and
/// 1, for control points -2 ... 3; and of those of lower degrees on the way (Cox and de Boor's
/// recursion with whole-numbered knots).
using Weights = std::array<double, degree + 1>;

Weights weights_of(int wanted_degree, double t) {
    Weights weights{1.0};
    for (int d = 1; d <= wanted_degree; ++d) {
        Weights higher{};
        for (int j = 0; j <= d; ++j) {
            const double from_left =
                j > 0 ? (t + d - j) * weights[static_cast<std::size_t>(j - 1)] : 0.0;
            const double from_right =
                j < d ? (j + 1 - t) * weights[static_cast<std::size_t>(j)] : 0.0;
            higher[static_cast<std::size_t>(j)] = (from_left + from_right) / d;
        }
        weights = higher;
    }
    return weights;
}

} // namespace

UniformSpline::UniformSpline(std::vector<Eigen::Vector4d> control, double step_s)
    : control_(std::move(control)), step_s_(step_s) {}

const Eigen::Vector4d& UniformSpline::control(std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(control_.size()) - 1;
    return control_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
}

SplinePoint UniformSpline::at(double time_s) const {
    const double steps = time_s / step_s_;
    const double whole = std::floor(steps);
    const auto first = static_cast<std::ptrdiff_t>(whole) - degree / 2;
    std::array<Eigen::Vector4d, degree + 1> points;
    for (std::ptrdiff_t i = 0; i <= degree; ++i) {
        points[static_cast<std::size_t>(i)] = control(first + i);
    }
    SplinePoint result;
    const std::array<Eigen::Vector4d*, 4> derivatives{&result.value, &result.first, &result.second,
                                                      &result.third};
    // A derivative is the spline of one degree less over the control points' differences.
    for (std::size_t order = 0; order < derivatives.size(); ++order) {
        const auto left = static_cast<std::size_t>(degree) - order;
        const Weights weights = weights_of(static_cast<int>(left), steps - whole);
        for (std::size_t i = 0; i <= left; ++i) {
            *derivatives[order] += weights[i] * points[i];
        }
        for (std::size_t i = 0; i < left; ++i) {
            points[i] = (points[i + 1] - points[i]) / step_s_;
        }
    }
    return result;
}

} // namespace zonegrid
