#pragma once

#include "io/plain_writer.h"
#include "simulation/faults.h"
#include "simulation/scene.h"
#include "truth/truth_folder.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

/// How to simulate a scene.
struct SimulationOptions {
    std::uint64_t seed = 1;
    std::optional<double> duration_s{}; ///< in place of the scene's
    SensorFaults sensor;
    NavigationFaults navigation;
    TransferFaults transfer;
};

/// A simulated flight, but for its pixels.
struct SimulatedFlight {
    double duration_s = 0.0;
    double way_m = 0.0;                  ///< flown
    std::vector<EulerSample> navigation; ///< as recorded
    std::vector<double> image_times_s;   ///< as recorded
    std::vector<std::uint64_t> numbers;  ///< of the recorded images among those taken, from 0
    std::uint64_t images_taken = 0;
    std::uint64_t images_late = 0;
    std::uint64_t navigation_lost = 0;
    std::vector<TrueImage> taken; ///< every image, also those that were lost
    Truth truth;
};

/// Flies the scene's route and takes down when what was measured.
/// Throws UsageError if the scene or an option cannot work, or no image is left.
[[nodiscard]] SimulatedFlight fly(const Scene& scene, const SimulationOptions& options);

/// Names in the folder that `write_simulation` fills.
inline constexpr std::array<std::string_view, 5> simulation_names{
    "description.toml", "navigation.csv", "frames.csv", "depth", "truth"};

/// Value at 1 m of the depth images that are written: they reach to 128 m.
inline constexpr double simulated_units_per_m = 512.0;

/// The value of a pixel: 0 if `depth_m` is 0 (missing), 65535 if it is infinite or too far for
/// 16 bits, so that it is free up to any range below 128 m.
[[nodiscard]] std::uint16_t depth_value(float depth_m);

/// Draws the flight's images and writes it to the existing, empty `folder`: a recording of the
/// plain layout and `truth/`. The same scene, options and flight give the same bytes, whatever the
/// number of threads. `observe` gets the number of images written so far, and may throw.
/// Throws OutputError.
void write_simulation(const std::filesystem::path& folder, const Scene& scene,
                      const SimulationOptions& options, const SimulatedFlight& flight,
                      const std::function<void(std::uint64_t)>& observe = {});

/// The faults that are on, as options of `zonegrid simulate`: "--stereo-noise 0.25 ...". Empty if
/// there are none.
[[nodiscard]] std::string fault_arguments(const SimulationOptions& options);

} // namespace zonegrid
