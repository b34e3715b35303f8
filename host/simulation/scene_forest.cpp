#include "simulation/scene_plants.h"
#include "simulation/scene_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace zonegrid {
namespace {

constexpr int tries_per_tree = 200;

double distance_to_leg_m(const Eigen::Vector2d& place_m, const Eigen::Vector2d& start_m,
                         const Eigen::Vector2d& end_m) {
    const Eigen::Vector2d leg = end_m - start_m;
    const double length2 = leg.squaredNorm();
    const double share =
        length2 > 0.0 ? std::clamp((place_m - start_m).dot(leg) / length2, 0.0, 1.0) : 0.0;
    return (place_m - start_m - share * leg).norm();
}

bool is_clear_of(const std::vector<Route>& routes, const Eigen::Vector2d& place_m,
                 double clearance_m) {
    for (const Route& route : routes) {
        const std::vector<Waypoint>& points = route.waypoints;
        for (std::size_t i = route.loop ? 0 : 1; i < points.size(); ++i) {
            const Waypoint& before = points[i == 0 ? points.size() - 1 : i - 1];
            if (distance_to_leg_m(place_m, before.position_m.head<2>(),
                                  points[i].position_m.head<2>()) < clearance_m) {
                return false;
            }
        }
    }
    return true;
}

/// Places that keep their distance from each other.
class SpacedPlaces {
public:
    explicit SpacedPlaces(double spacing_m) : spacing_m_(spacing_m) {}

    /// Adds the place unless it is too close to one before.
    bool add(const Eigen::Vector2d& place_m) {
        const auto row = static_cast<long>(std::floor(place_m.x() / spacing_m_));
        const auto column = static_cast<long>(std::floor(place_m.y() / spacing_m_));
        for (long i = row - 1; i <= row + 1; ++i) {
            for (long k = column - 1; k <= column + 1; ++k) {
                const auto found = squares_.find({i, k});
                if (found == squares_.end()) {
                    continue;
                }
                for (const Eigen::Vector2d& other : found->second) {
                    if ((other - place_m).norm() < spacing_m_) {
                        return false;
                    }
                }
            }
        }
        squares_[{row, column}].push_back(place_m);
        return true;
    }

private:
    double spacing_m_;
    std::map<std::pair<long, long>, std::vector<Eigen::Vector2d>> squares_;
};

Span read_side(DescriptionTable& table, std::string_view key) {
    const std::optional<Span> side = read_span(table, key, place_limits);
    if (!side) {
        table.refuse_absent(key);
    }
    return *side;
}

void read_forest(DescriptionTable& table, SeededNumbers numbers, const std::vector<Route>& routes,
                 World& world) {
    const int number = read_count(table, "number", 1, 100000);
    const Span north = read_side(table, "north_m");
    const Span east = read_side(table, "east_m");
    const double spacing_m = read_number(table, "spacing_m", {0.1, 1000.0}, 3.0);
    const double clearance_m = read_number(table, "route_clearance_m", {0.0, 1000.0}, 0.0);
    const double texture = read_texture(table);
    const TreePlan plan = read_tree_plan(table);
    table.require_all_read();
    SpacedPlaces places(spacing_m);
    int placed = 0;
    for (int tries = 0; placed < number && tries < tries_per_tree * number; ++tries) {
        const double north_m = north.draw(numbers);
        const Eigen::Vector2d place_m(north_m, east.draw(numbers));
        if (is_clear_of(routes, place_m, clearance_m) && places.add(place_m)) {
            world.add_numbered("tree",
                               tree_of(plan, Detail::coarse, numbers, world, place_m, texture));
            ++placed;
        }
    }
    if (placed < number) {
        table.refuse("number", fmt::format("is {}, but only {} trees found room", number, placed),
                     "give fewer trees, a wider area or a smaller spacing_m");
    }
}

} // namespace

void read_forests(DescriptionTable& root, std::uint64_t seed, const std::vector<Route>& routes,
                  World& world) {
    std::size_t index = 0;
    for (DescriptionTable& table : root.tables("forest")) {
        read_forest(table, numbers_of(seed, Draw::forest, index++), routes, world);
    }
}

} // namespace zonegrid
