#pragma once

#include "zonegrid/sensors.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zonegrid {

/// Where the local world frame sits on the Earth (WGS-84).
struct GeoOrigin {
    double latitude_deg = 0.0;
    double longitude_deg = 0.0;
    double altitude_m = 0.0;
};

/// One depth image or laser scan as it lies in the recording; its pixels are read on demand.
struct FrameEntry {
    double time_s = 0.0;
    std::filesystem::path file;
    std::string where; ///< "file:line" of the list that names it, for messages
};

/// The pixels or points of one frame.
struct FrameData {
    std::vector<float> depth_m;          ///< camera: height * width, see DepthImage
    std::vector<Eigen::Vector3f> ends_m; ///< laser: see Scan
};

/// What a reader noticed and lived with (frames listed but absent, doubled lines, ...).
struct RecordingWarning {
    std::string where;
    std::string problem;
};

/// Everything a reader found out about a recording besides the pixels themselves.
struct RecordingContents {
    std::string layout; ///< tum, poses, kitti, clouds or plain
    std::filesystem::path path;
    std::optional<Camera> camera;
    Eigen::Isometry3d body_from_sensor = Eigen::Isometry3d::Identity();
    std::vector<NavigationSample> navigation;
    std::vector<FrameEntry> frames;
    std::optional<GeoOrigin> origin;
    std::optional<std::string> truth_digest;
    std::vector<RecordingWarning> warnings;
    std::vector<std::string> notes;
};

/// A recording, whatever its layout, in zonegrid's frames and units. Frames and navigation samples
/// are in strictly increasing order of time.
class Recording {
public:
    explicit Recording(RecordingContents contents) : contents_(std::move(contents)) {}
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;
    virtual ~Recording() = default;

    [[nodiscard]] const std::string& layout() const { return contents_.layout; }
    [[nodiscard]] const std::filesystem::path& path() const { return contents_.path; }
    /// Present for depth images, absent for laser scans.
    [[nodiscard]] const std::optional<Camera>& camera() const { return contents_.camera; }
    /// Mounting of the laser scanner; meaningful only without a camera.
    [[nodiscard]] const Eigen::Isometry3d& body_from_sensor() const {
        return contents_.body_from_sensor;
    }
    [[nodiscard]] const std::vector<NavigationSample>& navigation() const {
        return contents_.navigation;
    }
    [[nodiscard]] const std::vector<FrameEntry>& frames() const { return contents_.frames; }
    [[nodiscard]] const std::optional<GeoOrigin>& origin() const { return contents_.origin; }
    /// Of a simulated recording: the digest of its truth (docs/formats.md), as the recording states
    /// it.
    [[nodiscard]] const std::optional<std::string>& truth_digest() const {
        return contents_.truth_digest;
    }
    [[nodiscard]] const std::vector<RecordingWarning>& warnings() const {
        return contents_.warnings;
    }
    /// What the reader took for granted or by default, one sentence each, for a person to check
    /// (whose intrinsics, which world axes, where times and velocities come from).
    [[nodiscard]] const std::vector<std::string>& notes() const { return contents_.notes; }

    /// Decodes frame `index` (below frames().size(), else UsageError); throws InputError naming the
    /// file if it is damaged, so that the caller may skip and count it.
    [[nodiscard]] virtual FrameData read_frame(std::size_t index) const = 0;

protected:
    /// Throws UsageError if there is no frame `index`.
    void require_frame(std::size_t index) const;

private:
    RecordingContents contents_;
};

/// How the world of a recording in a foreign convention lies in north-east-down.
enum class WorldAxes {
    layout_default,  ///< what docs/formats.md gives for the layout
    north_east_down, ///< x north, y east, z down: taken as it is
    east_north_up,   ///< x east, y north, z up
    z_up,            ///< z up, x taken as north: (x, -y, -z)
    y_down           ///< x right, y down, z forward: (z, x, y), an optical frame as world
};

/// What the caller may override when a recording does not describe itself.
struct RecordingOptions {
    std::string layout = "auto"; ///< auto, tum, poses, kitti, clouds or plain
    WorldAxes world_axes = WorldAxes::layout_default;
    std::optional<std::array<double, 4>> intrinsics{}; ///< fx fy cx cy in pixels
    std::optional<double> depth_units_per_m{};         ///< value of a 16-bit pixel at 1 m
    std::optional<StereoNoise> stereo{}; ///< of stereo cameras: baseline and disparity deviation
};

/// Opens `path`, a folder, and recognises its layout. Lists and navigation are read and checked
/// here; frames are decoded by `Recording::read_frame`.
/// Throws InputError naming file and line if the data is wrong; UsageError if an option is out of
/// range, names no layout, or does not apply to the recording (intrinsics of a laser).
[[nodiscard]] std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                                        const RecordingOptions& options = {});

} // namespace zonegrid
