#include "simulation/plants.h"

#include <cmath>
#include <vector>

namespace zonegrid {
namespace {

constexpr double roots_m = 0.3;

Section at_height(double height_m, double radius_m) {
    return {{0.0, 0.0, -height_m}, radius_m};
}

/// Skin over sections that stand above each other, dented by up to `dents` of the radius.
Shape leaves(const std::vector<Section>& sections, int sides, double dents,
             SeededNumbers& numbers) {
    return lofted(tube_rings(sections, sides, [&] { return 1.0 - numbers.real(0.0, dents); }));
}

/// Sections of an egg between two heights, widest at `widest` of its height.
std::vector<Section> egg(double low_m, double high_m, double radius_m, double widest, int count) {
    std::vector<Section> sections;
    for (int i = 0; i < count; ++i) {
        // The first and last are small, not points: a fan closes them.
        const double share = (i + 0.25) / (count - 0.5);
        const double from_widest =
            share < widest ? (widest - share) / widest : (share - widest) / (1.0 - widest);
        const double round = std::sqrt(1.0 - from_widest * from_widest);
        sections.push_back(at_height(low_m + share * (high_m - low_m), radius_m * round));
    }
    sections.front().centre_m.z() = -low_m;
    sections.back().centre_m.z() = -high_m;
    return sections;
}

/// Sections of a cone in tiers, as branches hang: each tier is narrower at its top.
std::vector<Section> tiers(double low_m, double high_m, double radius_m, int count) {
    std::vector<Section> sections;
    for (int i = 0; i < count; ++i) {
        const double low_share = static_cast<double>(i) / count;
        const double high_share = (i + 0.85) / count;
        const double height_m = high_m - low_m;
        sections.push_back(at_height(low_m + low_share * height_m, radius_m * (1.0 - low_share)));
        sections.push_back(
            at_height(low_m + high_share * height_m, radius_m * 0.75 * (1.0 - high_share)));
    }
    sections.push_back(at_height(high_m, 0.02 * radius_m));
    return sections;
}

} // namespace

Shape tree_shape(const TreeSize& size, Detail detail, SeededNumbers& numbers) {
    const bool fine = detail == Detail::fine;
    const double crown_m = size.height_m - size.crown_base_m;
    const double radius_m = 0.5 * size.crown_diameter_m;
    const double trunk_m = 0.5 * size.trunk_diameter_m;
    Shape shape = tube(std::vector{at_height(-roots_m, trunk_m),
                                   at_height(size.crown_base_m + 0.5 * crown_m, 0.6 * trunk_m)},
                       fine ? 10 : 5);
    if (size.species == Species::conifer) {
        shape.append(leaves(tiers(size.crown_base_m, size.height_m, radius_m, fine ? 5 : 3),
                            fine ? 14 : 7, 0.25, numbers));
    } else {
        shape.append(leaves(egg(size.crown_base_m, size.height_m, radius_m, 0.45, fine ? 9 : 5),
                            fine ? 14 : 7, 0.25, numbers));
    }
    return shape;
}

Shape bush_shape(double height_m, double diameter_m, SeededNumbers& numbers) {
    return leaves(egg(-0.1, height_m, 0.5 * diameter_m, 0.4, 7), 12, 0.2, numbers);
}

} // namespace zonegrid
