#pragma once

#include "io/recording.h"

#include <filesystem>
#include <string>
#include <vector>

namespace zonegrid {

/// The navigation log of a KITTI drive.
struct OxtsLog {
    std::vector<NavigationSample> samples;
    GeoOrigin origin; ///< the first row's position: origin of the local world
};

/// Reads oxts/timestamps.txt and the rows in oxts/data/. The body is the IMU, its axes turned from
/// forward-left-up to forward-right-down. Rows that do not exist are left out and counted in one
/// warning. Throws InputError naming file and line.
[[nodiscard]] OxtsLog read_oxts(const std::filesystem::path& folder,
                                std::vector<RecordingWarning>& warnings);

struct KittiTime {
    double time_s = 0.0;
    std::string where; ///< "file:line", for messages
};

/// The times of a KITTI list "YYYY-MM-DD hh:mm:ss.fffffffff", in seconds since 1970, in strictly
/// increasing order. Throws InputError naming file and line.
[[nodiscard]] std::vector<KittiTime> read_kitti_times(const std::filesystem::path& file);

} // namespace zonegrid
