#include "check_settings.h"
#include "command.h"
#include "interruption.h"
#include "io/device_check.h"
#include "io/generated_case.h"
#include "progress.h"
#include "standard_output.h"

#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <filesystem>

namespace zonegrid {
namespace {

/// How a backend failed in a flight.
struct CaseFailure {
    std::string backend;
    std::string text;
    bool differs = false; ///< else it gave up
};

std::string text_of(const MapDifference& difference, std::size_t images) {
    return fmt::format("{} differ after image {} of {} ({})\n  {}: {}", difference.what,
                       difference.images, images, difference.frame, difference.operation,
                       difference.detail);
}

std::vector<CaseFailure> find_failures(const GeneratedFlight& flight, const FlightCheck& check,
                                       const std::vector<std::string>& backends) {
    std::vector<CaseFailure> failures;
    for (const std::string& backend : backends) {
        try {
            if (const auto difference = check.difference_of(backend)) {
                failures.push_back({backend, text_of(*difference, flight.frames().size()), true});
            }
        } catch (const std::exception& error) { // a driver that gives up: the flight is wanted too
            failures.push_back({backend, fmt::format("it gives up: {}", error.what()), false});
        }
    }
    return failures;
}

/// Saves the flight, prints the failures and throws.
[[noreturn]] void end_with(const std::vector<CaseFailure>& failures, const GeneratedFlight& flight,
                           std::uint64_t seed, int number, const CheckSettings& settings) {
    const std::filesystem::path folder =
        settings.output.value_or(fmt::format("zonegrid-case-{}-{}", seed, number));
    std::string story;
    std::string names;
    bool differs = false;
    for (const CaseFailure& failure : failures) {
        story += fmt::format(
            "{}: case {} of seed {}: {}\n  to see it again:\n  {}\n", failure.backend, number, seed,
            failure.text,
            replay_command(folder, flight.options(), failure.backend, settings.against));
        names += (names.empty() ? "" : ", ") + failure.backend;
        differs = differs || failure.differs;
    }
    write_standard_output(story); // first: saving may fail
    save_case(folder, flight, story);
    write_standard_output(
        fmt::format("saved in {}; {} flights before it were equal\n", folder.string(), number));
    if (differs) {
        throw CheckFailed(
            fmt::format("{}: not {}; do not fly with it", names, expected_map(settings)));
    }
    throw Error(
        fmt::format("{}: no map of case {}; zonegrid doctor examines the device", names, number));
}

} // namespace

void check_generated(const CheckSettings& settings, const std::vector<std::string>& backends) {
    const std::uint64_t seed = std::stoull(*settings.seed);
    const InterruptionGuard interruption;
    std::uint64_t images = 0;
    std::uint64_t changed = 0;
    {
        Progress progress(static_cast<std::uint64_t>(settings.cases), true, "flights");
        for (int number = 0; number < settings.cases; ++number) {
            const GeneratedFlight flight(seed, static_cast<std::uint64_t>(number));
            const FlightCheck check(flight, settings.against,
                                    [&](const ReplaySummary&) { interruption.check(); });
            const auto failures = find_failures(flight, check, backends);
            if (!failures.empty()) {
                end_with(failures, flight, seed, number, settings);
            }
            images += check.images();
            changed += check.cells_changed();
            progress.show(static_cast<std::uint64_t>(number) + 1);
        }
    }
    for (const std::string& backend : backends) {
        write_standard_output(fmt::format("{}: {}, {} flights, {} images, {} cells changed\n",
                                          backend, expected_map(settings), settings.cases, images,
                                          changed));
    }
}

} // namespace zonegrid
