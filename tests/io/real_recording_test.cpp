#include "io/recording.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

// These tests read real recordings. They prove what made-up files cannot: that the direction of the
// poses, the axes and the scales are those of the world.

#define OPEN_OR_SKIP(recording, folder)                                                        \
    if (!std::filesystem::is_directory(std::filesystem::path(ZONEGRID_DATA_DIR) / (folder))) { \
        GTEST_SKIP() << "no recorded data: " << ZONEGRID_DATA_DIR << "/" << (folder);          \
    }                                                                                          \
    const std::unique_ptr<Recording> recording =                                               \
        open_recording(std::filesystem::path(ZONEGRID_DATA_DIR) / (folder))

namespace zonegrid {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

/// The body's pose at an image's time: the nearest sample, moved on by its velocity and turn rate.
Eigen::Isometry3d world_from_body(const Recording& recording, double time_s) {
    const auto& samples = recording.navigation();
    const NavigationSample& sample =
        *std::ranges::min_element(samples, {}, [time_s](const NavigationSample& candidate) {
            return std::abs(candidate.time_s - time_s);
        });
    const double step_s = time_s - sample.time_s;
    const Eigen::Vector3d turn_rad = step_s * sample.body_rate_radps;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = sample.position_m + step_s * sample.velocity_mps;
    pose.linear() = sample.world_from_body.toRotationMatrix();
    if (turn_rad.norm() > 0.0) {
        pose.rotate(Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()));
    }
    return pose;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Median absolute difference of depths after projecting image `from` into image `to`, in metres;
/// with the poses as read or, for comparison, with their inverses in the recording's frames.
double projection_error_m(const Recording& recording, std::size_t from, std::size_t to,
                          bool inverted) {
    const Camera& camera = recording.camera().value();
    const auto pose = [&](std::size_t index) {
        const Eigen::Isometry3d world_from_camera =
            world_from_body(recording, recording.frames()[index].time_s) * camera.body_from_camera;
        return inverted ? world_from_camera.inverse() : world_from_camera;
    };
    const Eigen::Isometry3d to_from = pose(to).inverse() * pose(from);
    const std::vector<float> from_m = recording.read_frame(from).depth_m;
    const std::vector<float> to_m = recording.read_frame(to).depth_m;
    std::vector<double> errors_m;
    for (int v = 0; v < camera.height_px; v += 3) {
        for (int u = 0; u < camera.width_px; u += 3) {
            const double depth_m =
                static_cast<double>(from_m[static_cast<std::size_t>(v * camera.width_px + u)]);
            const Eigen::Vector3d point =
                to_from * Eigen::Vector3d(depth_m * (u - camera.cx_px) / camera.fx_px,
                                          depth_m * (v - camera.cy_px) / camera.fy_px, depth_m);
            const double u_to = std::round(camera.fx_px * point.x() / point.z() + camera.cx_px);
            const double v_to = std::round(camera.fy_px * point.y() / point.z() + camera.cy_px);
            if (!(point.z() > 0.1 && u_to >= 0 && v_to >= 0 && u_to < camera.width_px &&
                  v_to < camera.height_px)) {
                continue; // also where the depth is missing
            }
            const double seen_m = static_cast<double>(
                to_m[static_cast<std::size_t>(v_to) * static_cast<std::size_t>(camera.width_px) +
                     static_cast<std::size_t>(u_to)]);
            if (!std::isnan(seen_m)) {
                errors_m.push_back(std::abs(seen_m - point.z()));
            }
        }
    }
    EXPECT_GT(errors_m.size(), 1000U);
    return errors_m.empty() ? std::numeric_limits<double>::infinity() : median(errors_m);
}

/// Share of the pixels that say nothing.
double missing_share(const std::vector<float>& depth_m) {
    const auto missing =
        std::ranges::count_if(depth_m, [](float depth) { return std::isnan(depth); });
    return static_cast<double>(missing) / static_cast<double>(depth_m.size());
}

TEST(RealRecording, DeskIsProjectedOntoItself) {
    OPEN_OR_SKIP(recording, "rgbd_dataset_freiburg1_xyz");
    EXPECT_EQ(recording->layout(), "tum");
    EXPECT_THAT(recording->frames(), SizeIs(200));
    EXPECT_THAT(recording->navigation(), SizeIs(3000));
    EXPECT_EQ(recording->camera()->fx_px, 517.3);
    const double right_m = projection_error_m(*recording, 50, 65, false);
    const double wrong_m = projection_error_m(*recording, 50, 65, true);
    RecordProperty("median_m", fmt::format("{:.4f}, inverted {:.4f}", right_m, wrong_m));
    EXPECT_LT(right_m, 0.015);
    EXPECT_GT(wrong_m, 0.05);
    const double missing = missing_share(recording->read_frame(50).depth_m);
    EXPECT_GT(missing, 0.19);
    EXPECT_LT(missing, 0.29);
}

TEST(RealRecording, HallIsProjectedOntoItself) {
    OPEN_OR_SKIP(recording, "rgbd_dataset_freiburg2_pioneer_slam2");
    EXPECT_EQ(recording->layout(), "tum");
    EXPECT_THAT(recording->frames(), SizeIs(10));
    EXPECT_THAT(recording->navigation(), SizeIs(1611 - 36));
    ASSERT_THAT(recording->warnings(), SizeIs(2));
    EXPECT_THAT(recording->warnings()[0].problem, HasSubstr("36 lines"));
    EXPECT_THAT(recording->warnings()[1].problem, HasSubstr("1565 of 1575"));
    // Frames are a second apart; the first pair that overlaps well.
    const double right_m = projection_error_m(*recording, 0, 1, false);
    const double wrong_m = projection_error_m(*recording, 0, 1, true);
    RecordProperty("median_m", fmt::format("{:.4f}, inverted {:.4f}", right_m, wrong_m));
    EXPECT_LT(right_m, 0.1);
    EXPECT_GT(wrong_m, 3.0 * right_m);
}

TEST(RealRecording, KitchenIsProjectedOntoItself) {
    OPEN_OR_SKIP(recording, "7scenes_redkitchen");
    EXPECT_EQ(recording->layout(), "poses");
    EXPECT_THAT(recording->frames(), SizeIs(200));
    EXPECT_NEAR(recording->frames()[0].time_s, 200.0 / 30.0, 1e-9);
    const double right_m = projection_error_m(*recording, 40, 60, false);
    const double wrong_m = projection_error_m(*recording, 40, 60, true);
    RecordProperty("median_m", fmt::format("{:.4f}, inverted {:.4f}", right_m, wrong_m));
    EXPECT_LT(right_m, 0.015);
    EXPECT_GT(wrong_m, 0.05);
    const std::vector<float> depth_m = recording->read_frame(33).depth_m; // holds 65535
    EXPECT_TRUE(std::ranges::none_of(depth_m, [](float depth) { return depth > 10.0F; }));
}

TEST(RealRecording, ShippedDeskIsProjectedOntoItself) {
    const auto recording = open_recording(std::filesystem::path(ZONEGRID_SOURCE_DIR) / "data" /
                                          "rgbd_dataset_freiburg1_xyz_cut");
    EXPECT_THAT(recording->frames(), SizeIs(40));
    EXPECT_THAT(recording->warnings(), SizeIs(0));
    EXPECT_EQ(recording->camera()->fx_px, 517.3);
    EXPECT_LT(projection_error_m(*recording, 8, 11, false), 0.015);
    EXPECT_GT(projection_error_m(*recording, 8, 11, true), 0.05);
}

/// Median distance from every `stride`th point to its nearest neighbour, in metres.
double neighbour_distance_m(const std::vector<Eigen::Vector3f>& from,
                            const std::vector<Eigen::Vector3f>& to,
                            const Eigen::Isometry3d& to_from, std::size_t stride) {
    std::vector<double> distances_m;
    for (std::size_t index = 0; index < from.size(); index += stride) {
        const Eigen::Vector3f point = (to_from * from[index].cast<double>()).cast<float>();
        float nearest_m2 = std::numeric_limits<float>::infinity();
        for (const Eigen::Vector3f& candidate : to) {
            nearest_m2 = std::min(nearest_m2, (candidate - point).squaredNorm());
        }
        distances_m.push_back(std::sqrt(static_cast<double>(nearest_m2)));
    }
    return median(distances_m);
}

Eigen::Isometry3d world_from_scanner(const Recording& recording, std::size_t frame) {
    return world_from_body(recording, recording.frames()[frame].time_s) *
           recording.body_from_sensor();
}

TEST(RealRecording, StreetSweepsFallOntoEachOther) {
    OPEN_OR_SKIP(recording, "2011_09_26_drive_0005_sync");
    EXPECT_EQ(recording->layout(), "kitti");
    ASSERT_THAT(recording->frames(), SizeIs(10));
    EXPECT_THAT(recording->navigation(), SizeIs(154));
    ASSERT_THAT(recording->warnings(), SizeIs(1));
    EXPECT_THAT(recording->warnings()[0].problem, HasSubstr("144 of 154"));
    ASSERT_TRUE(recording->origin().has_value());
    EXPECT_NEAR(recording->origin()->latitude_deg, 49.01, 0.01);
    const auto first = recording->read_frame(0).ends_m;
    const auto last = recording->read_frame(9).ends_m;
    const Eigen::Isometry3d last_from_first =
        world_from_scanner(*recording, 9).inverse() * world_from_scanner(*recording, 0);
    EXPECT_NEAR(last_from_first.translation().norm(), 4.9, 0.4);
    const double right_m = neighbour_distance_m(first, last, last_from_first, 200);
    const double unmoved_m = neighbour_distance_m(first, last, Eigen::Isometry3d::Identity(), 200);
    RecordProperty("median_m", fmt::format("{:.3f}, unmoved {:.3f}", right_m, unmoved_m));
    EXPECT_LT(right_m, 0.15);
    EXPECT_GT(unmoved_m, 0.2);
}

TEST(RealRecording, StreetNavigationAgreesWithItsDerivatives) {
    OPEN_OR_SKIP(recording, "2011_09_26_drive_0005_sync");
    const auto& samples = recording->navigation();
    double path_m = 0.0;
    double velocity_error_mps = 0.0;
    double acceleration_error_mps2 = 0.0;
    double rate_error_radps = 0.0;
    const double count = static_cast<double>(samples.size() - 2);
    for (std::size_t index = 1; index + 1 < samples.size(); ++index) {
        const NavigationSample& before = samples[index - 1];
        const NavigationSample& after = samples[index + 1];
        const double step_s = after.time_s - before.time_s;
        path_m += (samples[index].position_m - before.position_m).norm();
        velocity_error_mps +=
            ((after.position_m - before.position_m) / step_s - samples[index].velocity_mps).norm() /
            count;
        acceleration_error_mps2 +=
            ((after.velocity_mps - before.velocity_mps) / step_s - samples[index].acceleration_mps2)
                .norm() /
            count;
        const Eigen::AngleAxisd turn(before.world_from_body.conjugate() * after.world_from_body);
        rate_error_radps +=
            (turn.angle() * turn.axis() / step_s - samples[index].body_rate_radps).norm() / count;
    }
    RecordProperty("errors",
                   fmt::format("path {:.1f} m, {:.3f} m/s, {:.3f} m/s2, {:.4f} rad/s", path_m,
                               velocity_error_mps, acceleration_error_mps2, rate_error_radps));
    EXPECT_NEAR(path_m, 69.0, 1.0);
    EXPECT_LT(velocity_error_mps, 0.3);
    EXPECT_LT(acceleration_error_mps2, 1.0); // with gravity left in it would be near 9.8
    EXPECT_LT(rate_error_radps, 0.05);
}

TEST(RealRecording, CloudsFallOntoEachOther) {
    OPEN_OR_SKIP(recording, "gtsam_points_lidar/kitti_07_dump");
    EXPECT_EQ(recording->layout(), "clouds");
    ASSERT_THAT(recording->frames(), SizeIs(5));
    const auto first = recording->read_frame(0).ends_m;
    const auto second = recording->read_frame(1).ends_m;
    const Eigen::Isometry3d forwards =
        world_from_scanner(*recording, 1).inverse() * world_from_scanner(*recording, 0);
    const double right_m = neighbour_distance_m(first, second, forwards, 20);
    const double wrong_m = neighbour_distance_m(first, second, forwards.inverse(), 20);
    RecordProperty("median_m", fmt::format("{:.3f}, inverted {:.3f}", right_m, wrong_m));
    EXPECT_LT(right_m, 0.25);
    EXPECT_GT(wrong_m, 1.0);
}

} // namespace
} // namespace zonegrid
