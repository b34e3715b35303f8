#include "support/oracle_pose.h"

#include <cmath>
#include <cstddef>

namespace zonegrid::oracle {

namespace {

struct Turn {
    double w = 1.0;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

Turn operator*(const Turn& a, const Turn& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// Navigation's quaternion is one but for rounding; only its direction counts.
Turn unit(const Eigen::Quaterniond& q) {
    const double norm = std::sqrt(q.w() * q.w() + q.x() * q.x() + q.y() * q.y() + q.z() * q.z());
    return {q.w() / norm, q.x() / norm, q.y() / norm, q.z() / norm};
}

/// Rotation by |rate * dt| about `rate`.
Turn turn_by(const Eigen::Vector3d& rate_radps, double dt_s) {
    const Triple angle{rate_radps.x() * dt_s, rate_radps.y() * dt_s, rate_radps.z() * dt_s};
    const double whole = std::sqrt(angle[0] * angle[0] + angle[1] * angle[1] + angle[2] * angle[2]);
    if (whole == 0.0) {
        return {};
    }
    const double share = std::sin(whole / 2.0) / whole;
    return {std::cos(whole / 2.0), angle[0] * share, angle[1] * share, angle[2] * share};
}

Rotation matrix(const Turn& q) {
    return {{{1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y - q.w * q.z),
              2.0 * (q.x * q.z + q.w * q.y)},
             {2.0 * (q.x * q.y + q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z),
              2.0 * (q.y * q.z - q.w * q.x)},
             {2.0 * (q.x * q.z - q.w * q.y), 2.0 * (q.y * q.z + q.w * q.x),
              1.0 - 2.0 * (q.x * q.x + q.y * q.y)}}};
}

} // namespace

Triple rotate(const Rotation& rotation, const Triple& vector) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double first_two = rotation[i][0] * vector[0] + rotation[i][1] * vector[1];
        result[i] = first_two + rotation[i][2] * vector[2];
    }
    return result;
}

std::optional<Pose> sensor_pose(const std::vector<NavigationSample>& samples, double time_s,
                                double max_gap_s, const Eigen::Isometry3d& body_from_sensor) {
    const NavigationSample* nearest = nullptr;
    for (const NavigationSample& sample : samples) {
        if (nearest == nullptr ||
            std::abs(sample.time_s - time_s) < std::abs(nearest->time_s - time_s)) {
            nearest = &sample;
        }
    }
    if (nearest == nullptr || !(std::abs(nearest->time_s - time_s) <= max_gap_s)) {
        return {};
    }
    const double dt_s = time_s - nearest->time_s;
    const Rotation world_from_body =
        matrix(unit(nearest->world_from_body) * turn_by(nearest->body_rate_radps, dt_s));

    Pose pose;
    Triple lever{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        lever[i] = body_from_sensor.translation()[axis];
        const double travelled = nearest->velocity_mps[axis] * dt_s;
        const double gained = nearest->acceleration_mps2[axis] * dt_s * dt_s / 2.0;
        pose.position_m[i] = nearest->position_m[axis] + travelled + gained;
    }
    const Triple offset = rotate(world_from_body, lever);
    for (std::size_t column = 0; column < 3; ++column) {
        pose.position_m[column] = offset[column] + pose.position_m[column];
        const auto c = static_cast<Eigen::Index>(column);
        const Triple turned = rotate(
            world_from_body, {body_from_sensor.linear()(0, c), body_from_sensor.linear()(1, c),
                              body_from_sensor.linear()(2, c)});
        for (std::size_t row = 0; row < 3; ++row) {
            pose.rotation[row][column] = turned[row];
        }
    }
    return pose;
}

} // namespace zonegrid::oracle
