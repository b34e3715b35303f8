#pragma once

#include "io/pose_conversion.h"
#include "io/recording.h"

#include <filesystem>
#include <vector>

namespace zonegrid {

/// What an association file of the TUM layout holds.
struct TumAssociation {
    std::vector<FrameEntry> frames; ///< images that exist
    std::vector<TimedPose> poses;   ///< also of the images that do not exist
};

/// Reads a list whose lines end in the camera's pose "tx ty tz qx qy qz qw", after the depth image
/// and, as the case may be, the colour image, each with or without its time before it. An image
/// without a time carries it in its name. Lines that name an image again are left out and counted
/// in one warning, as are images that do not exist.
/// Throws InputError naming file and line.
[[nodiscard]] TumAssociation read_tum_association(const std::filesystem::path& file,
                                                  std::vector<RecordingWarning>& warnings);

} // namespace zonegrid
