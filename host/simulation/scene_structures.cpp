#include "simulation/scene_keys.h"
#include "simulation/scene_tables.h"
#include "simulation/structures.h"

#include <algorithm>
#include <array>

namespace zonegrid {
namespace {

constexpr Span size_limits{0.1, 1000.0};

enum class MastModel { pole, lattice };

void read_building(DescriptionTable& table, World& world) {
    const Eigen::Vector2d place_m = read_place(table);
    BuildingSize size;
    size.length_m = read_number(table, "length_m", size_limits);
    size.width_m = read_number(table, "width_m", size_limits);
    size.eaves_m = read_number(table, "height_m", size_limits);
    size.roof = read_choice(table, "roof",
                            std::array{std::pair{std::string_view("flat"), Roof::flat},
                                       std::pair{std::string_view("gable"), Roof::gable}});
    if (size.roof == Roof::gable) {
        size.ridge_m =
            size.eaves_m + read_number(table, "roof_m", {0.01, 100.0}, 0.35 * size.width_m);
    }
    const Eigen::Isometry3d placed = world.on_ground(place_m, read_angle_rad(table, "yaw_deg"));
    double ground_m = placed.translation().z(); // lowest ground under the corners, down
    for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
            const Eigen::Vector3d corner =
                placed * Eigen::Vector3d(x * size.length_m, y * size.width_m, 0.0);
            ground_m = std::max(ground_m, -world.terrain().height_m(corner.x(), corner.y()));
        }
    }
    size.foundation_m += ground_m - placed.translation().z();
    Thing thing{{}, ObstacleKind::building, {}, read_texture(table), false};
    thing.shape.append(building_shape(size), placed);
    world.add_named(table, "building", std::move(thing));
    table.require_all_read();
}

/// A point whose third number is its height above the ground there.
Eigen::Vector3d read_end_m(DescriptionTable& table, std::string_view key, const World& world) {
    const Eigen::Vector3d end = read_point<3>(table, key, "[north, east, height] in m");
    return world.on_ground(end.head<2>(), 0.0, end.z()).translation();
}

void read_wire(DescriptionTable& table, World& world) {
    const Eigen::Vector3d start_m = read_end_m(table, "start_m", world);
    const Eigen::Vector3d end_m = read_end_m(table, "end_m", world);
    const double span_m = (end_m - start_m).norm();
    if (!((end_m - start_m).head<2>().norm() > 0.1)) {
        table.refuse("end_m", "is above or at start_m", "stretch the wire over at least 0.1 m");
    }
    const double sag_m = read_number(table, "sag_m", {0.0, span_m}, 0.02 * span_m);
    const double diameter_m = read_number(table, "diameter_m", {0.001, 1.0}, 0.02);
    Thing thing{{},
                ObstacleKind::wire,
                wire_shape(start_m, end_m, std::max(sag_m, 1e-4 * span_m), diameter_m),
                read_texture(table),
                false};
    world.add_named(table, "wire", std::move(thing));
    table.require_all_read();
}

void read_mast(DescriptionTable& table, World& world) {
    const Eigen::Vector2d place_m = read_place(table);
    const double height_m = read_number(table, "height_m", size_limits);
    const auto model =
        read_choice(table, "model",
                    std::array{std::pair{std::string_view("pole"), MastModel::pole},
                               std::pair{std::string_view("lattice"), MastModel::lattice}});
    const bool pole = model == MastModel::pole;
    const double width_m =
        read_number(table, "width_m", {0.02, 0.5 * height_m}, pole ? 0.3 : 0.08 * height_m);
    Thing thing{{}, ObstacleKind::mast, {}, read_texture(table), false};
    thing.shape.append(pole ? pole_shape(height_m, width_m) : lattice_mast_shape(height_m, width_m),
                       world.on_ground(place_m, read_angle_rad(table, "yaw_deg")));
    world.add_named(table, "mast", std::move(thing));
    table.require_all_read();
}

void read_tunnel(DescriptionTable& table, World& world) {
    std::vector<DescriptionTable> points = table.tables("point");
    if (points.size() < 2) {
        table.refuse("point", fmt::format("comes {} times", points.size()),
                     "give at least two, each as [[tunnel.point]]");
    }
    std::vector<Eigen::Vector3d> way_m;
    for (DescriptionTable& point : points) {
        const Eigen::Vector2d place_m = read_place(point);
        way_m.emplace_back(place_m.x(), place_m.y(), -read_number(point, "height_m", {-1e4, 1e4}));
        if (way_m.size() > 1 && !((way_m.back() - way_m[way_m.size() - 2]).norm() > 0.1)) {
            point.refuse("north_m", "is less than 0.1 m from the point before", "remove one");
        }
        point.require_all_read();
    }
    const double diameter_m = read_number(table, "diameter_m", {0.5, 100.0});
    const double wall_m = read_number(table, "wall_m", {0.01, 10.0}, 0.3);
    world.add_named(table, "tunnel",
                    {{},
                     ObstacleKind::other,
                     tunnel_shape(way_m, diameter_m, wall_m),
                     read_texture(table),
                     false});
    table.require_all_read();
}

} // namespace

void read_structures(DescriptionTable& root, World& world) {
    for (DescriptionTable& table : root.tables("building")) {
        read_building(table, world);
    }
    for (DescriptionTable& table : root.tables("wire")) {
        read_wire(table, world);
    }
    for (DescriptionTable& table : root.tables("mast")) {
        read_mast(table, world);
    }
    if (std::optional<DescriptionTable> table = root.table("tunnel")) {
        read_tunnel(*table, world);
    }
}

} // namespace zonegrid
