#pragma once

#include "truth/surfaces.h"
#include "zonegrid/sensors.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace zonegrid {

/// A recording's time stamps may be later than the true times, by at most this.
inline constexpr double most_lateness_s = 10.0;

/// Where the camera really was when an image was exposed; one a line of the recording's frames.csv,
/// in its order. `time_s` is the true time: the recording's may be late.
struct TrueImage {
    double time_s = 0.0;
    Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
};

/// Where a moving obstacle was at a time; between two entries it moves evenly.
struct MovingPose {
    double time_s = 0.0;
    Eigen::Isometry3d world_from_obstacle = Eigen::Isometry3d::Identity();
};

/// The path of one moving obstacle, in increasing order of time.
struct ObstacleMotion {
    std::uint32_t obstacle = 0; ///< index into Surfaces::obstacles
    std::vector<MovingPose> poses;

    /// Its pose at `time_s`; that of the nearer end outside the entries.
    [[nodiscard]] Eigen::Isometry3d at(double time_s) const;
};

/// Everything that is known of a simulated flight (docs/formats.md, "truth").
struct Truth {
    std::string scene; ///< name of the scene
    std::uint64_t seed = 0;
    Camera camera; ///< ideal pinhole, with its true mounting
    Surfaces surfaces;
    std::vector<ObstacleMotion> motions;
    std::vector<NavigationSample> navigation; ///< true states at the navigation samples' times
    std::vector<TrueImage> images;
};

/// Writes the truth into the existing `folder`: truth.json (scene, seed, camera, obstacles),
/// surfaces.ply (binary, triangles in the obstacles' order), navigation.csv, images.csv,
/// motions.csv. Throws OutputError.
void write_truth(const std::filesystem::path& folder, const Truth& truth);

/// Reads what `write_truth` wrote. Throws InputError naming file, line or key, and the remedy.
[[nodiscard]] Truth read_truth(const std::filesystem::path& folder);

/// What tells one truth from every other: the SHA-256 of its files' bytes, as docs/formats.md
/// defines it, in hexadecimal. A simulated recording states that of its own truth, and so do maps
/// of it. Throws InputError if a file cannot be read.
[[nodiscard]] std::string digest_of_truth(const std::filesystem::path& folder);

} // namespace zonegrid
