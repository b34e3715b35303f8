#pragma once

#include "io/profile_picture.h"
#include "io/profile_picture_range.h"

namespace zonegrid {

/// The rectangle of whole pixels that the drawing proper fills; around it stand title, axes,
/// colour bar and legend.
struct PictureFrame {
    int left_px = 0;
    int top_px = 0;
    int width_px = 0;
    int height_px = 0;
    [[nodiscard]] int right_px() const { return left_px + width_px; }
    [[nodiscard]] int bottom_px() const { return top_px + height_px; }
};

/// Where `draw_profile` puts a place of the ground plan. The frame shows more than the plan where
/// its shape differs.
struct ProfileLayout {
    PictureFrame frame;
    double px_per_m = 1.0;
    double west_m = 0.0;  ///< east coordinate of the frame's left edge
    double north_m = 0.0; ///< north coordinate of the frame's top edge

    [[nodiscard]] double x_px(double east_m) const {
        return frame.left_px + (east_m - west_m) * px_per_m;
    }
    [[nodiscard]] double y_px(double place_north_m) const {
        return frame.top_px + (north_m - place_north_m) * px_per_m;
    }
    [[nodiscard]] double east_m(double place_x_px) const {
        return west_m + (place_x_px - frame.left_px) / px_per_m;
    }
    [[nodiscard]] double place_north_m(double place_y_px) const {
        return north_m - (place_y_px - frame.top_px) / px_per_m;
    }
};

/// Size of fonts and margins relative to a picture of 1200 x 900; small pictures keep letters that
/// can be read.
[[nodiscard]] double picture_unit(int width_px, int height_px);

/// The frame of a picture of this size, the same in both drawings.
[[nodiscard]] PictureFrame picture_frame(int width_px, int height_px);

/// The layout of `draw_profile` for a profile with columns. Cells of a pixel or more begin on whole
/// or half pixels, so that all look alike.
[[nodiscard]] ProfileLayout layout_profile(const PictureFrame& frame, const GroundPlan& plan,
                                           double cell_m);

} // namespace zonegrid
