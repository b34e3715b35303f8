#include "simulation/structures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace zonegrid {
namespace {

Shape bar(const Eigen::Vector3d& start_m, const Eigen::Vector3d& end_m, double thickness_m) {
    return tube(std::vector<Section>{{start_m, 0.5 * thickness_m}, {end_m, 0.5 * thickness_m}}, 4);
}

/// The parameter a of the catenary y = a cosh(x / a) that hangs `sag_m` over `span_m`. The sag
/// falls while a grows, so halving finds it.
double catenary_parameter(double span_m, double sag_m) {
    const double half_m = 0.5 * span_m;
    const auto sag_of = [&](double a) { return a * (std::cosh(half_m / a) - 1.0); };
    double low = half_m / 700.0;           // cosh overflows beyond 710
    double high = half_m * half_m / sag_m; // sag_of(a) is close to half^2 / (2 a) for long a
    high = std::max(high, span_m);
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (sag_of(middle) > sag_m ? low : high) = middle;
    }
    return high;
}

} // namespace

Shape building_shape(const BuildingSize& size) {
    const double x = 0.5 * size.length_m;
    const double y = 0.5 * size.width_m;
    if (size.roof == Roof::flat) {
        return box({-x, -y, -size.eaves_m}, {x, y, size.foundation_m});
    }
    const auto profile_at = [&](double at_x) {
        return Ring{{at_x, -y, size.foundation_m},
                    {at_x, -y, -size.eaves_m},
                    {at_x, 0.0, -size.ridge_m},
                    {at_x, y, -size.eaves_m},
                    {at_x, y, size.foundation_m}};
    };
    return lofted(std::vector{profile_at(-x), profile_at(x)});
}

Shape pole_shape(double height_m, double diameter_m) {
    return tube(std::vector<Section>{{{0.0, 0.0, 0.5}, 0.5 * diameter_m},
                                     {{0.0, 0.0, -height_m}, 0.25 * diameter_m}},
                10);
}

Shape lattice_mast_shape(double height_m, double width_m) {
    const double half_m = 0.5 * width_m;
    const double leg_m = std::clamp(0.08 * width_m, 0.05, 0.3);
    const double brace_m = 0.6 * leg_m;
    const std::array<Eigen::Vector3d, 4> corners{
        Eigen::Vector3d(-half_m, -half_m, 0.0), Eigen::Vector3d(half_m, -half_m, 0.0),
        Eigen::Vector3d(half_m, half_m, 0.0), Eigen::Vector3d(-half_m, half_m, 0.0)};
    const int bays = std::max(1, static_cast<int>(std::lround(height_m / (1.5 * width_m))));
    const auto at = [&](std::size_t corner, double height) -> Eigen::Vector3d {
        return corners.at(corner % 4) - height * Eigen::Vector3d::UnitZ();
    };
    Shape shape;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        shape.append(bar(at(corner, -0.5), at(corner, height_m), leg_m));
        for (int bay = 0; bay < bays; ++bay) {
            const double low_m = height_m * bay / bays;
            const double high_m = height_m * (bay + 1) / bays;
            shape.append(bar(at(corner, high_m), at(corner + 1, high_m), brace_m));
            const std::size_t turn = bay % 2 == 0 ? 0 : 1; // diagonals zigzag
            shape.append(bar(at(corner + turn, low_m), at(corner + 1 - turn, high_m), brace_m));
        }
    }
    return shape;
}

Shape wire_shape(const Eigen::Vector3d& start_m, const Eigen::Vector3d& end_m, double sag_m,
                 double diameter_m) {
    const Eigen::Vector3d way = end_m - start_m;
    const double span_m = way.norm();
    const double a = catenary_parameter(span_m, sag_m);
    const int pieces = std::clamp(static_cast<int>(std::ceil(span_m / 2.0)), 16, 200);
    std::vector<Section> sections;
    for (int i = 0; i <= pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        const double x = (share - 0.5) * span_m;
        const double below_m = sag_m - a * (std::cosh(x / a) - 1.0);
        sections.push_back(
            {start_m + share * way + below_m * Eigen::Vector3d::UnitZ(), 0.5 * diameter_m});
    }
    return tube(sections, 6);
}

Shape tunnel_shape(std::span<const Eigen::Vector3d> way_m, double diameter_m, double wall_m) {
    std::vector<Section> outer;
    std::vector<Section> inner;
    for (const Eigen::Vector3d& point : way_m) {
        outer.push_back({point, 0.5 * diameter_m + wall_m});
        inner.push_back({point, 0.5 * diameter_m});
    }
    constexpr int sides = 32;
    std::vector<Ring> rings = tube_rings(outer, sides);
    std::vector<Ring> back = tube_rings(inner, sides);
    rings.insert(rings.end(), back.rbegin(), back.rend());
    return lofted(rings, Ends::joined);
}

} // namespace zonegrid
