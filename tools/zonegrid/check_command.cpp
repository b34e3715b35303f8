#include "backend_choice.h"
#include "command.h"
#include "device/device.h"
#include "interruption.h"
#include "io/map_comparison.h"
#include "map_settings.h"
#include "progress.h"
#include "standard_output.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace zonegrid {
namespace {

constexpr const char* description =
    "Checks that devices make the reference's map of a recording: cells, objects and height "
    "profile,\n"
    "bit for bit, after every tenth image and the last, and what changed after every image.";

constexpr const char* help_footer =
    "With --backend reference, which is the default, every usable device is checked. Where a map\n"
    "differs, the first image, the first cell, its zone and both values are printed, and the exit\n"
    "code is 4.\n"
    "\n"
    "Examples:\n"
    "  zonegrid check flight1 --cell 0.5\n"
    "  zonegrid check flight1 --cell 0.5 --frames 0:100 --backend vulkan:0\n"
    "\n";

constexpr std::size_t digest_every = 10;

struct CheckCommand {
    MapSettings settings;
    SettingTable table;
};

std::vector<std::string> devices_to_check(const MapSettings& settings) {
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
        throw Error("no device can be checked; zonegrid devices says what was looked for");
    }
    return names;
}

std::string text_of(const std::string& device, const MapDifference& difference) {
    return fmt::format("{}: {} differ after image {} ({})\n  {}: {}\n", device, difference.what,
                       difference.images, difference.frame, difference.operation,
                       difference.detail);
}

void check(const MapSettings& settings) {
    const MapperOptions expected_options = mapper_options(settings);
    const auto names = devices_to_check(settings);
    const std::unique_ptr<Recording> recording = open_recording(settings.source);
    const FrameSpan span = frame_span(settings, recording->frames().size());
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
        return take_steps(*recording, span, {expected_options}, digest_every, observer);
    });
    std::string differing;
    for (const auto& name : names) {
        MapperOptions options = expected_options;
        options.backend = name;
        const auto difference = watched([&](const ReplayObserver& observer) {
            return find_difference(*recording, span, {expected_options}, expected, {options},
                                   digest_every, observer);
        });
        if (difference) {
            differing += (differing.empty() ? "" : ", ") + name;
        }
        write_standard_output(difference
                                  ? text_of(name, *difference)
                                  : fmt::format("{}: the reference's map, {} images, {} cells "
                                                "changed\n",
                                                name, images, expected.back().cells_changed));
    }
    if (!differing.empty()) {
        throw CheckFailed(differing + ": the map is not the reference's; do not fly with it");
    }
}

} // namespace

void add_check_command(CLI::App& app) {
    const auto command = std::make_shared<CheckCommand>();
    CLI::App* const check_app = app.add_subcommand("check", description);
    add_mapping_settings(command->table, command->settings);
    command->table.declare(*check_app);
    check_app->footer(std::string(help_footer) + exit_codes);
    check_app->callback([command] {
        command->table.read_arguments();
        check(command->settings);
    });
}

} // namespace zonegrid
