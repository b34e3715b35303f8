#include "command.h"
#include "interruption.h"
#include "io/new_folder.h"
#include "pipeline/stopwatch.h"
#include "progress.h"
#include "simulate_settings.h"
#include "standard_output.h"
#include "text_lines.h"

#include <fmt/format.h>

#include <memory>
#include <system_error>

namespace zonegrid {
namespace {

constexpr const char* description =
    "Simulates the flight of a rotorcraft through a scene and writes what its stereo camera and\n"
    "navigation measure as a recording, together with the truth.";

constexpr const char* help_footer =
    "RECORDING is a recording of the plain layout with a folder truth, which zonegrid evaluate\n"
    "reads (docs/simulation.md). It appears whole or not at all, and the same scene, seed and\n"
    "options give the same bytes. Without faults depth is exact and navigation true.\n"
    "\n"
    "Examples:\n"
    "  zonegrid simulate slalom -o flight1\n"
    "  zonegrid simulate scenes/field.toml -o flight2 --all-faults --seed 7\n"
    "  zonegrid simulate slalom -o flight3 --stereo-noise 0.5 --seconds 20 --size 320x240\n"
    "  zonegrid simulate slalom -o flight4 --all-faults --navigation-errors 0.1\n"
    "\n";

struct SimulateCommand {
    SimulateSettings settings;
    SettingTable table;
};

/// A folder that may be replaced holds a truth: other recordings are nobody's to make again.
void require_simulated(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::is_directory(folder, error) &&
        !std::filesystem::is_regular_file(folder / "truth" / "truth.json", error)) {
        throw OutputError(
            fmt::format("{}: the folder was not simulated, it has no truth; give another folder",
                        folder.string()));
    }
}

std::string summary_of(const SimulateSettings& settings, const SimulationOptions& options,
                       const Scene& scene, const SimulatedFlight& flight, double total_s) {
    const std::string faults = fault_arguments(options);
    const Camera& camera = scene.camera;
    std::string text =
        labelled("Scene", fmt::format("{}, {} obstacles, {} triangles; seed {}", scene.name,
                                      scene.surfaces.obstacles.size(),
                                      scene.surfaces.triangles.size(), options.seed));
    text += labelled("Flight", fmt::format("{:.1f} s, {:.0f} m", flight.duration_s, flight.way_m));
    text += labelled(
        "Images",
        fmt::format("{} of {} x {} pixels, {:.4g} Hz; {} lost, {} late", flight.numbers.size(),
                    camera.width_px, camera.height_px, scene.image_rate_hz,
                    flight.images_taken - flight.numbers.size(), flight.images_late));
    text += labelled("Navigation",
                     fmt::format("{} samples, {:.4g} Hz; {} lost", flight.navigation.size(),
                                 scene.navigation_rate_hz, flight.navigation_lost));
    text += labelled("Faults", faults.empty() ? "none: depth is exact and navigation true "
                                                "(--all-faults for a real camera)"
                                              : faults);
    text += labelled("Time", fmt::format("{:.1f} s", total_s));
    text += labelled("Recording", *settings.output);
    return text;
}

void run_simulate(SimulateCommand& command) {
    command.table.read_arguments();
    const SimulateSettings& settings = command.settings;
    if (!settings.scene) {
        throw UsageError("SCENE is missing: name a scene's TOML file");
    }
    if (!settings.output) {
        throw UsageError(
            "--output is missing: name the folder to make for the recording with -o RECORDING");
    }
    Stopwatch stopwatch;
    Scene scene = read_scene(scene_file(*settings.scene), seed_of(settings));
    apply_camera_settings(settings, scene);
    const SimulationOptions options =
        simulation_options(settings, command.table.given(), scene.camera);
    const SimulatedFlight flight = fly(scene, options);
    const InterruptionGuard interruption;
    if (settings.overwrite) {
        require_simulated(*settings.output);
    }
    NewFolder folder(*settings.output, settings.overwrite ? std::span(simulation_names)
                                                          : std::span<const std::string_view>());
    {
        Progress progress(flight.numbers.size(), !settings.quiet);
        write_simulation(folder.path(), scene, options, flight, [&](std::uint64_t images) {
            interruption.check();
            progress.show(images);
        });
    }
    interruption.check();
    folder.put_in_place();
    if (!settings.quiet) {
        write_standard_output(summary_of(settings, options, scene, flight, stopwatch.lap_s()));
    }
}

} // namespace

void add_simulate_command(CLI::App& app) {
    const auto command = std::make_shared<SimulateCommand>();
    CLI::App* const simulate_app = app.add_subcommand("simulate", description);
    add_simulate_settings(command->table, command->settings);
    command->table.declare(*simulate_app);
    simulate_app->footer(std::string(help_footer) + exit_codes);
    simulate_app->callback([command] { run_simulate(*command); });
}

} // namespace zonegrid
