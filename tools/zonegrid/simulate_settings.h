#pragma once

#include "setting_table.h"
#include "simulation/simulation.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

/// Everything that `zonegrid simulate` can be told.
struct SimulateSettings {
    std::optional<std::string> scene;
    std::optional<std::string> output;
    std::string seed = "1";
    std::optional<double> seconds;
    std::optional<double> rate_hz;
    std::optional<std::string> size;
    SensorFaults sensor;
    NavigationFaults navigation;
    TransferFaults transfer;
    double late_by_ms = 30.0;
    bool all_faults = false;
    bool overwrite = false;
    bool quiet = false;
};

/// Adds the settings to `table`, which must not outlive `settings`.
void add_simulate_settings(SettingTable& table, SimulateSettings& settings);

/// What to simulate. Faults of --all-faults that `given`, the names of the arguments, does not hold
/// have their usual strength; the disparities' is that of the scene's camera.
[[nodiscard]] SimulationOptions simulation_options(const SimulateSettings& settings,
                                                   const std::vector<std::string>& given,
                                                   const Camera& camera);

/// The seed that the settings name.
[[nodiscard]] std::uint64_t seed_of(const SimulateSettings& settings);

/// The file that a scene's name means: the file itself, else scenes/NAME.toml.
/// Throws UsageError if there is neither.
[[nodiscard]] std::filesystem::path scene_file(const std::string& name);

/// Puts --rate and --size into the scene: the field of view stays as it is.
void apply_camera_settings(const SimulateSettings& settings, Scene& scene);

} // namespace zonegrid
