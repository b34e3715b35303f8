#include "io/pose_conversion.h"

#include "io/navigation_differences.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <Eigen/SVD>

#include <cmath>

namespace zonegrid {
namespace {

/// Norms and rotations further off than this are errors, not rounding.
constexpr double rotation_tolerance = 1e-2;

} // namespace

Eigen::Matrix3d north_east_down_from(WorldAxes axes) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    switch (axes) {
        case WorldAxes::north_east_down:
            break;
        case WorldAxes::east_north_up:
            turn << 0, 1, 0, 1, 0, 0, 0, 0, -1;
            break;
        case WorldAxes::z_up:
            turn << 1, 0, 0, 0, -1, 0, 0, 0, -1;
            break;
        case WorldAxes::y_down:
            turn << 0, 0, 1, 1, 0, 0, 0, 1, 0;
            break;
        case WorldAxes::layout_default:
            throw UsageError("world axes: the layout's default was not resolved; name the axes");
    }
    return turn;
}

std::string name_of(WorldAxes axes) {
    switch (axes) {
        case WorldAxes::north_east_down:
            return "north_east_down";
        case WorldAxes::east_north_up:
            return "east_north_up";
        case WorldAxes::z_up:
            return "z_up";
        case WorldAxes::y_down:
            return "y_down";
        case WorldAxes::layout_default:
            break;
    }
    return "layout_default";
}

Eigen::Matrix3d body_from_forward_left_up() {
    return Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal().toDenseMatrix();
}

Eigen::Quaterniond checked_quaternion(double x, double y, double z, double w,
                                      const std::string& where) {
    const Eigen::Quaterniond quaternion(w, x, y, z);
    const double norm = quaternion.norm();
    if (!(std::abs(norm - 1.0) <= rotation_tolerance)) {
        throw InputError(
            where,
            fmt::format("the quaternion ({}, {}, {}, {}) has norm {:.4f}, not 1", x, y, z, w, norm),
            "correct the line; the order is qx qy qz qw");
    }
    return quaternion.normalized();
}

Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& matrix, const std::string& where) {
    const double error =
        (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(error < rotation_tolerance)) {
        throw InputError(
            where, fmt::format("the rotation is not orthonormal: R'R is off by {:.3g}", error),
            "give a camera-to-world rotation without scale or shear");
    }
    if (matrix.determinant() < 0.0) {
        throw InputError(where,
                         "the rotation is a reflection (determinant -1): the camera is inside-out",
                         "flip one axis of the rotation; camera axes are x right, y down, z "
                         "forward");
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
}

Eigen::Isometry3d parse_pose(std::span<const std::string, 7> fields, const std::string& where) {
    const auto number = [&](std::size_t index, const char* name) {
        return parse_number(fields[index], name, where);
    };
    const Eigen::Vector3d position_m(number(0, "tx"), number(1, "ty"), number(2, "tz"));
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = checked_quaternion(number(3, "qx"), number(4, "qy"), number(5, "qz"),
                                       number(6, "qw"), where)
                        .toRotationMatrix();
    pose.translation() = position_m;
    return pose;
}

std::vector<NavigationSample> samples_of_poses(std::span<const TimedPose> poses, WorldAxes axes,
                                               const Eigen::Isometry3d& body_from_sensor) {
    const Eigen::Isometry3d north_east_down_from_world(north_east_down_from(axes));
    const Eigen::Isometry3d sensor_from_body = body_from_sensor.inverse();
    std::vector<NavigationSample> samples;
    samples.reserve(poses.size());
    for (const TimedPose& pose : poses) {
        const Eigen::Isometry3d world_from_body =
            north_east_down_from_world * pose.world_from_sensor * sensor_from_body;
        NavigationSample sample;
        sample.time_s = pose.time_s;
        sample.position_m = world_from_body.translation();
        sample.world_from_body = Eigen::Quaterniond(world_from_body.linear()).normalized();
        samples.push_back(sample);
    }
    derive_velocities(samples);
    derive_body_rates(samples);
    return samples;
}

std::string describe_pose_navigation(WorldAxes axes) {
    return fmt::format(
        "World: {} turned into north-east-down; velocities and turn rates by "
        "differences of neighbouring poses.",
        name_of(axes));
}

} // namespace zonegrid
