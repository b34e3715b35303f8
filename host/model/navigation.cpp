#include "model/navigation.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace zonegrid {

namespace {

constexpr double kept_s = 10.0;
constexpr double greatest_norm_error = 1e-3;

void check_sample(const NavigationSample& sample) {
    const auto where = fmt::format("navigation sample at {:.6f} s", sample.time_s);
    const bool finite = std::isfinite(sample.time_s) && sample.position_m.allFinite() &&
                        sample.velocity_mps.allFinite() && sample.acceleration_mps2.allFinite() &&
                        sample.world_from_body.coeffs().allFinite() &&
                        sample.body_rate_radps.allFinite();
    if (!finite) {
        throw InputError(where, "a value is not finite", "leave the sample out");
    }
    const double norm = sample.world_from_body.norm();
    if (std::abs(norm - 1.0) > greatest_norm_error) {
        throw InputError(where, fmt::format("its quaternion has norm {:.6g}", norm),
                         "hand over a unit quaternion");
    }
}

// Written out, not left to Eigen: its order of sums (and, on some processors, fused products)
// depends on the build, and the last bit of a pose decides cells.

Eigen::Quaterniond unit(const Eigen::Quaterniond& q) {
    const double norm =
        std::sqrt(((q.w() * q.w() + q.x() * q.x()) + q.y() * q.y()) + q.z() * q.z());
    return {q.w() / norm, q.x() / norm, q.y() / norm, q.z() / norm};
}

Eigen::Quaterniond product(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    return {a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
            a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
            a.w() * b.y() - a.x() * b.z() + a.y() * b.w() + a.z() * b.x(),
            a.w() * b.z() + a.x() * b.y() - a.y() * b.x() + a.z() * b.w()};
}

Eigen::Quaterniond turn_by(const Eigen::Vector3d& rate_radps, double dt_s) {
    const double x = rate_radps.x() * dt_s;
    const double y = rate_radps.y() * dt_s;
    const double z = rate_radps.z() * dt_s;
    const double angle_rad = std::sqrt((x * x + y * y) + z * z);
    if (angle_rad == 0.0) {
        return Eigen::Quaterniond::Identity();
    }
    const double share = std::sin(angle_rad / 2.0) / angle_rad;
    return {std::cos(angle_rad / 2.0), x * share, y * share, z * share};
}

} // namespace

void NavigationBuffer::add(const NavigationSample& sample) {
    check_sample(sample);
    if (!samples_.empty() && sample.time_s <= samples_.back().time_s) {
        throw InputError(
            fmt::format("navigation sample at {:.6f} s", sample.time_s),
            fmt::format("it is not after the previous one at {:.6f} s", samples_.back().time_s),
            "hand samples over in increasing order of time");
    }
    samples_.push_back(sample);
    while (samples_.front().time_s < sample.time_s - kept_s) {
        samples_.pop_front();
    }
}

std::optional<Eigen::Isometry3d> NavigationBuffer::world_from_body(double time_s,
                                                                   double max_gap_s) const {
    const auto nearest = std::ranges::min_element(
        samples_, {}, [time_s](const auto& sample) { return std::abs(sample.time_s - time_s); });
    if (nearest == samples_.end() || !(std::abs(nearest->time_s - time_s) <= max_gap_s)) {
        return std::nullopt;
    }
    return extrapolate_pose(*nearest, time_s - nearest->time_s);
}

Eigen::Isometry3d extrapolate_pose(const NavigationSample& sample, double dt_s) {
    const Eigen::Quaterniond attitude =
        product(unit(sample.world_from_body), turn_by(sample.body_rate_radps, dt_s));
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = attitude.toRotationMatrix();
    for (int i = 0; i < 3; ++i) {
        pose(i, 3) = (sample.position_m[i] + sample.velocity_mps[i] * dt_s) +
                     sample.acceleration_mps2[i] * dt_s * dt_s / 2.0;
    }
    return pose;
}

Eigen::Isometry3d mount_sensor(const Eigen::Isometry3d& world_from_body,
                               const Eigen::Isometry3d& body_from_sensor) {
    const auto& a = world_from_body;
    const auto& b = body_from_sensor;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 4; ++j) {
            pose(i, j) = (a(i, 0) * b(0, j) + a(i, 1) * b(1, j)) + a(i, 2) * b(2, j);
        }
        pose(i, 3) += a(i, 3);
    }
    return pose;
}

} // namespace zonegrid
