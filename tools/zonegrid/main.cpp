#include "command.h"
#include "interruption.h"
#include "standard_output.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>

namespace {

constexpr int failure = 1;
constexpr int usage = 2;
constexpr int check_failed = 4;

constexpr const char* description =
    "zonegrid makes three-dimensional obstacle maps from depth images and navigation.";

int complain(const std::string& problem, int exit_code) {
    // fmt::print() would throw where standard error is full, and so hide the exit code.
    std::fputs(fmt::format("zonegrid: {}\n", problem).c_str(), stderr);
    return exit_code;
}

/// CLI11's own complaints, in one line and with a remedy.
int complain_about_usage(const CLI::App& app, const CLI::ParseError& error) {
    std::string problem = error.what();
    std::replace(problem.begin(), problem.end(), '\n', ' ');
    std::string command = "zonegrid";
    for (const CLI::App* const subcommand : app.get_subcommands()) {
        command += " " + subcommand->get_name();
    }
    return complain(fmt::format("{}; see {} --help", problem, command), usage);
}

/// Parses, and runs the subcommand that was asked for.
void run(CLI::App& app, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty()) {
            zonegrid::write_standard_output(app.help());
        }
    } catch (const CLI::CallForHelp&) {
        const auto subcommands = app.get_subcommands();
        zonegrid::write_standard_output(subcommands.empty() ? app.help()
                                                            : subcommands[0]->help("zonegrid"));
    } catch (const CLI::CallForVersion& version) {
        zonegrid::write_standard_output(std::string(version.what()) + "\n");
    }
}

int run_and_explain(CLI::App& app, int argc, const char* const* argv) {
    try {
        run(app, argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        return complain_about_usage(app, error);
    } catch (const zonegrid::StandardOutputClosed&) {
        return 0; // the reader has what it wanted
    } catch (const zonegrid::UsageError& error) {
        return complain(error.what(), usage);
    } catch (const zonegrid::CapacityError& error) {
        return complain(error.what(), usage);
    } catch (const zonegrid::CheckFailed& error) {
        return complain(error.what(), check_failed);
    } catch (const std::bad_alloc&) {
        return complain("memory is exhausted; use larger cells, a smaller range or a smaller scene",
                        failure);
    } catch (const std::exception& error) {
        return complain(error.what(), failure);
    }
}

} // namespace

// What the options' own set-up throws is a bug, and ends the process.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    // Writes fail with an error instead: it is reported and cleaned up after.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    CLI::App app(description, "zonegrid");
    app.set_version_flag("--version", std::string("zonegrid ") + ZONEGRID_VERSION);
    app.require_subcommand(0, 1);
    zonegrid::add_map_command(app);
    zonegrid::add_inspect_command(app);
    zonegrid::add_dump_command(app);
    zonegrid::add_devices_command(app);
    zonegrid::add_check_command(app);
    zonegrid::add_doctor_command(app);
#ifdef ZONEGRID_SIMULATION
    zonegrid::add_simulate_command(app);
    zonegrid::add_evaluate_command(app);
#endif
    app.footer(std::string("zonegrid COMMAND --help explains a command.\n") + zonegrid::exit_codes);
    try {
        return run_and_explain(app, argc, argv);
    } catch (const zonegrid::Interrupted& interrupted) {
        complain("interrupted; nothing was written", failure);
        std::signal(interrupted.signal, SIG_DFL);
        std::raise(interrupted.signal); // whoever started this sees how it ended
        return failure;
    }
}
