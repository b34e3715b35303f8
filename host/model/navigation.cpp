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
    const Eigen::Vector3d turn_rad = sample.body_rate_radps * dt_s;
    const double angle_rad = turn_rad.norm();
    Eigen::Quaterniond attitude = sample.world_from_body.normalized();
    if (angle_rad > 0.0) {
        attitude = attitude * Eigen::AngleAxisd(angle_rad, turn_rad / angle_rad);
    }
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = attitude.toRotationMatrix();
    pose.translation() = sample.position_m + sample.velocity_mps * dt_s +
                         sample.acceleration_mps2 * (0.5 * dt_s * dt_s);
    return pose;
}

} // namespace zonegrid
