#include "simulation/scene_plants.h"

#include "simulation/scene_tables.h"

#include <array>

namespace zonegrid {
namespace {

constexpr Span plant_limits{0.1, 100.0};

std::optional<Span> read_size(DescriptionTable& table, std::string_view key) {
    return read_span(table, key, plant_limits);
}

/// The bushes that a table describes.
struct BushPlan {
    Span height_m{1.0, 2.0};
    std::optional<Span> diameter_m;
};

BushPlan read_bush_plan(DescriptionTable& table) {
    BushPlan plan;
    plan.height_m = read_size(table, "height_m").value_or(plan.height_m);
    plan.diameter_m = read_size(table, "diameter_m");
    return plan;
}

Thing bush_of(const BushPlan& plan, SeededNumbers& numbers, const World& world,
              const Eigen::Vector2d& place_m, double texture) {
    const double height_m = plan.height_m.draw(numbers);
    const double diameter_m = plan.diameter_m ? plan.diameter_m->draw(numbers) : 1.2 * height_m;
    Thing thing{{}, ObstacleKind::bush, {}, texture, false};
    thing.shape.append(bush_shape(height_m, diameter_m, numbers), world.on_ground(place_m));
    return thing;
}

void read_row(DescriptionTable& table, SeededNumbers numbers, World& world) {
    const auto kind =
        read_choice(table, "of",
                    std::array{std::pair{std::string_view("tree"), ObstacleKind::tree},
                               std::pair{std::string_view("bush"), ObstacleKind::bush}});
    const auto start_m = read_point<2>(table, "start_m", "[north, east] in m");
    const auto end_m = read_point<2>(table, "end_m", "[north, east] in m");
    if (start_m == end_m) {
        table.refuse("end_m", "is start_m", "give the last plant a place of its own");
    }
    const int number = read_count(table, "number", 2, 10000);
    const double texture = read_texture(table);
    const bool trees = kind == ObstacleKind::tree;
    const TreePlan tree_plan = trees ? read_tree_plan(table) : TreePlan{};
    const BushPlan bush_plan = trees ? BushPlan{} : read_bush_plan(table);
    table.require_all_read();
    for (int i = 0; i < number; ++i) {
        const Eigen::Vector2d place_m = start_m + (end_m - start_m) * i / (number - 1);
        if (trees) {
            world.add_numbered("tree",
                               tree_of(tree_plan, Detail::fine, numbers, world, place_m, texture));
        } else {
            world.add_numbered("bush", bush_of(bush_plan, numbers, world, place_m, texture));
        }
    }
}

} // namespace

TreePlan read_tree_plan(DescriptionTable& table) {
    TreePlan plan;
    plan.species = read_choice(
        table, "species",
        std::array{std::pair{std::string_view("broadleaf"), std::optional(Species::broadleaf)},
                   std::pair{std::string_view("conifer"), std::optional(Species::conifer)},
                   std::pair{std::string_view("mixed"), std::optional<Species>()}});
    plan.height_m = read_size(table, "height_m").value_or(plan.height_m);
    plan.crown_diameter_m = read_size(table, "crown_diameter_m");
    plan.crown_base_m = read_size(table, "crown_base_m");
    plan.trunk_diameter_m = read_span(table, "trunk_diameter_m", {0.01, 20.0});
    if (plan.crown_base_m && plan.crown_base_m->high > 0.9 * plan.height_m.low) {
        table.refuse("crown_base_m", fmt::format("is up to {}", plan.crown_base_m->high),
                     fmt::format("the crown must begin below 0.9 of the least height ({} m)",
                                 plan.height_m.low));
    }
    return plan;
}

Thing tree_of(const TreePlan& plan, Detail detail, SeededNumbers& numbers, const World& world,
              const Eigen::Vector2d& place_m, double texture) {
    TreeSize size;
    size.species =
        plan.species.value_or(numbers.chance(0.5) ? Species::conifer : Species::broadleaf);
    size.height_m = plan.height_m.draw(numbers);
    const bool conifer = size.species == Species::conifer;
    const auto drawn = [&](const std::optional<Span>& span, double share_of_height) {
        return span ? span->draw(numbers) : share_of_height * size.height_m;
    };
    size.crown_diameter_m = drawn(plan.crown_diameter_m, conifer ? 0.4 : 0.55);
    size.crown_base_m = drawn(plan.crown_base_m, conifer ? 0.15 : 0.3);
    size.trunk_diameter_m = drawn(plan.trunk_diameter_m, 0.045);
    Thing thing{{}, ObstacleKind::tree, {}, texture, false};
    thing.shape.append(tree_shape(size, detail, numbers), world.on_ground(place_m));
    return thing;
}

void read_plants(DescriptionTable& root, std::uint64_t seed, World& world) {
    std::size_t index = 0;
    for (DescriptionTable& table : root.tables("tree")) {
        SeededNumbers numbers = numbers_of(seed, Draw::tree, index++);
        const Eigen::Vector2d place_m = read_place(table);
        const TreePlan plan = read_tree_plan(table);
        world.add_named(table, "tree",
                        tree_of(plan, Detail::fine, numbers, world, place_m, read_texture(table)));
        table.require_all_read();
    }
    index = 0;
    for (DescriptionTable& table : root.tables("bush")) {
        SeededNumbers numbers = numbers_of(seed, Draw::bush, index++);
        const Eigen::Vector2d place_m = read_place(table);
        const BushPlan plan = read_bush_plan(table);
        world.add_named(table, "bush", bush_of(plan, numbers, world, place_m, read_texture(table)));
        table.require_all_read();
    }
    index = 0;
    for (DescriptionTable& table : root.tables("row")) {
        read_row(table, numbers_of(seed, Draw::row, index++), world);
    }
}

} // namespace zonegrid
