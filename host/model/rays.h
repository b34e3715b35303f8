#pragma once

#include "model/view.h"
#include "model/window.h"
#include "zonegrid/options.h"
#include "zonegrid/sensors.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zonegrid {

/// What a pixel says, in sub-cells along the optical axis.
struct PixelDepth {
    std::int32_t near = -1; ///< free space ends here; -1: the pixel is missing
    std::int32_t far = -1;  ///< the obstacle ends here; -1: there is none
    friend auto operator<=>(const PixelDepth&, const PixelDepth&) = default;
};

/// One depth image in integers: all that decides its cells.
struct ImageRays {
    std::int32_t width_px = 0;
    std::int32_t height_px = 0;
    SubPoint origin;                   ///< camera centre, window-relative
    Direction a;                       ///< direction of pixel (0, 0)
    Direction u;                       ///< added per pixel to the right
    Direction v;                       ///< added per pixel down
    std::vector<Direction> directions; ///< by pixel if the camera is no ideal pinhole, else empty
    std::vector<PixelDepth> depths;    ///< [v][u]
    bool spanned = false;              ///< `span`: sub-rays fill the pixel's pyramid
    std::int32_t spacing = 0;          ///< depth at which neighbouring rays are one cell apart
    View view;

    /// Direction through the centre of pixel (u_px, v_px).
    [[nodiscard]] Direction direction(std::int32_t u_px, std::int32_t v_px) const {
        if (!directions.empty()) {
            return directions[static_cast<std::size_t>(v_px) * static_cast<std::size_t>(width_px) +
                              static_cast<std::size_t>(u_px)];
        }
        return {a.x + u_px * u.x + v_px * v.x, a.y + u_px * u.y + v_px * v.y,
                a.z + u_px * u.z + v_px * v.z};
    }

    /// The point at `depth` along `direction`.
    [[nodiscard]] SubPoint point_at(const Direction& direction, std::int32_t depth) const {
        const auto reach = [depth](std::int32_t component) {
            return static_cast<std::int32_t>((std::int64_t{component} * depth) >>
                                             ZG_DIRECTION_BITS);
        };
        return {origin.x + reach(direction.x), origin.y + reach(direction.y),
                origin.z + reach(direction.z)};
    }
};

/// One ray of a scan, window-relative.
struct ScanRay {
    SubPoint start;
    SubPoint end;
    bool hit = false; ///< an obstacle at the end
};

struct ScanRays {
    std::vector<ScanRay> rays;
    std::uint64_t missing = 0;
    std::uint64_t dropped = 0; ///< start or end outside the window
};

/// The cell of a world position, or nothing if it is not finite or more than 2^30 cells away.
[[nodiscard]] std::optional<CellIndex> cell_of(const Eigen::Vector3d& position_m, double cell_m);

/// Sub-cell of a world position relative to the window's first cell, or nothing if it lies outside
/// the window or is not finite.
[[nodiscard]] std::optional<SubPoint> window_relative(const Eigen::Vector3d& position_m,
                                                      double cell_m, const Window& window);

/// Throws UsageError if the camera's size, focal lengths, principal point, number of directions or
/// stereo noise cannot work, naming the field. Must pass before a window is made for the camera.
void check_camera(const Camera& camera);

/// Turns depth images into integers (docs/model.md, section 3). Keeps what depends on camera and
/// options alone: the depth at which each pixel's ray reaches the range.
class ImageQuantizer {
public:
    /// Throws UsageError as `check_camera` does, or if a pixel looks too far off the axis.
    ImageQuantizer(const Camera& camera, const MapperOptions& options);

    /// `depth_m` as in DepthImage; the window holds the camera's reach. Fills `rays`, whose memory
    /// is used again.
    void quantize(std::span<const float> depth_m, const Eigen::Isometry3d& world_from_camera,
                  const Window& window, ImageRays& rays) const;

private:
    [[nodiscard]] PixelDepth quantize_depth(float depth_m, std::int32_t limit) const;
    void place_camera(const Eigen::Isometry3d& world_from_camera, const Window& window,
                      ImageRays& rays) const;
    /// What the pixels that are not missing see, of `rays` whose depths and origin are set.
    [[nodiscard]] View view(const Eigen::Matrix3d& rotation, const ImageRays& rays) const;

    Camera camera_;
    double cell_m_;
    bool spanned_;
    double sub_per_m_;
    double range_cells_;
    double spread_per_m2_ = 0.0; ///< sub-cells of spread per square metre of depth
    std::vector<std::int32_t> limits_;
};

/// Throws UsageError if starts are given but not one for each end.
void check_scan(const Scan& scan);

/// Turns a scan into integers (docs/model.md, section 3). Throws as `check_scan` does.
[[nodiscard]] ScanRays quantize_scan(const Scan& scan, const Eigen::Isometry3d& world_from_sensor,
                                     const MapperOptions& options, const Window& window);

} // namespace zonegrid
