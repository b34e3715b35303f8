#pragma once

#include "simulation/plants.h"
#include "simulation/scene_keys.h"
#include "simulation/world.h"

#include <optional>

namespace zonegrid {

/// The trees that a table describes; what is not given follows from a tree's height.
struct TreePlan {
    std::optional<Species> species{Species::broadleaf}; ///< absent: either, by chance
    Span height_m{6.0, 10.0};
    std::optional<Span> crown_diameter_m;
    std::optional<Span> crown_base_m;
    std::optional<Span> trunk_diameter_m;
};

[[nodiscard]] TreePlan read_tree_plan(DescriptionTable& table);

/// One such tree on the ground of the world; its name is still missing.
[[nodiscard]] Thing tree_of(const TreePlan& plan, Detail detail, SeededNumbers& numbers,
                            const World& world, const Eigen::Vector2d& place_m, double texture);

} // namespace zonegrid
