#include "support/scenes.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace zonegrid::scenes {

namespace {

std::size_t pixels_of(const Camera& camera) {
    return static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
}

std::string text_of(const CellIndex& cell) {
    std::ostringstream text;
    text << '(' << cell.x << ", " << cell.y << ", " << cell.z << ')';
    return text.str();
}

std::string parted_members(const Object& expected, const Object& actual) {
    std::string members;
    const auto note = [&](bool equal, const char* member) {
        members += equal ? "" : std::string(" ") + member;
    };
    note(expected.id == actual.id, "id");
    note(expected.cell_count == actual.cell_count, "cell_count");
    note(expected.box_min == actual.box_min && expected.box_max == actual.box_max, "box");
    note(expected.cell_sum == actual.cell_sum, "cell_sum");
    note(expected.octree == actual.octree, "octree");
    note(expected.prism == actual.prism, "prism");
    return members;
}

} // namespace

Camera forward_camera(int width_px, int height_px, double focal_px) {
    Camera camera;
    camera.width_px = width_px;
    camera.height_px = height_px;
    camera.fx_px = focal_px;
    camera.fy_px = focal_px;
    camera.cx_px = 0.5 * (width_px - 1);
    camera.cy_px = 0.5 * (height_px - 1);
    camera.body_from_camera.linear() = body_from_forward_camera();
    return camera;
}

NavigationSample resting_at(double time_s, const Eigen::Vector3d& position_m, double yaw_rad) {
    NavigationSample sample;
    sample.time_s = time_s;
    sample.position_m = position_m;
    sample.world_from_body = attitude_from_euler(0.0, 0.0, yaw_rad);
    return sample;
}

std::vector<float> flat_image(const Camera& camera, float depth_m) {
    return std::vector<float>(pixels_of(camera), depth_m);
}

std::vector<float> blind_image(const Camera& camera) {
    return flat_image(camera, std::numeric_limits<float>::quiet_NaN());
}

ImageResult show(Mapper& mapper, double time_s, const Eigen::Vector3d& position_m,
                 std::span<const float> depth_m, double yaw_rad) {
    mapper.add_navigation(resting_at(time_s, position_m, yaw_rad));
    return mapper.add_image({time_s, depth_m});
}

std::vector<CellIndex> box_of_cells(const CellIndex& low, const CellIndex& high) {
    return cells_where(low, high, [](const CellIndex&) { return true; });
}

std::vector<CellIndex> cells_where(const CellIndex& low, const CellIndex& high,
                                   const std::function<bool(const CellIndex&)>& wanted) {
    std::vector<CellIndex> cells;
    for (std::int32_t x = low.x; x <= high.x; ++x) {
        for (std::int32_t y = low.y; y <= high.y; ++y) {
            for (std::int32_t z = low.z; z <= high.z; ++z) {
                if (wanted({x, y, z})) {
                    cells.push_back({x, y, z});
                }
            }
        }
    }
    return cells;
}

std::map<ZoneIndex, ZoneBits> zones_of(std::span<const CellIndex> cells, int zone_edge) {
    std::map<ZoneIndex, ZoneBits> zones;
    for (const auto& cell : cells) {
        zones.try_emplace(zone_of(cell, zone_edge), zone_edge)
            .first->second.set(index_in_zone(cell, zone_edge));
    }
    return zones;
}

std::map<CellIndex, int> values_of(const Mapper& mapper) {
    std::map<CellIndex, int> values;
    mapper.for_each_cell([&](const CellIndex& cell, int value) { values.emplace(cell, value); });
    return values;
}

std::string difference(std::span<const CellIndex> expected, std::span<const CellIndex> actual) {
    const auto [e, a] = std::ranges::mismatch(expected, actual);
    if (e == expected.end() && a == actual.end()) {
        return "";
    }
    std::ostringstream text;
    text << expected.size() << " cells expected, " << actual.size() << " found; at place "
         << e - expected.begin() << ": expected " << (e == expected.end() ? "none" : text_of(*e))
         << ", found " << (a == actual.end() ? "none" : text_of(*a));
    return text.str();
}

std::string difference(std::span<const Object> expected, std::span<const Object> actual) {
    const auto [e, a] = std::ranges::mismatch(expected, actual);
    if (e == expected.end() && a == actual.end()) {
        return "";
    }
    std::ostringstream text;
    text << expected.size() << " objects expected, " << actual.size() << " found; at place "
         << e - expected.begin() << ": expected " << (e == expected.end() ? "none" : text_of(e->id))
         << ", found " << (a == actual.end() ? "none" : text_of(a->id));
    if (e != expected.end() && a != actual.end()) {
        text << "; other in:" << parted_members(*e, *a);
    }
    return text.str();
}

} // namespace zonegrid::scenes
