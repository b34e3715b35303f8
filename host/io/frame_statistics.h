#pragma once

#include "io/recording_inspection.h"

namespace zonegrid {

/// Reads `frames_most` frames of the recording, evenly spread, and tells what they hold.
[[nodiscard]] FrameContents look_at_frames(const Recording& recording, std::size_t frames_most);

} // namespace zonegrid
