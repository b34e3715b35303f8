#pragma once

#include <CLI/CLI.hpp>

#include "zonegrid/errors.h"

namespace zonegrid {

// One function a subcommand: declares it, its options and what happens when it is called. What the
// subcommand throws comes out of CLI::App::parse.

void add_map_command(CLI::App& app);
void add_dump_command(CLI::App& app);
void add_inspect_command(CLI::App& app);
void add_devices_command(CLI::App& app);
void add_check_command(CLI::App& app);
void add_doctor_command(CLI::App& app);
void add_simulate_command(CLI::App& app); ///< only where ZONEGRID_SIMULATION is on
void add_evaluate_command(CLI::App& app); ///< only where ZONEGRID_SIMULATION is on

/// A device's map differs from the reference's; exit code 4.
class CheckFailed : public Error {
public:
    using Error::Error;
};

/// The end of every --help.
inline constexpr const char* exit_codes =
    "Exit codes: 0 success; 1 failure (data wrong, nothing mapped, output not writable);\n"
    "2 an option or argument that cannot work; 4 a device's map is not the expected one (check).\n"
    "Errors are one line on standard error.";

} // namespace zonegrid
