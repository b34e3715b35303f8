#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace zonegrid {

/// Triangles of one thing in its own frame: forward, right, down in metres, 0 where it stands. Seen
/// from outside a triangle's corners turn counter-clockwise: (b - a) x (c - a) points outward.
struct Shape {
    std::vector<Eigen::Vector3d> vertices_m;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    void append(const Shape& other,
                const Eigen::Isometry3d& placed = Eigen::Isometry3d::Identity());
};

/// A closed line of points around a solid, counter-clockwise seen against the direction in which
/// the rings follow each other.
using Ring = std::vector<Eigen::Vector3d>;

enum class Ends {
    capped, ///< by a fan around each end's mean point: for rings that are convex
    joined  ///< the last ring is joined to the first
};

/// A closed solid whose skin runs over the rings, all of the same size of at least 3.
[[nodiscard]] Shape lofted(std::span<const Ring> rings, Ends ends = Ends::capped);

/// A cross-section of a tube.
struct Section {
    Eigen::Vector3d centre_m;
    double radius_m;
};

/// The regular rings of a round tube through the sections, each at right angles to the way. The
/// radius of every point is multiplied by `roughness`, which is called once per point in order.
[[nodiscard]] std::vector<Ring> tube_rings(
    std::span<const Section> sections, int sides,
    const std::function<double()>& roughness = [] { return 1.0; });

/// A solid tube with flat ends.
[[nodiscard]] Shape tube(std::span<const Section> sections, int sides);

/// A box between two corners, `least` below `most` in each axis.
[[nodiscard]] Shape box(const Eigen::Vector3d& least_m, const Eigen::Vector3d& most_m);

/// Volume inside the triangles; above 0 for a closed shape whose triangles face outward.
[[nodiscard]] double volume_m3(const Shape& shape);

} // namespace zonegrid
