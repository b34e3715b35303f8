#pragma once

#include "io/profile_perspective_grid.h"
#include "io/profile_picture_layout.h"

#include <Eigen/Core>

#include <array>

namespace zonegrid {

/// The box of the scene in metres: ground plan and heights, without exaggeration.
struct SceneBox {
    GroundPlan plan;
    double base_m = 0.0;
    double top_m = 0.0;
    double exaggeration = 1.0; ///< factor on heights when drawn
};

/// A place seen: pixels, and the reciprocal of the depth, larger when nearer.
struct SeenPoint {
    double x_px = 0.0;
    double y_px = 0.0;
    double inverse_depth = 0.0;
};

/// A camera outside the scene's box that looks down at its middle.
class PerspectiveView {
public:
    /// The camera stands in compass direction `azimuth_deg` from the middle, `elevation_deg` above
    /// it, and the box fills the frame with room for its axes.
    PerspectiveView(const SceneBox& box, const PictureFrame& frame, double azimuth_deg,
                    double elevation_deg);

    [[nodiscard]] SeenPoint project(double north_m, double east_m, double height_m) const;
    /// The camera's place: north, east, height in metres, the height with exaggeration undone.
    [[nodiscard]] const Eigen::Vector3d& eye_m() const { return eye_m_; }
    /// Unit vector to the right in the picture: north, east, up.
    [[nodiscard]] const Eigen::Vector3d& right() const { return right_; }
    /// Pixels per metre at the middle of the box.
    [[nodiscard]] double px_per_m() const { return px_per_m_; }
    /// Distance from the camera to the middle of the box, in drawn metres.
    [[nodiscard]] double distance_m() const { return distance_m_; }
    [[nodiscard]] double elevation_deg() const { return elevation_deg_; }
    [[nodiscard]] double azimuth_deg() const { return azimuth_deg_; }

private:
    double exaggeration_;
    double azimuth_deg_;
    double elevation_deg_;
    double distance_m_;
    double px_per_m_ = 1.0;
    Eigen::Vector3d eye_m_;
    Eigen::Vector3d drawn_eye_m_;
    Eigen::Vector3d right_;
    Eigen::Vector3d up_;
    Eigen::Vector3d forward_;
    double scale_px_ = 1.0;
    Eigen::Vector2d offset_px_ = Eigen::Vector2d::Zero();
};

/// The view among several azimuths and elevations that shows most of the columns, largest.
[[nodiscard]] PerspectiveView choose_view(const SceneBox& box, const PictureFrame& frame,
                                          const TileGrid& tiles);

} // namespace zonegrid
