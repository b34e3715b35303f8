#include "simulation/vibration.h"

#include "simulation/counted_numbers.h"
#include "zonegrid/sensors.h"

#include <cmath>
#include <numbers>

namespace zonegrid {
namespace {

/// A small helicopter's rotor; no multiple of it is near that of usual image rates.
constexpr double rotor_hz = 13.7;
/// Twice a revolution the blades shake less than their imbalance does once.
constexpr double twice_share = 0.5;
constexpr double m_per_deg = 0.02;
constexpr double rad_per_deg = std::numbers::pi / 180.0;

} // namespace

Vibration::Vibration(double amplitude_deg, std::uint64_t seed) : amplitude_deg_(amplitude_deg) {
    const CountedNumbers numbers(seed, Stream::vibration);
    for (std::size_t axis = 0; axis < axes; ++axis) {
        for (std::size_t harmonic = 0; harmonic < 2; ++harmonic) {
            phases_rad_[axis][harmonic] =
                2.0 * std::numbers::pi * numbers.share(2 * axis + harmonic);
        }
    }
}

Eigen::Isometry3d Vibration::at(double time_s) const {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    if (amplitude_deg_ == 0.0) {
        return pose;
    }
    const double turned_rad = 2.0 * std::numbers::pi * rotor_hz * time_s;
    std::array<double, axes> deflections{};
    for (std::size_t axis = 0; axis < axes; ++axis) {
        deflections[axis] =
            amplitude_deg_ * (std::sin(turned_rad + phases_rad_[axis][0]) +
                              twice_share * std::sin(2.0 * turned_rad + phases_rad_[axis][1]));
    }
    pose.linear() = attitude_from_euler(rad_per_deg * deflections[0], rad_per_deg * deflections[1],
                                        rad_per_deg * deflections[2])
                        .toRotationMatrix();
    pose.translation() =
        m_per_deg * Eigen::Vector3d(deflections[3], deflections[4], deflections[5]);
    return pose;
}

} // namespace zonegrid
