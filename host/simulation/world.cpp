#include "simulation/world.h"

#include "io/readable_text.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <utility>

namespace zonegrid {
namespace {

constexpr double ground_margin_m = 150.0;
/// With two triangles each, some gigabytes to cast rays at.
constexpr double most_ground_nodes = 2e7;

} // namespace

void World::add_numbered(const std::string& base, Thing thing) {
    do { // a table may have given itself the next name
        thing.name = fmt::format("{} {}", base, ++last_number_[base]);
    } while (!names_.insert(thing.name).second);
    things_.push_back(std::move(thing));
}

void World::add_named(DescriptionTable& table, const std::string& base, Thing thing) {
    const std::optional<std::string> given = table.text("name");
    if (!given) {
        add_numbered(base, std::move(thing));
        return;
    }
    thing.name = readable_text(*given);
    if (thing.name.empty() || !names_.insert(thing.name).second) {
        table.refuse("name", fmt::format("is '{}'", thing.name),
                     "give a name that nothing else has");
    }
    things_.push_back(std::move(thing));
}

Eigen::Isometry3d World::on_ground(const Eigen::Vector2d& place_m, double yaw_rad,
                                   double height_m) const {
    Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
    placed.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    placed.translation() = Eigen::Vector3d(
        place_m.x(), place_m.y(), -(terrain_.height_m(place_m.x(), place_m.y()) + height_m));
    return placed;
}

void World::add_ground(const std::vector<Eigen::Vector3d>& points_m, double texture,
                       const std::string& place) {
    Eigen::AlignedBox2d area;
    for (const Eigen::Vector3d& point : points_m) {
        area.extend(Eigen::Vector2d(point.head<2>()));
    }
    for (const Thing& thing : things_) {
        if (!thing.moving) {
            for (const Eigen::Vector3d& vertex : thing.shape.vertices_m) {
                area.extend(Eigen::Vector2d(vertex.head<2>()));
            }
        }
    }
    const Eigen::Vector2d margin_m(ground_margin_m, ground_margin_m);
    const Eigen::Vector2d least_m = area.min() - margin_m;
    const Eigen::Vector2d most_m = area.max() + margin_m;
    if (const double nodes = terrain_.nodes_over(least_m, most_m); nodes > most_ground_nodes) {
        throw InputError(place, fmt::format("the ground takes {:.0f} nodes", nodes),
                         fmt::format("give a larger spacing_m, or bring things and waypoints "
                                     "closer together, so that {:.0f} suffice",
                                     most_ground_nodes));
    }
    Thing ground{"ground", ObstacleKind::ground, terrain_.ground_shape(least_m, most_m), texture,
                 false};
    things_.insert(things_.begin(), std::move(ground));
}

void World::move_into(Scene& scene) {
    Surfaces& surfaces = scene.surfaces;
    for (const Thing& thing : things_) {
        const auto first_vertex = static_cast<std::uint32_t>(surfaces.vertices_m.size());
        surfaces.obstacles.push_back(
            {thing.name, thing.kind, static_cast<std::uint32_t>(surfaces.triangles.size()),
             static_cast<std::uint32_t>(thing.shape.triangles.size()), thing.moving});
        scene.texture.push_back(thing.texture);
        for (const Eigen::Vector3d& vertex : thing.shape.vertices_m) {
            surfaces.vertices_m.push_back(vertex.cast<float>());
        }
        for (const auto& [a, b, c] : thing.shape.triangles) {
            surfaces.triangles.push_back({first_vertex + a, first_vertex + b, first_vertex + c});
        }
    }
    things_.clear();
}

} // namespace zonegrid
