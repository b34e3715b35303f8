#include "zonegrid/mapper.h"

#include "support/oracle_random.h"
#include "support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// docs/model.md, section 1.

namespace zonegrid {
namespace {

using Eigen::Vector3d;

double radians(double angle_deg) {
    return angle_deg * std::numbers::pi / 180.0;
}

Eigen::Isometry3d world_from_body(const Vector3d& position_m, double roll_deg, double pitch_deg,
                                  double yaw_deg) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = attitude_from_euler(radians(roll_deg), radians(pitch_deg), radians(yaw_deg))
                        .toRotationMatrix();
    pose.translation() = position_m;
    return pose;
}

TEST(Frames, OneMetreAheadRightAndDownOfATurnedCamera) {
    // Yaw 90 (nose east), pitch 10 up, roll 30 (right side down). By hand, Rz(90) Ry(10) Rx(30):
    // ahead (0, cos 10, -sin 10); right (-cos 30, sin 10 sin 30, cos 10 sin 30);
    // down (sin 30, sin 10 cos 30, cos 10 cos 30).
    const Vector3d at(100.0, 200.0, -50.0);
    Eigen::Isometry3d body_from_camera = Eigen::Isometry3d::Identity();
    body_from_camera.linear() = body_from_forward_camera();
    const auto world_from_camera = world_from_body(at, 30.0, 10.0, 90.0) * body_from_camera;
    const Vector3d ahead = world_from_camera * Vector3d(0.0, 0.0, 1.0);
    const Vector3d right = world_from_camera * Vector3d(1.0, 0.0, 0.0);
    const Vector3d down = world_from_camera * Vector3d(0.0, 1.0, 0.0);
    EXPECT_LT((ahead - at - Vector3d(0.0, 0.984807753, -0.173648178)).norm(), 1e-8);
    EXPECT_LT((right - at - Vector3d(-0.866025404, 0.086824089, 0.492403877)).norm(), 1e-8);
    EXPECT_LT((down - at - Vector3d(0.5, 0.150383733, 0.852868532)).norm(), 1e-8);
}

TEST(Frames, ForwardCameraIsARotation) {
    const Eigen::Matrix3d rotation = body_from_forward_camera();
    EXPECT_TRUE((rotation * rotation.transpose()).isApprox(Eigen::Matrix3d::Identity()));
    EXPECT_DOUBLE_EQ(rotation.determinant(), 1.0);
}

TEST(Frames, MapperAppliesTheCamerasMountingBeforeTheBodysPose) {
    // Mounted 0.5 m ahead and 0.2 m below, looking 45 degrees down; the body faces east.
    Camera camera = scenes::forward_camera(1, 1, 1.0);
    camera.body_from_camera.linear() =
        attitude_from_euler(0.0, radians(-45.0), 0.0).toRotationMatrix() *
        body_from_forward_camera();
    camera.body_from_camera.translation() = Vector3d(0.5, 0.0, 0.2);
    Mapper mapper(MapperOptions{}, camera);
    const auto result =
        scenes::show(mapper, 1.0, {10.0, 20.0, -30.0}, scenes::blind_image(camera), radians(90.0));
    // Body axes here: forward is east, right is south, down is down.
    EXPECT_TRUE(result.world_from_sensor.translation().isApprox(Vector3d(10.0, 20.5, -29.8)));
    const double s = 2.0 * std::sqrt(0.5); // 2 m along the axis: as much forward as down
    EXPECT_TRUE((result.world_from_sensor * Vector3d(0.0, 0.0, 2.0))
                    .isApprox(Vector3d(10.0, 20.5 + s, -29.8 + s)));
    EXPECT_TRUE(
        (result.world_from_sensor * Vector3d(1.0, 0.0, 0.0)).isApprox(Vector3d(9.0, 20.5, -29.8)));
}

TEST(Frames, QuaternionAndEulerMatricesAgree) {
    oracle::Random random(3);
    for (int n = 0; n < 500; ++n) {
        const double roll = random.real(-3.2, 3.2);
        const double pitch = n % 10 == 0 ? std::numbers::pi / 2.0 : random.real(-1.6, 1.6);
        const double yaw = random.real(-3.2, 3.2);
        Eigen::Matrix3d rx;
        rx << 1.0, 0.0, 0.0, 0.0, std::cos(roll), -std::sin(roll), 0.0, std::sin(roll),
            std::cos(roll);
        Eigen::Matrix3d ry;
        ry << std::cos(pitch), 0.0, std::sin(pitch), 0.0, 1.0, 0.0, -std::sin(pitch), 0.0,
            std::cos(pitch);
        Eigen::Matrix3d rz;
        rz << std::cos(yaw), -std::sin(yaw), 0.0, std::sin(yaw), std::cos(yaw), 0.0, 0.0, 0.0, 1.0;
        const auto attitude = attitude_from_euler(roll, pitch, yaw);
        ASSERT_LT((attitude.toRotationMatrix() - rz * ry * rx).norm(), 1e-13) << "case " << n;
        ASSERT_NEAR(attitude.norm(), 1.0, 1e-14);
    }
}

} // namespace
} // namespace zonegrid
