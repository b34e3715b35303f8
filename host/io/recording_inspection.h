#pragma once

#include "io/pose_direction.h"
#include "io/recording.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

/// Least, median and greatest of some values; NaN without values.
struct Spread {
    double least = 0.0;
    double median = 0.0;
    double greatest = 0.0;
};

[[nodiscard]] Spread spread_of(std::vector<double> values);

/// Times in a strictly increasing series.
struct TimeSeries {
    std::size_t count = 0;
    double duration_s = 0.0;
    double rate_hz = 0.0; ///< by the median step; 0 for fewer than two
    double greatest_gap_s = 0.0;
    double greatest_gap_at_s = 0.0; ///< where it begins
    double gap_limit_s = 0.0;
    std::size_t gaps_above_limit = 0; ///< steps longer than gap_limit_s
};

/// Where the sensor is at its frames.
struct SensorPath {
    std::size_t frames_with_pose = 0;
    std::size_t frames_without_navigation = 0;
    double length_m = 0.0;
    double greatest_step_m = 0.0;   ///< between neighbouring frames
    double greatest_turn_rad = 0.0; ///< between neighbouring frames
    double greatest_speed_mps = 0.0;
    double horizontal_extent_m = 0.0;
    double vertical_extent_m = 0.0;
    double share_looking_steeply = 0.0; ///< camera within 30 degrees of straight up or down
};

/// What a sample of frames shows. For laser scans pixels are points, and depths distances.
struct FrameContents {
    std::size_t read = 0;
    std::size_t damaged = 0;
    std::vector<std::string> damaged_first; ///< messages
    Spread pixels;                          ///< in a frame
    Spread valid_share;                     ///< of a frame's pixels: with a distance
    Spread infinite_share;                  ///< of a frame's pixels: sky
    double least_depth_m = 0.0;
    double median_depth_m = 0.0; ///< median of the frames' medians
    double greatest_depth_m = 0.0;
};

/// Everything that `inspect_recording` finds.
struct RecordingInspection {
    TimeSeries frames;     ///< gaps: above twice the usual step
    TimeSeries navigation; ///< gaps: above max_gap_s
    std::size_t navigation_not_finite = 0;
    SensorPath path;
    FrameContents contents;
    std::optional<PoseDirection> pose_direction;
    std::vector<std::string> warnings; ///< what a person should look at, with what usually helps
};

/// Looks at a recording without mapping it. Reads `frames_most` frames, evenly spread, and a few
/// more to compare pairs. `max_gap_s` as in MapperOptions.
[[nodiscard]] RecordingInspection inspect_recording(const Recording& recording, double max_gap_s,
                                                    std::size_t frames_most);

} // namespace zonegrid
