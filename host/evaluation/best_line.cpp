#include "evaluation/best_line.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace zonegrid {

double BestLine::greatest_distance(std::span<const Eigen::Vector2d> points) const {
    double greatest = 0.0;
    for (const auto& point : points) {
        greatest = std::max(greatest, std::abs((point - origin).dot(across())));
    }
    return greatest;
}

BestLine fit_line(std::span<const Eigen::Vector2d> points) {
    BestLine line;
    line.origin = std::accumulate(points.begin(), points.end(), Eigen::Vector2d(0.0, 0.0)) /
                  static_cast<double>(points.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const auto& point : points) {
        spread += (point - line.origin) * (point - line.origin).transpose();
    }
    // Eigenvalues come in increasing order: the last vector is that along which points vary most.
    line.along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
    if (line.along.dot(points.back() - points.front()) < 0.0) {
        line.along = -line.along;
    }
    return line;
}

} // namespace zonegrid
