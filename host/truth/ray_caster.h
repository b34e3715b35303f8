#pragma once

#include "truth/surfaces.h"
#include "truth/truth_folder.h"
#include "zonegrid/sensors.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace zonegrid {

/// Where a ray meets the first surface.
struct SurfaceHit {
    double distance_m = 0.0;
    std::uint32_t obstacle = 0;                       ///< index into Surfaces::obstacles
    Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< unit, world frame, either side
};

/// No obstacle: the pixel sees the sky.
inline constexpr std::uint32_t sky_obstacle = 0xffffffffU;

/// Casts rays at the surfaces of a world (Embree). The surfaces must outlive it.
class RayCaster {
public:
    explicit RayCaster(const Surfaces& surfaces, std::span<const ObstacleMotion> motions = {});
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;
    ~RayCaster();

    /// Puts the moving obstacles where they are at `time_s`.
    void move_to(double time_s);

    /// First surface along the unit vector `direction`, if any.
    [[nodiscard]] std::optional<SurfaceHit> cast(const Eigen::Vector3d& start_m,
                                                 const Eigen::Vector3d& direction) const;

    /// The exact depth image of an ideal pinhole `camera` (its mounting is not used), `[v][u]`,
    /// metres along the optical axis, +infinity where no surface is. `obstacles` gets the obstacle
    /// of each pixel or `sky_obstacle`; it may be empty. Runs on all cores.
    void draw(const Camera& camera, const Eigen::Isometry3d& world_from_camera,
              std::span<float> depth_m, std::span<std::uint32_t> obstacles = {}) const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace zonegrid
