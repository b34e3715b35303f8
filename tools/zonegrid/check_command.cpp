#include "backend_choice.h"
#include "check_settings.h"
#include "command.h"
#include "device/device_choice.h"
#include "interruption.h"
#include "io/map_comparison.h"
#include "progress.h"
#include "standard_output.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace zonegrid {
namespace {

constexpr const char* description =
    "Checks that devices make the reference's map of a recording, or of random flights: local\n"
    "maps, cells, objects with boxes, octrees and prisms, and height profile, bit for bit. Of a\n"
    "recording they are compared after every tenth image and the last (--every), and what changed\n"
    "after every image; of generated flights all is compared after every image.";

constexpr const char* help_footer =
    "With --backend reference, which is the default, every usable device is checked. Where a map\n"
    "differs, the operation, the first image, the first cell, its zone, both values and how many\n"
    "cells differ are printed, and the exit code is 4.\n"
    "\n"
    "--generated makes flights of a few small images or scans from a seed: odd sizes, both sensor\n"
    "models, all kinds of depth, sensors on borders, windows that return, cells at their limits. "
    "The\n"
    "same seed gives the same flights. The first that differs is saved as a recording, with the\n"
    "command that checks it again in its file replay.txt.\n"
    "\n"
    "Examples:\n"
    "  zonegrid check flight1 --cell 0.5\n"
    "  zonegrid check flight1 --cell 0.5 --frames 0:100 --backend vulkan:0 --every 1\n"
    "  zonegrid check --generated 1\n"
    "  zonegrid check --generated 42 --cases 2000 --device radeon -o case\n"
    "\n";

struct CheckCommand {
    CheckSettings settings;
    SettingTable table;
};

std::vector<std::string> backends_to_check(const MapSettings& settings) {
    if (settings.mapper.backend != "reference" || settings.device) {
        return {choose_backend(settings).backend};
    }
    std::vector<std::string> names;
    for (const auto& info : device::list_devices().devices) {
        if (info.refusal.empty()) {
            names.push_back(info.id());
        }
    }
    if (names.empty()) {
        throw Error("no device can be checked; zonegrid doctor says why");
    }
    return names;
}

std::string text_of(const std::string& device, const MapDifference& difference) {
    return fmt::format("{}: {} differ after image {} ({})\n  {}: {}\n", device, difference.what,
                       difference.images, difference.frame, difference.operation,
                       difference.detail);
}

void check_recording(const CheckSettings& settings, const std::vector<std::string>& backends) {
    MapperOptions expected_options = mapper_options(settings.map);
    expected_options.backend = settings.against;
    const auto every = static_cast<std::size_t>(settings.every);
    const std::unique_ptr<Recording> recording = open_recording(settings.map.source);
    const FrameSpan span = frame_span(settings.map, recording->frames().size());
    const InterruptionGuard interruption;
    const std::size_t images = span.last - span.first;
    const auto watched = [&](const auto& run) {
        Progress progress(images, true);
        return run([&](const ReplaySummary& so_far) {
            interruption.check();
            progress.show(so_far.images);
        });
    };
    const auto expected = watched([&](const ReplayObserver& observer) {
        return take_steps(*recording, span, {expected_options}, every, observer);
    });
    std::string differing;
    for (const auto& name : backends) {
        MapperOptions options = expected_options;
        options.backend = name;
        const auto difference = watched([&](const ReplayObserver& observer) {
            return find_difference(*recording, span, {expected_options}, expected, {options}, every,
                                   observer);
        });
        if (difference) {
            differing += (differing.empty() ? "" : ", ") + name;
        }
        write_standard_output(difference ? text_of(name, *difference)
                                         : fmt::format("{}: {}, {} images, {} cells changed\n",
                                                       name, expected_map(settings), images,
                                                       expected.back().cells_changed));
    }
    if (!differing.empty()) {
        throw CheckFailed(
            fmt::format("{}: not {}; do not fly with it", differing, expected_map(settings)));
    }
}

void run_check(CheckCommand& command) {
    command.table.read_arguments();
    const CheckSettings& settings = command.settings;
    require_consistent(settings, command.table.given());
    static_cast<void>(mapper_options(settings.map)); // complaints about options come first
    if (settings.against != "reference") {
        static_cast<void>(device::find_device(settings.against));
    }
    const auto backends = backends_to_check(settings.map);
    if (settings.seed) {
        check_generated(settings, backends);
    } else {
        check_recording(settings, backends);
    }
}

} // namespace

void add_check_command(CLI::App& app) {
    const auto command = std::make_shared<CheckCommand>();
    CLI::App* const check_app = app.add_subcommand("check", description);
    add_check_settings(command->table, command->settings);
    command->table.declare(*check_app);
    check_app->footer(std::string(help_footer) + exit_codes);
    check_app->callback([command] { run_check(*command); });
}

} // namespace zonegrid
