#include "evaluation/small_truth.h"

#include "truth/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace zonegrid::testing {

void add_rectangle(Surfaces& surfaces, const std::array<Eigen::Vector3f, 4>& corners) {
    const auto first = static_cast<std::uint32_t>(surfaces.vertices_m.size());
    surfaces.vertices_m.insert(surfaces.vertices_m.end(), corners.begin(), corners.end());
    surfaces.triangles.push_back({first, first + 1, first + 2});
    surfaces.triangles.push_back({first, first + 2, first + 3});
}

void add_box(Surfaces& surfaces, const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3;
        const int last = (axis + 2) % 3;
        for (const auto& side : {low, high}) {
            std::array<Eigen::Vector3f, 4> corners;
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i][axis] = side[axis];
                corners[i][next] = (i == 1 || i == 2 ? high : low)[next];
                corners[i][last] = (i >= 2 ? high : low)[last];
            }
            add_rectangle(surfaces, corners);
        }
    }
}

void end_obstacle(Surfaces& surfaces, const std::string& name, ObstacleKind kind, bool moving) {
    TrueObstacle obstacle{name, kind, 0, 0, moving};
    if (!surfaces.obstacles.empty()) {
        const auto& before = surfaces.obstacles.back();
        obstacle.first_triangle = before.first_triangle + before.triangles;
    }
    obstacle.triangles =
        static_cast<std::uint32_t>(surfaces.triangles.size()) - obstacle.first_triangle;
    surfaces.obstacles.push_back(obstacle);
}

Camera north_camera() {
    Camera camera;
    camera.width_px = camera.height_px = 128;
    camera.fx_px = camera.fy_px = 64.0;
    camera.cx_px = camera.cy_px = 63.5;
    camera.body_from_camera.linear() = body_from_forward_camera();
    return camera;
}

TrueImage looking_north(double time_s, const Eigen::Vector3d& place_m) {
    TrueImage image;
    image.time_s = time_s;
    image.world_from_camera.linear() = body_from_forward_camera();
    image.world_from_camera.translation() = place_m;
    return image;
}

Truth wall_and_box() {
    Truth truth;
    truth.scene = "wall and box";
    truth.camera = north_camera();
    add_rectangle(truth.surfaces, {Eigen::Vector3f(10.5F, -4.4F, -4.4F),
                                   {10.5F, 5.4F, -4.4F},
                                   {10.5F, 5.4F, 5.4F},
                                   {10.5F, -4.4F, 5.4F}});
    end_obstacle(truth.surfaces, "wall", ObstacleKind::building);
    add_box(truth.surfaces, {5.5F, -0.9F, -0.9F}, {8.5F, 1.9F, 1.9F});
    end_obstacle(truth.surfaces, "box", ObstacleKind::other);
    truth.images.push_back(looking_north(1.0, {0.5, 0.5, 0.5}));
    return truth;
}

namespace {

/// Share of the ray at which it meets the triangle; infinity if it does not.
double meet(const Eigen::Vector3d& start, const Eigen::Vector3d& ray,
            const std::array<Eigen::Vector3d, 3>& corners) {
    // start + t ray = a + p (b - a) + q (c - a), solved as it stands.
    Eigen::Matrix3d columns;
    columns << -ray, corners[1] - corners[0], corners[2] - corners[0];
    if (std::abs(columns.determinant()) < 1e-12) {
        return std::numeric_limits<double>::infinity();
    }
    const Eigen::Vector3d tpq = columns.inverse() * (start - corners[0]);
    const bool inside = tpq[0] > 0.0 && tpq[1] >= 0.0 && tpq[2] >= 0.0 && tpq[1] + tpq[2] <= 1.0;
    return inside ? tpq[0] : std::numeric_limits<double>::infinity();
}

} // namespace

