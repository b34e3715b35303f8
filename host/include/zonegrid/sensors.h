#pragma once

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zonegrid {

/// One sample of the navigation filter.
///
/// World frame: local north-east-down (x north, y east, z down), metres.
/// Body frame: forward-right-down.
struct NavigationSample {
    double time_s = 0.0;
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();        ///< body origin, world frame
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();      ///< world frame
    Eigen::Vector3d acceleration_mps2 = Eigen::Vector3d::Zero(); ///< world frame, without gravity
    Eigen::Quaterniond world_from_body = Eigen::Quaterniond::Identity(); ///< unit quaternion
    Eigen::Vector3d body_rate_radps = Eigen::Vector3d::Zero(); ///< turn rate, body frame (p, q, r)
};

/// Attitude from roll, pitch and yaw in radians, z-y'-x'' order: yaw about down, then pitch about
/// right, then roll about forward.
[[nodiscard]] Eigen::Quaterniond attitude_from_euler(double roll_rad, double pitch_rad,
                                                     double yaw_rad);

/// Stereo depth uncertainty: sigma_z = z^2 * disparity_sigma_px / (focal_px * baseline_m).
struct StereoNoise {
    double baseline_m = 0.0;
    double disparity_sigma_px = 0.0;
};

/// A depth camera. Camera frame: x right, y down, z along the optical axis.
///
/// Pixel (u, v), u to the right from 0, v downwards from 0, looks along
/// ((u - cx) / fx, (v - cy) / fy, 1). A camera that is no ideal pinhole carries `directions`, one
/// (x/z, y/z) per pixel, row by row; fx, fy, cx, cy then give the mean spacing of the rays.
struct Camera {
    int width_px = 0;
    int height_px = 0;
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    std::vector<Eigen::Vector2f> directions; ///< empty, or width_px * height_px entries
    std::optional<StereoNoise> stereo;       ///< absent: depth is taken as exact
    Eigen::Isometry3d body_from_camera = Eigen::Isometry3d::Identity();
};

/// Turns the camera frame into the body frame of a camera that looks forward:
/// optical (right, down, forward) to body (forward, right, down).
[[nodiscard]] Eigen::Matrix3d body_from_forward_camera();

/// One depth image: height * width distances along the optical axis in metres, `[v][u]`.
/// NaN, zero and negative values are missing (no statement); +infinity is sky (free to the range).
struct DepthImage {
    double time_s = 0.0;
    std::span<const float> depth_m;
};

/// One sweep of a sensor that is no camera. Every ray brings its own start and end.
struct Scan {
    double time_s = 0.0;
    Eigen::Isometry3d body_from_sensor = Eigen::Isometry3d::Identity();
    std::span<const Eigen::Vector3f>
        ends_m; ///< sensor frame; a ray with a non-finite end is missing
    std::span<const Eigen::Vector3f>
        starts_m; ///< sensor frame; empty: every ray starts at the sensor
};

} // namespace zonegrid
