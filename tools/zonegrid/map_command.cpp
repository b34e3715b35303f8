#include "command.h"
#include "interruption.h"
#include "io/history_file.h"
#include "io/json_text.h"
#include "io/new_folder.h"
#include "io/output_file.h"
#include "map_run.h"
#include "memory_use.h"
#include "pipeline/stopwatch.h"
#include "progress.h"
#include "standard_output.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <span>

namespace zonegrid {
namespace {

constexpr const char* description =
    "Maps a recording: replays its depth images or laser scans with their navigation and writes\n"
    "the map, its objects and pictures of its height profile to a new folder.";

constexpr const char* help_footer =
    "DIR holds report.json, profile.png, profile_3d.png, objects.json, cells.zgrid and, with\n"
    "--history, history.zgrid (docs/formats.md). It appears whole or not at all. Images that "
    "cannot\n"
    "be read or have no navigation are skipped, counted and listed in the report.\n"
    "\n"
    "cells.zgrid holds the cells of the window at the end. zonegrid evaluate judges more of a map\n"
    "that was made with --history.\n"
    "\n"
    "A configuration file has the options' names: cell = 0.25, model = \"span\". Options of the\n"
    "command line win over it.\n"
    "\n"
    "Examples:\n"
    "  zonegrid map flight1 -o out/flight1 --cell 0.25 --range 60\n"
    "  zonegrid map desk -o out/desk --cell 0.02 --range 4 --frames 0:50 --overwrite\n"
    "  zonegrid map flight1 -o out/flight1 --backend auto\n"
    "  zonegrid map flight1 -o out/flight1 --backend vulkan --device radeon\n"
    "  zonegrid map flight1 --cell 0.5 --dump-config > coarse.toml\n"
    "  zonegrid map flight1 -o out/coarse --config coarse.toml\n"
    "\n";

struct MapCommand {
    MapSettings settings;
    SettingTable table;
    std::string config_file;
    bool dump_config = false;
};

/// Replays the recording, with progress on a terminal. `history`, if any, sees all of it.
ReplaySummary replay_with_progress(const MapRun& run, Mapper& mapper, MapHistory* history,
                                   const InterruptionGuard& interruption) {
    const FrameSpan& span = run.span;
    Progress progress(span.last - span.first, !run.settings.quiet);
    if (history != nullptr) {
        mapper.observe_zones(
            [history](const CellIndex& first, std::span<const std::int8_t> values) {
                history->take(first, values);
            });
    }
    return replay(run.recording, span, mapper, [&](const ReplaySummary& so_far) {
        interruption.check();
        progress.show(so_far.images);
        if (history != nullptr) {
            history->begin_image(static_cast<std::uint32_t>(span.first + so_far.images));
        }
    });
}

ProfilePictureOptions picture_options(const MapRun& run) {
    ProfilePictureOptions pictures;
    pictures.title = run.recording.path().filename().string();
    pictures.subtitle =
        fmt::format("cell {:.2f} m, {} {}, {} model", run.options.cell_m, run.replay.integrated,
                    run.recording.camera() ? "images" : "scans", run.settings.model);
    return pictures;
}

void write_report(const std::filesystem::path& file, const std::string& report) {
    OutputFile output(file);
    output.write(report);
    output.close();
}

void warn(const std::string& text) {
    std::fputs(fmt::format("zonegrid: warning: {}\n", text).c_str(), stderr);
}

void map(const MapSettings& settings) {
    if (!settings.output) {
        throw UsageError("--output is missing: name the folder to make for the map with -o DIR");
    }
    Stopwatch stopwatch;
    MapperOptions options = mapper_options(settings);
    const std::unique_ptr<Recording> recording = open_recording(settings.source);
    const FrameSpan span = frame_span(settings, recording->frames().size());
    const BackendChoice backend = choose_backend(settings);
    options.backend = backend.backend;
    if (!backend.reason.empty() && !settings.quiet) {
        std::fputs(fmt::format("zonegrid: auto: {}\n", backend.reason).c_str(), stderr);
    }
    MapRun run{*recording, settings, backend, options, span};
    Mapper mapper(options, recording->camera());
    const InterruptionGuard interruption;
    NewFolder folder(*settings.output, settings.overwrite ? std::span(map_folder_names)
                                                          : std::span<const std::string_view>());
    std::optional<MapHistory> history;
    if (settings.history) {
        history.emplace(options);
    }
    run.replay = replay_with_progress(run, mapper, history ? &*history : nullptr, interruption);
    if (run.replay.integrated == 0) {
        throw Error(explain_no_image(run.replay));
    }
    run.contents = write_map_files(folder.path(), mapper, settings.cut_height,
                                   run.replay.trajectory_m, picture_options(run));
    if (history) {
        write_history_file(folder.path() / history_name, *history,
                           static_cast<std::uint32_t>(recording->frames().size()));
    }
    run.statistics = mapper.statistics();
    run.warnings = find_map_warnings(run.replay, run.statistics, options);
    run.memory_most_bytes = memory_most_bytes();
    run.total_s = stopwatch.lap_s();
    const std::string report = json_text(report_of(run));
    write_report(folder.path() / report_name, report);
    interruption.check();
    folder.put_in_place();
    for (const std::string& warning : run.warnings) {
        warn(warning);
    }
    if (settings.json) {
        write_standard_output(report);
    } else if (!settings.quiet) {
        write_standard_output(summary_of(run, *settings.output));
    }
}

void run_map(MapCommand& command) {
    if (!command.config_file.empty()) {
        command.table.read_file(command.config_file);
    }
    command.table.read_arguments();
    if (command.dump_config) {
        static_cast<void>(mapper_options(command.settings)); // only what works is worth keeping
        write_standard_output(command.table.to_toml());
        return;
    }
    map(command.settings);
}

} // namespace

void add_map_command(CLI::App& app) {
    const auto command = std::make_shared<MapCommand>();
    CLI::App* const map_app = app.add_subcommand("map", description);
    add_map_settings(command->table, command->settings);
    command->table.declare(*map_app);
    map_app->add_option("--config", command->config_file, "take options from a TOML file")
        ->type_name("FILE.toml")
        ->group("Configuration");
    map_app
        ->add_flag("--dump-config", command->dump_config,
                   "print all options as a configuration file, and do nothing else")
        ->group("Configuration");
    map_app->footer(std::string(help_footer) + exit_codes);
    map_app->callback([command] { run_map(*command); });
}

} // namespace zonegrid
