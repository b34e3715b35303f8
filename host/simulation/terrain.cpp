#include "simulation/terrain.h"

#include "simulation/counted_numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zonegrid {
namespace {

/// A number in -1 ... 1 that belongs to a node of the noise.
double value_at(std::uint64_t seed, std::int64_t row, std::int64_t column) {
    const std::uint64_t bits = CountedNumbers::mix(
        CountedNumbers::mix(CountedNumbers::mix(seed) ^ static_cast<std::uint64_t>(row)) ^
        static_cast<std::uint64_t>(column));
    return static_cast<double>(bits >> 11U) * 0x1.0p-52 - 1.0;
}

double smooth(double share) {
    return share * share * (3.0 - 2.0 * share);
}

/// Smooth noise in -1 ... 1 with one random value per unit square's corner.
double noise_at(std::uint64_t seed, double row, double column) {
    const double low_row = std::floor(row);
    const double low_column = std::floor(column);
    const auto i = static_cast<std::int64_t>(low_row);
    const auto k = static_cast<std::int64_t>(low_column);
    const double down = smooth(row - low_row);
    const double across = smooth(column - low_column);
    const auto between = [](double a, double b, double share) { return a + (b - a) * share; };
    return between(between(value_at(seed, i, k), value_at(seed, i, k + 1), across),
                   between(value_at(seed, i + 1, k), value_at(seed, i + 1, k + 1), across), down);
}

double hill_height_m(const HillNoise& noise, double north_m, double east_m) {
    double sum = 0.0;
    double weights = 0.0;
    double weight = 1.0;
    double wavelength_m = noise.wavelength_m;
    for (int octave = 0; octave < noise.octaves; ++octave) {
        sum += weight * noise_at(noise.seed + static_cast<std::uint64_t>(octave),
                                 north_m / wavelength_m, east_m / wavelength_m);
        weights += weight;
        weight *= 0.5;
        wavelength_m *= 0.5;
    }
    return 0.5 * noise.relief_m * sum / weights;
}

} // namespace

Terrain::Terrain(double spacing_m) : spacing_m_(spacing_m, spacing_m) {}

Terrain::Terrain(double spacing_m, const HillNoise& noise)
    : spacing_m_(spacing_m, spacing_m), noise_(noise) {}

Terrain::Terrain(HeightGrid grid)
    : origin_m_(grid.least_m),
      spacing_m_((grid.most_m - grid.least_m)
                     .cwiseQuotient(Eigen::Vector2d(static_cast<double>(grid.rows - 1),
                                                    static_cast<double>(grid.columns - 1)))),
      grid_(std::move(grid)) {}

double Terrain::node_height_m(long row, long column) const {
    if (grid_) {
        const long rows = static_cast<long>(grid_->rows);
        const long columns = static_cast<long>(grid_->columns);
        return static_cast<double>(grid_->heights_m[static_cast<std::size_t>(
            std::clamp(row, 0L, rows - 1) * columns + std::clamp(column, 0L, columns - 1))]);
    }
    return noise_ ? hill_height_m(*noise_, static_cast<double>(row) * spacing_m_.x(),
                                  static_cast<double>(column) * spacing_m_.y())
                  : 0.0;
}

double Terrain::height_m(double north_m, double east_m) const {
    const double row = (north_m - origin_m_.x()) / spacing_m_.x();
    const double column = (east_m - origin_m_.y()) / spacing_m_.y();
    const auto i = static_cast<long>(std::floor(row));
    const auto k = static_cast<long>(std::floor(column));
    const double north = row - static_cast<double>(i);
    const double east = column - static_cast<double>(k);
    const double near = node_height_m(i, k);
    const double far = node_height_m(i + 1, k + 1);
    if (north > east) { // the square's diagonal runs to the north-east
        const double corner = node_height_m(i + 1, k);
        return near + north * (corner - near) + east * (far - corner);
    }
    const double corner = node_height_m(i, k + 1);
    return near + east * (corner - near) + north * (far - corner);
}

double Terrain::nodes_over(const Eigen::Vector2d& least_m, const Eigen::Vector2d& most_m) const {
    return grid_ ? static_cast<double>(grid_->rows) * static_cast<double>(grid_->columns)
                 : (most_m - least_m).cwiseQuotient(spacing_m_).prod();
}

Shape Terrain::ground_shape(const Eigen::Vector2d& least_m, const Eigen::Vector2d& most_m) const {
    long first_row = 0;
    long first_column = 0;
    long rows = 0;
    long columns = 0;
    if (grid_) {
        rows = static_cast<long>(grid_->rows);
        columns = static_cast<long>(grid_->columns);
    } else {
        first_row = static_cast<long>(std::floor(least_m.x() / spacing_m_.x()));
        first_column = static_cast<long>(std::floor(least_m.y() / spacing_m_.y()));
        rows = static_cast<long>(std::ceil(most_m.x() / spacing_m_.x())) - first_row + 1;
        columns = static_cast<long>(std::ceil(most_m.y() / spacing_m_.y())) - first_column + 1;
    }
    Shape shape;
    for (long row = first_row; row < first_row + rows; ++row) {
        for (long column = first_column; column < first_column + columns; ++column) {
            shape.vertices_m.emplace_back(
                origin_m_.x() + static_cast<double>(row) * spacing_m_.x(),
                origin_m_.y() + static_cast<double>(column) * spacing_m_.y(),
                -node_height_m(row, column));
        }
    }
    const auto node = [&](long row, long column) {
        return static_cast<std::uint32_t>(row * columns + column);
    };
    for (long row = 0; row + 1 < rows; ++row) {
        for (long column = 0; column + 1 < columns; ++column) {
            const std::uint32_t near = node(row, column);
            const std::uint32_t far = node(row + 1, column + 1);
            shape.triangles.push_back({near, far, node(row + 1, column)});
            shape.triangles.push_back({near, node(row, column + 1), far});
        }
    }
    return shape;
}

} // namespace zonegrid
