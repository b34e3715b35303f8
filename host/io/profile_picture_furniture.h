#pragma once

#include "io/profile_picture_canvas.h"
#include "io/profile_picture_layout.h"

#include <span>
#include <string>

namespace zonegrid {

/// Title and subtitle at the left, a note (may be empty) at the right of the subtitle's line.
void draw_header(Canvas& canvas, const PictureFrame& frame, const ProfilePictureOptions& options,
                 const std::string& note);

/// Colour bar to the right of the frame, pointed at an end beyond which heights lie.
void draw_colour_bar(Canvas& canvas, const PictureFrame& frame, const HeightRange& range);

/// Line, start and end of the trajectory, explained in the lowest line of the picture.
void draw_trajectory_legend(Canvas& canvas, const PictureFrame& frame);

/// Markers that tell start from end by shape as well as colour.
void draw_start_marker(Canvas& canvas, double x_px, double y_px);
void draw_end_marker(Canvas& canvas, double x_px, double y_px);

/// A bar of a round length with its length written above, in the lowest line at the right.
void draw_scale_bar(Canvas& canvas, const PictureFrame& frame, double px_per_m);

/// The whole picture of a profile without columns.
void draw_empty_picture(const ProfilePictureOptions& options, const std::filesystem::path& file);

/// Throws UsageError if the profile's cells have no size.
void check_profile(const HeightProfile& profile);

} // namespace zonegrid
