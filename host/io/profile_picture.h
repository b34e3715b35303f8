#pragma once

#include "zonegrid/objects.h"

#include <Eigen/Core>

#include <filesystem>
#include <span>
#include <string>

namespace zonegrid {

/// What both pictures share. Sizes from 400 x 300 to 8192 x 8192 pixels.
struct ProfilePictureOptions {
    int width_px = 1200;
    int height_px = 900;
    std::string title;    ///< first line, e.g. the recording's name
    std::string subtitle; ///< second line, e.g. "cell 0.10 m, 200 images, line model"
    /// The profile whose extent and heights decide part shown, colours and view, so that pictures
    /// of several profiles can be compared; none: the one that is drawn. It must have columns, and
    /// the drawn one must lie within its extent.
    const HeightProfile* scale = nullptr;
};

/// Draws the height profile from above: north up, east to the right, axes in metres at equal scale,
/// colour bar of the height (top of the highest occupied cell, metres above the world's origin,
/// i.e. -z), scale bar, trajectory with its start and end marked. Columns smaller than a pixel
/// share it with the highest winning; larger ones are squares; unknown ground is light grey.
///
/// Colours span the heights without their lowest and highest 0.5 percent, unless those lie close
/// by; the picture says so when heights lie beyond.
///
/// `trajectory_m` are camera positions in the world frame (north, east, down); points that are not
/// finite, or more than a million metres away, are left out. It may be empty, and so may the
/// profile. Writes an 8-bit RGB PNG. Throws UsageError for a picture size or cell size that cannot
/// work, OutputError if the file cannot be written; nothing half-written is left behind.
void draw_profile(const HeightProfile& profile, std::span<const Eigen::Vector3d> trajectory_m,
                  const ProfilePictureOptions& options, const std::filesystem::path& file);

/// The same in perspective, seen from above at a slant: each column a shaded block that reaches
/// down to its neighbours, or where they are unknown to the lowest ground nearby; the trajectory at
/// its true height, faint where blocks hide it. The view is the one of several around the scene
/// from which most columns are seen and the picture is filled best, from the south where equal.
///
/// Blocks far outside the bulk of heights are cut off at a bound that the picture then names.
/// Very flat scenes are drawn with their heights multiplied by 2 or 5, and say so.
void draw_profile_3d(const HeightProfile& profile, std::span<const Eigen::Vector3d> trajectory_m,
                     const ProfilePictureOptions& options, const std::filesystem::path& file);

} // namespace zonegrid