TrueImageDrawer draw_every_triangle(const Truth& truth) {
    return [&truth](const Camera& camera, const TrueImage& image, std::span<float> depth_m,
                    std::span<std::uint32_t> obstacles) {
        std::vector<std::array<Eigen::Vector3d, 3>> triangles;
        const auto owners = truth.surfaces.obstacle_of_triangles();
        for (std::size_t i = 0; i < owners.size(); ++i) {
            Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
            for (const auto& motion : truth.motions) {
                if (motion.obstacle == owners[i]) {
                    pose = motion.at(image.time_s);
                }
            }
            for (std::size_t k = 0; k < 3; ++k) {
                triangles.resize(i + 1);
                triangles[i][k] =
                    pose * truth.surfaces.vertices_m[truth.surfaces.triangles[i][k]].cast<double>();
            }
        }
        const Eigen::Vector3d start = image.world_from_camera.translation();
        for (std::size_t pixel = 0; pixel < depth_m.size(); ++pixel) {
            const auto width = static_cast<std::size_t>(camera.width_px);
            const Eigen::Vector3d ray =
                image.world_from_camera.linear() *
                Eigen::Vector3d((static_cast<double>(pixel % width) - camera.cx_px) / camera.fx_px,
                                (static_cast<double>(pixel / width) - camera.cy_px) / camera.fy_px,
                                1.0);
            double nearest = std::numeric_limits<double>::infinity();
            obstacles[pixel] = sky_obstacle;
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                const double t = meet(start, ray, triangles[i]);
                if (t < nearest) {
                    nearest = t;
                    obstacles[pixel] = owners[i];
                }
            }
            depth_m[pixel] = static_cast<float>(nearest);
        }
    };
}

namespace {

/// Numbers the components of a set by repeated flooding.
std::map<CellIndex, std::uint32_t> components(const CellSet& cells) {
    std::map<CellIndex, std::uint32_t> numbers;
    std::uint32_t next = 0;
    cells.for_each([&](const CellIndex& start) {
        if (numbers.contains(start)) {
            return;
        }
        std::vector<CellIndex> waiting{start};
        while (!waiting.empty()) {
            const CellIndex cell = waiting.back();
            waiting.pop_back();
            if (!cells.contains(cell) || !numbers.emplace(cell, next).second) {
                continue;
            }
            for (const int step : {-1, 1}) {
                waiting.push_back({cell.x + step, cell.y, cell.z});
                waiting.push_back({cell.x, cell.y + step, cell.z});
                waiting.push_back({cell.x, cell.y, cell.z + step});
            }
        }
        ++next;
    });
    return numbers;
}

} // namespace

JudgedMap map_of(const Truth& truth, const CellSet& occupied, const CellSet& free,
                 std::uint32_t image) {
    JudgedMap map;
    map.folder = "made by hand";
    map.cell_m = 1.0;
    map.range_m = 20.0;
    map.model = "line";
    map.frames = truth.images.size();
    map.span = {0, truth.images.size()};
    map.first_time_s = truth.images.front().time_s;
    map.last_time_s = truth.images.back().time_s;
    map.has_history = true;
    map.occupied = occupied;
    map.free = free;
    for (const auto& [cell, object] : components(occupied)) {
        map.occupied_cells.push_back({cell, object, image});
        map.ever_occupied.push_back({cell, image});
        map.objects.resize(std::max<std::size_t>(map.objects.size(), object + 1U));
        ++map.objects[object].cell_count;
    }
    return map;
}

CellSet cells_of_box(const CellIndex& low, const CellIndex& high) {
    CellSet cells;
    for (std::int32_t z = low.z; z <= high.z; ++z) {
        for (std::int32_t y = low.y; y <= high.y; ++y) {
            for (std::int32_t x = low.x; x <= high.x; ++x) {
                cells.insert({x, y, z});
            }
        }
    }
    return cells;
}

CellSet shifted(const CellSet& cells, const CellIndex& step) {
    CellSet moved;
    cells.for_each([&](const CellIndex& cell) {
        moved.insert({cell.x + step.x, cell.y + step.y, cell.z + step.z});
    });
    return moved;
}

CellSet without(const CellSet& cells, const CellSet& taken) {
    CellSet left;
    cells.for_each([&](const CellIndex& cell) {
        if (!taken.contains(cell)) {
            left.insert(cell);
        }
    });
    return left;
}

Evaluation evaluate(const JudgedMap& map, const Truth& truth) {
    return zonegrid::evaluate(map, truth, draw_every_triangle(truth), {},
                              [](std::size_t, std::size_t) {});
}

} // namespace zonegrid::testing
