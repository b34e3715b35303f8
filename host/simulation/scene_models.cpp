#include "simulation/aircraft.h"
#include "simulation/mesh_file.h"
#include "simulation/scene_keys.h"
#include "simulation/scene_tables.h"

#include <array>

namespace zonegrid {
namespace {

void read_aircraft(DescriptionTable& table, World& world) {
    const auto model = read_choice(
        table, "model",
        std::array{std::pair{std::string_view("aeroplane"), AircraftModel::aeroplane},
                   std::pair{std::string_view("helicopter"), AircraftModel::helicopter}});
    const Eigen::Vector2d place_m = read_place(table);
    const double length_m = read_number(table, "length_m", {0.1, 100.0}, 8.0);
    const double span_m = read_number(table, "span_m", {0.1, 100.0}, 1.3 * length_m);
    const double height_m = read_number(table, "height_m", {0.0, 1000.0}, 0.0);
    Thing thing{{}, ObstacleKind::aircraft, {}, read_texture(table), false};
    thing.shape.append(aircraft_shape(model, length_m, span_m),
                       world.on_ground(place_m, read_angle_rad(table, "yaw_deg"),
                                       height_m + undercarriage_m(length_m)));
    world.add_named(table, "aircraft", std::move(thing));
    table.require_all_read();
}

void read_mesh(DescriptionTable& table, const std::filesystem::path& folder, World& world) {
    const std::string file = table.needed_text("file");
    const auto axes = read_choice(table, "axes",
                                  std::array{std::pair{std::string_view("z_up"), MeshAxes::z_up},
                                             std::pair{std::string_view("y_up"), MeshAxes::y_up},
                                             std::pair{std::string_view("forward_right_down"),
                                                       MeshAxes::forward_right_down}});
    const Eigen::Vector2d place_m = read_place(table);
    const double height_m = read_number(table, "height_m", {-1000.0, 1000.0}, 0.0);
    const double scale = read_number(table, "scale", {1e-6, 1e6}, 1.0);
    Shape mesh = read_mesh_file(folder / file, axes);
    for (Eigen::Vector3d& vertex : mesh.vertices_m) {
        vertex *= scale;
        if (vertex.cwiseAbs().maxCoeff() > place_limits.high) {
            table.refuse("scale", fmt::format("is {}, which puts a vertex too far out", scale),
                         fmt::format("give one that keeps the mesh within {} m of its origin",
                                     place_limits.high));
        }
    }
    Thing thing{{}, ObstacleKind::other, {}, read_texture(table), false};
    thing.shape.append(mesh, world.on_ground(place_m, read_angle_rad(table, "yaw_deg"), height_m));
    world.add_named(table, "mesh", std::move(thing));
    table.require_all_read();
}

} // namespace

void read_models(DescriptionTable& root, const std::filesystem::path& folder, World& world) {
    for (DescriptionTable& table : root.tables("aircraft")) {
        read_aircraft(table, world);
    }
    for (DescriptionTable& table : root.tables("mesh")) {
        read_mesh(table, folder, world);
    }
}

} // namespace zonegrid
