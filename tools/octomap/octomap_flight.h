#pragma once

#include "io/recording.h"
#include "io/replay.h"
#include "pipeline/map_history.h"
#include "zonegrid/objects.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace zonegrid {

/// How to map a recording with OctoMap.
struct OctoMapOptions {
    double cell_m = 1.0;
    double range_m = 40.0;
    double max_gap_s = 0.05;
    bool discretize = false; ///< OctoMap's own short cut: one ray for all pixels that end in a cell
};

/// What OctoMap makes of a recording, in zonegrid's terms: a cell is occupied (1) from the
/// probability 0.5 on, else free (-1), and 0 where OctoMap has no node.
struct OctoMapFlight {
    MapHistory history;
    std::vector<Object> objects; ///< occupied cells connected through faces
    std::uint64_t integrated = 0;
    std::uint64_t skipped = 0; ///< images that cannot be read or have no navigation
    double insert_ms = 0.0;    ///< median of the time in insertPointCloud
};

/// Replays the depth images of `recording` through octomap::OcTree with its default parameters
/// (log-odds 0.85 and -0.4, clamped at -2 and 3.5), every pixel a ray; poses as zonegrid takes
/// them. Sky is a point beyond the range, so that it frees cells up to there. `observer` gets the
/// number of images done. Throws UsageError if the recording has no camera.
[[nodiscard]] OctoMapFlight fly_octomap(const Recording& recording, const OctoMapOptions& options,
                                        const std::function<void(std::size_t)>& observer);

} // namespace zonegrid
