#pragma once

#include "truth/surfaces.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace zonegrid {

/// What Embree found along a ray.
struct TriangleHit {
    float distance = 0.0F;  ///< in the ray's steps
    std::uint32_t part = 0; ///< TriangleScene::still_part, or 1 + number of the moving part
    std::uint32_t triangle = std::numeric_limits<std::uint32_t>::max(); ///< in the part; max: none
};

/// Embree's scene: one part of triangles that stay, and parts that move as a whole.
///
/// The same rays give the same hits on every run: its trees are built by one thread, and nothing
/// beyond AVX2 is used, so that newer processors compute as older ones do.
class TriangleScene {
public:
    static constexpr std::uint32_t still_part = 0;

    TriangleScene();
    TriangleScene(const TriangleScene&) = delete;
    TriangleScene& operator=(const TriangleScene&) = delete;
    ~TriangleScene();

    /// The part that stays; called once, first. `triangles` are indices into the surfaces'.
    void add_triangles(const Surfaces& surfaces, std::vector<std::uint32_t> triangles);
    /// The next part that moves, at the origin until it is placed.
    void add_moving_triangles(const Surfaces& surfaces, std::vector<std::uint32_t> triangles);
    /// Puts moving part `number` (from 0) in its place. Takes effect with `commit`.
    void place(std::size_t number, const Eigen::Isometry3d& world_from_part);
    /// Throws DeviceError if Embree has no memory.
    void commit();

    /// The surfaces' triangle that was hit.
    [[nodiscard]] std::uint32_t triangle_of(const TriangleHit& hit) const {
        return triangles_[hit.part][hit.triangle];
    }

    [[nodiscard]] std::optional<TriangleHit> cast(const Eigen::Vector3f& start_m,
                                                  const Eigen::Vector3f& direction) const;
    /// Casts rays from one start that lie side by side. Safe for concurrent calls.
    void cast_row(const Eigen::Vector3f& start_m, std::span<const Eigen::Vector3f> directions,
                  std::span<TriangleHit> hits) const;

private:
    class Handles;
    std::unique_ptr<Handles> handles_;
    std::vector<std::vector<std::uint32_t>> triangles_; ///< by part
};

} // namespace zonegrid
