#include "truth/surfaces.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <array>
#include <set>

namespace zonegrid {
namespace {

constexpr std::array<std::string_view, 8> kind_names{"ground", "tree", "bush",     "building",
                                                     "wire",   "mast", "aircraft", "other"};

} // namespace

std::string_view name_of(ObstacleKind kind) {
    return kind_names.at(static_cast<std::size_t>(kind));
}

std::vector<std::uint32_t> Surfaces::obstacle_of_triangles() const {
    std::vector<std::uint32_t> owners(triangles.size());
    for (std::uint32_t i = 0; i < obstacles.size(); ++i) {
        const TrueObstacle& obstacle = obstacles[i];
        for (std::uint32_t k = 0; k < obstacle.triangles; ++k) {
            owners[obstacle.first_triangle + k] = i;
        }
    }
    return owners;
}

void check_surfaces(const Surfaces& surfaces, const std::string& where) {
    const auto fail = [&](const std::string& problem) {
        throw InputError(where, problem, "write the surfaces again");
    };
    for (std::size_t i = 0; i < surfaces.vertices_m.size(); ++i) {
        if (!surfaces.vertices_m[i].allFinite()) {
            fail(fmt::format("vertex {} is not finite", i));
        }
    }
    for (std::size_t i = 0; i < surfaces.triangles.size(); ++i) {
        for (const auto vertex : surfaces.triangles[i]) {
            if (vertex >= surfaces.vertices_m.size()) {
                fail(fmt::format("triangle {} names vertex {}, but there are {}", i, vertex,
                                 surfaces.vertices_m.size()));
            }
        }
    }
    std::set<std::string> names;
    std::size_t covered = 0;
    for (const TrueObstacle& obstacle : surfaces.obstacles) {
        if (obstacle.name.empty() || !names.insert(obstacle.name).second) {
            fail(fmt::format("two obstacles are named '{}', or one has no name", obstacle.name));
        }
        if (obstacle.first_triangle != covered) {
            fail(fmt::format("obstacle '{}' begins at triangle {}, the one before it ends at {}",
                             obstacle.name, obstacle.first_triangle, covered));
        }
        covered += obstacle.triangles;
    }
    if (covered != surfaces.triangles.size()) {
        fail(fmt::format("the obstacles have {} triangles, but there are {}", covered,
                         surfaces.triangles.size()));
    }
}

} // namespace zonegrid
