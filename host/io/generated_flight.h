#pragma once

#include "io/plain_writer.h"
#include "io/recording.h"
#include "zonegrid/options.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace zonegrid {

/// What a generated flight is made of; all that a folder of the plain layout says of it.
struct FlightPlan {
    MapperOptions options; ///< to map it with
    std::optional<Camera> camera;
    SensorMounting mounting;
    std::vector<EulerSample> navigation;
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
