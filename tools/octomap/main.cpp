#include "interruption.h"
#include "io/cells_file.h"
#include "io/history_file.h"
#include "io/json_text.h"
#include "io/map_folder.h"
#include "io/new_folder.h"
#include "io/object_listing.h"
#include "io/objects_file.h"
#include "io/output_file.h"
#include "io/sha256.h"
#include "octomap_flight.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <string>

// Maps a recording with OctoMap into a folder that zonegrid evaluate judges: the same recording,
// the same truth, the same measures.

namespace zonegrid {
namespace {

constexpr const char* description =
    "Maps a recording's depth images with OctoMap, for comparison: DIR is judged by zonegrid\n"
    "evaluate as a map of zonegrid's with --history is. Every pixel is a ray; OctoMap's "
    "parameters\n"
    "are its defaults.";

struct Arguments {
    std::string recording;
    std::string output;
    OctoMapOptions options;
};

nlohmann::ordered_json report_of(const Recording& recording, const Arguments& arguments,
                                 const OctoMapFlight& flight, const std::string& objects_digest) {
    nlohmann::ordered_json report;
    report["recording"] = {{"path", recording.path().string()},
                           {"frames", recording.frames().size()},
                           {"first_frame_s", recording.frames().front().time_s},
                           {"last_frame_s", recording.frames().back().time_s}};
    if (const auto& truth = recording.truth_digest()) {
        report["recording"]["truth_digest"] = *truth;
    }
    report["parameters"] = {
        {"cell_m", arguments.options.cell_m},
        {"range_m", arguments.options.range_m},
        {"model", arguments.options.discretize ? "octomap, discretized" : "octomap"},
        {"max_gap_s", arguments.options.max_gap_s},
        {"frames", {std::size_t{0}, recording.frames().size()}}};
    report["images"] = {{"integrated", flight.integrated}, {"skipped", flight.skipped}};
    // No window: all cells are in the history.
    report["map"] = {{"window_first_cell", {0, 0, 0}}, {"window_cells", 0}};
    report["digest"] = {{"cells", Sha256().finish_hex()}, {"objects", objects_digest}};
    report["time"] = {{"insert_ms", flight.insert_ms}};
    return report;
}

void write_folder(const Recording& recording, const Arguments& arguments,
                  const OctoMapFlight& flight, const std::filesystem::path& folder) {
    CellsFileWriter cells(folder / cells_name, flight.history.options());
    cells.close();
    write_history_file(folder / history_name, flight.history,
                       static_cast<std::uint32_t>(recording.frames().size()));
    write_objects_file(folder / objects_name, flight.objects, arguments.options.cell_m);
    Sha256 digest;
    for (const Object& object : flight.objects) {
        digest.add(object_line(object));
    }
    OutputFile output(folder / report_name);
    output.write(json_text(report_of(recording, arguments, flight, digest.finish_hex())));
    output.close();
}

void run(const Arguments& arguments) {
    const auto recording = open_recording(arguments.recording, {});
    const InterruptionGuard interruption;
    NewFolder folder(arguments.output, {});
    const bool show = isatty(STDERR_FILENO) != 0;
    const auto flight = fly_octomap(*recording, arguments.options, [&](std::size_t images) {
        interruption.check();
        if (show) {
            std::fputs(fmt::format("\r{} of {} images", images, recording->frames().size()).c_str(),
                       stderr);
        }
    });
    if (show) {
        std::fputs("\n", stderr);
    }
    write_folder(*recording, arguments, flight, folder.path());
    interruption.check();
    folder.put_in_place();
    fmt::print("{} images, {} skipped, median {:.1f} ms in insertPointCloud, {} objects\n",
               flight.integrated, flight.skipped, flight.insert_ms, flight.objects.size());
}

int run_command(int count, char** arguments_of_command) {
    CLI::App app(description, "zonegrid-octomap");
    Arguments arguments;
    app.add_option("RECORDING", arguments.recording, "folder with depth images and navigation")
        ->required()
        ->type_name("");
    app.add_option("-o,--output", arguments.output, "folder to make for the map")
        ->required()
        ->type_name("DIR");
    app.add_option("--cell", arguments.options.cell_m, "edge of a cell, metres")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--range", arguments.options.range_m, "greatest distance of a ray, metres")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--max-gap", arguments.options.max_gap_s,
                   "greatest time between an image and navigation, seconds")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_flag("--discretize", arguments.options.discretize,
                 "one ray for all pixels that end in the same cell");
    try {
        app.parse(count, arguments_of_command);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        run(arguments);
    } catch (const UsageError& error) {
        std::fputs(fmt::format("zonegrid-octomap: {}\n", error.what()).c_str(), stderr);
        return 2;
    } catch (const Interrupted& interrupted) {
        std::fputs("zonegrid-octomap: interrupted; nothing was written\n", stderr);
        std::signal(interrupted.signal, SIG_DFL);
        std::raise(interrupted.signal); // whoever started this sees how it ended
        return 1;
    } catch (const std::exception& error) {
        std::fputs(fmt::format("zonegrid-octomap: {}\n", error.what()).c_str(), stderr);
        return 1;
    }
    return 0;
}

} // namespace
} // namespace zonegrid

// What the options' own set-up throws is a bug, and ends the process.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int count, char** arguments) {
    return zonegrid::run_command(count, arguments);
}
