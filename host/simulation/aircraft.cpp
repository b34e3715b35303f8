#include "simulation/aircraft.h"

#include <vector>

namespace zonegrid {
namespace {

/// A flat body between two rectangles: wings and fins. `root` and `tip` are the middle of the front
/// edges, `across` is the thin direction.
Shape surface(const Eigen::Vector3d& root_m, double root_chord_m, const Eigen::Vector3d& tip_m,
              double tip_chord_m, double thickness_m) {
    const Eigen::Vector3d way = (tip_m - root_m).normalized();
    const Eigen::Vector3d forward = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d thin = 0.5 * thickness_m * way.cross(forward).normalized();
    const auto ring_at = [&](const Eigen::Vector3d& front, double chord_m) {
        const Eigen::Vector3d rear = front - chord_m * forward;
        return Ring{rear - thin, front - thin, front + thin, rear + thin};
    };
    return lofted(std::vector{ring_at(root_m, root_chord_m), ring_at(tip_m, tip_chord_m)});
}

Shape rod(const Eigen::Vector3d& start_m, const Eigen::Vector3d& end_m, double diameter_m,
          int sides = 8) {
    return tube(std::vector<Section>{{start_m, 0.5 * diameter_m}, {end_m, 0.5 * diameter_m}},
                sides);
}

Shape wheel(const Eigen::Vector3d& hub_m, double diameter_m, double width_m) {
    const Eigen::Vector3d half = 0.5 * width_m * Eigen::Vector3d::UnitY();
    return rod(hub_m - half, hub_m + half, diameter_m, 12);
}

/// A body of revolution along the forward axis: pairs of x and radius, from the tail on.
Shape fuselage(const std::vector<std::array<double, 2>>& stations) {
    std::vector<Section> sections;
    for (const auto& [x_m, radius_m] : stations) {
        sections.push_back({{x_m, 0.0, 0.0}, radius_m});
    }
    return tube(sections, 14);
}

Shape aeroplane(double length_m, double span_m) {
    const double l = length_m;
    Shape shape = fuselage({{-0.50 * l, 0.015 * l},
                            {-0.20 * l, 0.050 * l},
                            {0.05 * l, 0.085 * l},
                            {0.30 * l, 0.080 * l},
                            {0.45 * l, 0.055 * l},
                            {0.50 * l, 0.015 * l}});
    for (const double side : {-1.0, 1.0}) {
        shape.append(surface({0.22 * l, 0.0, -0.075 * l}, 0.20 * l,
                             {0.20 * l, side * 0.5 * span_m, -0.085 * l}, 0.13 * l, 0.02 * l));
        shape.append(surface({-0.36 * l, 0.0, 0.0}, 0.12 * l,
                             {-0.38 * l, side * 0.17 * span_m, 0.0}, 0.08 * l, 0.01 * l));
        const Eigen::Vector3d hub(0.08 * l, side * 0.13 * l, 0.16 * l);
        shape.append(rod({0.10 * l, side * 0.03 * l, 0.05 * l}, hub, 0.012 * l));
        shape.append(wheel(hub, 0.06 * l, 0.025 * l));
    }
    shape.append(
        surface({-0.34 * l, 0.0, 0.0}, 0.15 * l, {-0.41 * l, 0.0, -0.19 * l}, 0.08 * l, 0.01 * l));
    const Eigen::Vector3d nose_hub(0.38 * l, 0.0, 0.16 * l);
    shape.append(rod({0.38 * l, 0.0, 0.04 * l}, nose_hub, 0.012 * l));
    shape.append(wheel(nose_hub, 0.06 * l, 0.025 * l));
    return shape;
}

Shape helicopter(double length_m, double span_m) {
    const double l = length_m;
    Shape shape = fuselage({{-0.50 * l, 0.020 * l},
                            {-0.10 * l, 0.035 * l},
                            {0.02 * l, 0.120 * l},
                            {0.25 * l, 0.140 * l},
                            {0.42 * l, 0.090 * l},
                            {0.50 * l, 0.020 * l}});
    shape.append(rod({0.15 * l, 0.0, -0.10 * l}, {0.15 * l, 0.0, -0.22 * l}, 0.04 * l));
    shape.append(rod({0.15 * l, 0.0, -0.21 * l}, {0.15 * l, 0.0, -0.22 * l}, span_m, 24));
    shape.append(
        surface({-0.42 * l, 0.0, 0.0}, 0.08 * l, {-0.47 * l, 0.0, -0.14 * l}, 0.05 * l, 0.01 * l));
    for (const double side : {-1.0, 1.0}) {
        const double y = side * 0.12 * l;
        shape.append(rod({-0.02 * l, y, 0.18 * l}, {0.36 * l, y, 0.18 * l}, 0.02 * l));
        for (const double x_m : {0.06 * l, 0.28 * l}) {
            shape.append(rod({x_m, side * 0.05 * l, 0.08 * l}, {x_m, y, 0.18 * l}, 0.015 * l));
        }
    }
    return shape;
}

} // namespace

Shape aircraft_shape(AircraftModel model, double length_m, double span_m) {
    return model == AircraftModel::helicopter ? helicopter(length_m, span_m)
                                              : aeroplane(length_m, span_m);
}

double undercarriage_m(double length_m) {
    return 0.19 * length_m; // wheels: hub 0.16 + radius 0.03; skids: 0.18 + 0.01
}

} // namespace zonegrid
