#pragma once

#include "io/recording.h"
#include "zonegrid/options.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace zonegrid {

/// How the sensor of a generated flight sits in the body: position in metres, then roll, pitch and
/// yaw in degrees from looking forward, as description.toml gives them.
struct GeneratedMounting {
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d roll_pitch_yaw_deg = Eigen::Vector3d::Zero();
};

/// A navigation sample of a generated flight: its attitude is the one that these angles give.
struct GeneratedSample {
    NavigationSample sample;
    Eigen::Vector3d roll_pitch_yaw_rad = Eigen::Vector3d::Zero();
};

/// What a generated flight is made of; all that a folder of the plain layout says of it.
struct FlightPlan {
    MapperOptions options; ///< to map it with
    std::optional<Camera> camera;
    GeneratedMounting mounting;
    std::vector<GeneratedSample> navigation;
    std::vector<double> times_s;
    std::vector<FrameData> frames;
};

/// A random flight of a few small images or scans, kept in memory, together with the options to map
/// it with. Flights go where kernels err: odd image sizes, both sensor models, missing, infinite
/// and noisy depth and steps, sensors on borders of cells and zones, windows that move away and
/// return, cells at their limits. The same seed and number give the same flight everywhere.
class GeneratedFlight final : public Recording {
public:
    GeneratedFlight(std::uint64_t seed, std::uint64_t number);
    explicit GeneratedFlight(FlightPlan plan);

    [[nodiscard]] const FlightPlan& plan() const { return plan_; }
    [[nodiscard]] const MapperOptions& options() const { return plan_.options; }
    [[nodiscard]] FrameData read_frame(std::size_t index) const override;

private:
    FlightPlan plan_;
};

/// The flight `number` of `seed`. One in five has a laser scanner, the others a camera.
[[nodiscard]] FlightPlan plan_flight(std::uint64_t seed, std::uint64_t number);

} // namespace zonegrid
