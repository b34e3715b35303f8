#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

/// What a truth is made of; the name is how files write it.
enum class ObstacleKind {
    ground,
    tree,
    bush,
    building,
    wire,
    mast,
    aircraft,
    other ///< meshes from files, and whatever has no kind of its own
};

[[nodiscard]] std::string_view name_of(ObstacleKind kind);

/// One thing in the world with its own place in reports: a tree, a wire, the ground.
struct TrueObstacle {
    std::string name; ///< unique in its world, such as "tree 3"
    ObstacleKind kind = ObstacleKind::other;
    std::uint32_t first_triangle = 0; ///< its triangles follow one another
    std::uint32_t triangles = 0;
    bool moving = false; ///< its vertices are in its own frame, forward-right-down
};

/// The surfaces of a world as triangles, world frame (north-east-down) in metres. Every triangle
/// belongs to exactly one obstacle, and the obstacles' triangles follow in their order.
struct Surfaces {
    std::vector<Eigen::Vector3f> vertices_m;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into vertices_m
    std::vector<TrueObstacle> obstacles;

    /// The obstacle of each triangle, as an index into `obstacles`.
    [[nodiscard]] std::vector<std::uint32_t> obstacle_of_triangles() const;
};

/// Throws InputError, naming `where`, if a vertex is not finite, an index is out of range, an
/// obstacle's name repeats or is empty, or the obstacles do not cover the triangles in order.
void check_surfaces(const Surfaces& surfaces, const std::string& where);

} // namespace zonegrid
