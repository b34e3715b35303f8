#include "command.h"
#include "inspection_report.h"
#include "io/json_text.h"
#include "map_settings.h"
#include "standard_output.h"

#include <limits>
#include <memory>

namespace zonegrid {
namespace {

constexpr const char* description =
    "Looks at a recording without mapping it: times and gaps, navigation, path, distances, and "
    "what\n"
    "usually goes wrong (depth scale, world axes, poses given inside out, damaged files).";

constexpr const char* help_footer =
    "Examples:\n"
    "  zonegrid inspect flight1\n"
    "  zonegrid inspect flight1 --all --json > flight1.json\n"
    "\n";

constexpr std::size_t frames_looked_at = 50;

struct InspectSettings {
    RecordingSettings source;
    double max_gap_s = MapperOptions().max_gap_s;
    bool all = false;
    bool json = false;
};

struct InspectCommand {
    InspectSettings settings;
    SettingTable table;
};

void add_inspect_settings(SettingTable& table, InspectSettings& settings) {
    add_recording_settings(table, settings.source);
    table.start_group("Inspection");
    table.add(max_gap_setting(settings.max_gap_s));
    table.add(switch_setting(
        "all", fmt::format("read every image in place of {} evenly spread ones", frames_looked_at),
        settings.all));
    table.add(switch_setting("json", "print JSON", settings.json));
}

void inspect(const InspectSettings& settings) {
    const std::unique_ptr<Recording> recording = open_recording(settings.source);
    const RecordingInspection inspection = inspect_recording(
        *recording, settings.max_gap_s,
        settings.all ? std::numeric_limits<std::size_t>::max() : frames_looked_at);
    write_standard_output(settings.json ? json_text(inspection_report(*recording, inspection))
                                        : inspection_text(*recording, inspection));
}

} // namespace

void add_inspect_command(CLI::App& app) {
    const auto command = std::make_shared<InspectCommand>();
    CLI::App* const inspect_app = app.add_subcommand("inspect", description);
    add_inspect_settings(command->table, command->settings);
    command->table.declare(*inspect_app);
    inspect_app->footer(std::string(help_footer) + exit_codes);
    inspect_app->callback([command] {
        command->table.read_arguments();
        inspect(command->settings);
    });
}

} // namespace zonegrid
