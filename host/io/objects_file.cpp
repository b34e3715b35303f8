#include "io/objects_file.h"

#include "io/file_bytes.h"
#include "io/hexadecimal.h"
#include "io/output_file.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

namespace zonegrid {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format_version = 1;

Json triple(const CellIndex& cell) {
    return Json::array({cell.x, cell.y, cell.z});
}

Json triple(const Eigen::Vector3d& point) {
    return Json::array({point.x(), point.y(), point.z()});
}

CellIndex cell_of_triple(const Json& json) {
    const auto axes = json.get<std::array<std::int32_t, 3>>();
    return {axes[0], axes[1], axes[2]};
}

Eigen::Vector3d corner_m(const CellIndex& cell, int step, double cell_m) {
    return Eigen::Vector3d(cell.x + step, cell.y + step, cell.z + step) * cell_m;
}

Json json_of(const Object& object, double cell_m) {
    Json json;
    json["id"] = triple(object.id);
    json["cells"] = object.cell_count;
    json["box_cells"] = {{"min", triple(object.box_min)}, {"max", triple(object.box_max)}};
    json["box_m"] = {{"min", triple(corner_m(object.box_min, 0, cell_m))},
                     {"max", triple(corner_m(object.box_max, 1, cell_m))}};
    json["centre_m"] = triple(object.centre_m(cell_m));
    json["cell_sum"] = object.cell_sum;
    json["prism_height_m"] = {{"lowest", cell_m * (-1 - object.box_max.z)},
                              {"highest", cell_m * -object.box_min.z}};
    json["octree"] = to_hexadecimal(object.octree);
    json["prism"] = to_hexadecimal(object.prism);
    return json;
}

std::vector<std::uint8_t> tree_of(const Json& json) {
    std::optional<std::vector<std::uint8_t>> bytes =
        from_hexadecimal(json.get_ref<const std::string&>());
    if (!bytes) {
        throw std::invalid_argument("a tree is not written in hexadecimal digits");
    }
    return std::move(*bytes);
}

Object object_of(const Json& json) {
    Object object;
    object.id = cell_of_triple(json.at("id"));
    object.cell_count = json.at("cells").get<std::uint64_t>();
    object.box_min = cell_of_triple(json.at("box_cells").at("min"));
    object.box_max = cell_of_triple(json.at("box_cells").at("max"));
    object.cell_sum = json.at("cell_sum").get<std::array<std::int64_t, 3>>();
    object.octree = tree_of(json.at("octree"));
    object.prism = tree_of(json.at("prism"));
    return object;
}

} // namespace

void write_objects_file(const std::filesystem::path& file, std::span<const Object> objects,
                        double cell_m) {
    OutputFile output(file);
    output.write(fmt::format("{{\"version\": {}, \"cell_m\": {}, \"objects\": [", format_version,
                             Json(cell_m).dump()));
    const char* separator = "\n";
    for (const Object& object : objects) {
        output.write(separator);
        output.write(json_of(object, cell_m).dump());
        separator = ",\n";
    }
    output.write(std::string_view("\n]}\n"));
    output.close();
}

std::vector<Object> read_objects_file(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    try {
        const Json json = Json::parse(bytes);
        if (json.at("version") != format_version) {
            throw std::invalid_argument(fmt::format("version {}", json.at("version").dump()));
        }
        std::vector<Object> objects;
        for (const Json& object : json.at("objects")) {
            objects.push_back(object_of(object));
        }
        return objects;
    } catch (const std::exception& error) {
        throw InputError(file.string(),
                         fmt::format("the list of objects is damaged ({})", error.what()),
                         "map the recording again");
    }
}

} // namespace zonegrid
