#include "io/pose_conversion.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zonegrid {
namespace {

using testing::refuses;

TEST(PoseConversion, TurnsWorldsWithoutReflectingThem) {
    const Eigen::Vector3d xyz(1, 2, 3);
    EXPECT_EQ(north_east_down_from(WorldAxes::north_east_down) * xyz, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(north_east_down_from(WorldAxes::east_north_up) * xyz, Eigen::Vector3d(2, 1, -3));
    EXPECT_EQ(north_east_down_from(WorldAxes::z_up) * xyz, Eigen::Vector3d(1, -2, -3));
    EXPECT_EQ(north_east_down_from(WorldAxes::y_down) * xyz, Eigen::Vector3d(3, 1, 2));
    for (const WorldAxes axes : {WorldAxes::north_east_down, WorldAxes::east_north_up,
                                 WorldAxes::z_up, WorldAxes::y_down}) {
        EXPECT_EQ(north_east_down_from(axes).determinant(), 1.0) << name_of(axes);
    }
    EXPECT_EQ(body_from_forward_left_up() * xyz, Eigen::Vector3d(1, -2, -3));
    EXPECT_THROW(static_cast<void>(north_east_down_from(WorldAxes::layout_default)), UsageError);
}

TEST(PoseConversion, NormalisesQuaternionsOffByRounding) {
    const Eigen::Quaterniond quaternion = checked_quaternion(0.0, 0.0, 0.6, 0.806, "list:3");
    EXPECT_NEAR(quaternion.norm(), 1.0, 1e-15);
    EXPECT_NEAR(quaternion.z() / quaternion.w(), 0.6 / 0.806, 1e-15);
    EXPECT_THAT([] { return checked_quaternion(0, 0, 0, 1.011, "list:3"); },
                refuses("list:3", "norm 1.011"));
    EXPECT_THAT([] { return checked_quaternion(0, 0, 0, 0, "list:3"); }, refuses("list:3"));
    EXPECT_THAT([] { return checked_quaternion(0, 0, 0, std::nan(""), "list:3"); },
                refuses("list:3"));
}

TEST(PoseConversion, TakesTheNearestRotation) {
    Eigen::Matrix3d sheared = Eigen::Matrix3d::Identity();
    sheared(0, 1) = 0.008;
    sheared(2, 2) = 0.997;
    const Eigen::Matrix3d rotation = checked_rotation(sheared, "pose");
    EXPECT_TRUE((rotation.transpose() * rotation).isIdentity(1e-14));
    EXPECT_NEAR(rotation(0, 1), 0.004, 1e-5); // half of the shear is a turn
    EXPECT_NEAR(rotation(1, 0), -0.004, 1e-5);
    sheared(0, 1) = 0.011;
    EXPECT_THAT([&] { return checked_rotation(sheared, "pose"); }, refuses("pose", "0.011"));
    EXPECT_THAT([] { return checked_rotation(-Eigen::Matrix3d::Identity(), "pose"); },
                refuses("pose", "inside-out"));
    EXPECT_THAT([] { return checked_rotation(Eigen::Matrix3d::Zero(), "pose"); },
                refuses("pose", "not orthonormal"));
}

} // namespace
} // namespace zonegrid
