#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>

namespace zonegrid {

/// How the rotor shakes the camera: turns about each of the body's axes and shifts along them, once
/// and twice a revolution, which the navigation does not see.
class Vibration {
public:
    /// `amplitude_deg` is that of each axis' turn once a revolution; 0: none.
    Vibration(double amplitude_deg, std::uint64_t seed);

    /// The shaken body in the body that navigation knows.
    [[nodiscard]] Eigen::Isometry3d at(double time_s) const;

private:
    static constexpr std::size_t axes = 6; ///< three turns, three shifts

    double amplitude_deg_;
    std::array<std::array<double, 2>, axes> phases_rad_{};
};

} // namespace zonegrid
