#pragma once

#include "io/recording.h"
#include "zonegrid/mapper.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace zonegrid {

/// Why an image or scan was not integrated.
enum class SkipReason { damaged, no_navigation, pose_out_of_range, out_of_order };

inline constexpr std::size_t skip_reasons = 4;

/// How reports call the reason, as a JSON key and, with spaces, in text.
[[nodiscard]] std::string name_of(SkipReason reason);

/// An image that was skipped, for a person to look at.
struct SkippedImage {
    std::string where;
    SkipReason reason = SkipReason::damaged;
    std::string problem;
};

/// Wall-clock seconds of one stage, one entry an image that was integrated.
struct StageTimes {
    std::vector<double> seconds;

    [[nodiscard]] double total_s() const;
    /// The least time that the given share of all images does not exceed; 0 without images.
    [[nodiscard]] double percentile_s(double share) const;
};

/// What a replay did.
struct ReplaySummary {
    std::uint64_t images = 0; ///< that the replay looked at
    std::uint64_t integrated = 0;
    std::array<std::uint64_t, skip_reasons> skipped{}; ///< by SkipReason
    std::vector<SkippedImage> skipped_first;           ///< the first few

    StageTimes read;      ///< file to depths in metres
    StageTimes prepare;   ///< pose, rays, depth to integers
    StageTimes window;    ///< zones that enter and leave
    StageTimes integrate; ///< local map
    StageTimes fuse;      ///< local map into the grid
    StageTimes map;       ///< the last four: what a vehicle spends on an image
    StageTimes image;     ///< all of them

    std::uint64_t rays = 0;
    std::uint64_t missing = 0;
    std::uint64_t dropped = 0;
    std::uint64_t zones_entered = 0;
    std::uint64_t zones_left = 0;
    std::uint64_t cells_changed = 0;         ///< summed over the images
    std::uint64_t images_without_change = 0; ///< integrated, but no cell changed

    double least_distance_m = std::numeric_limits<double>::infinity(); ///< that an image stated
    std::vector<Eigen::Vector3d> trajectory_m; ///< sensor, world frame, a point an integrated image
};

/// Which frames of a recording to replay: first ... last - 1.
struct FrameSpan {
    std::size_t first = 0;
    std::size_t last = std::numeric_limits<std::size_t>::max();
};

/// Called before each image with what was done so far; the replay stops where it throws.
using ReplayObserver = std::function<void(const ReplaySummary&)>;

/// Hands navigation and images of a recording to a mapper as a vehicle would: before each image all
/// samples up to `max_gap_s` after it (docs/model.md, section 2). Images that cannot be read or
/// that the mapper skips are counted. `span` ends at the recording's end at the latest.
/// Throws what the mapper and the observer throw.
[[nodiscard]] ReplaySummary replay(const Recording& recording, const FrameSpan& span,
                                   Mapper& mapper, const ReplayObserver& observer);

} // namespace zonegrid
