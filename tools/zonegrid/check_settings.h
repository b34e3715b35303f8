#pragma once

#include "map_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

/// Everything that `zonegrid check` can be told.
struct CheckSettings {
    MapSettings map;
    std::string against = "reference";
    int every = 10;
    std::optional<std::string> seed; ///< whole number; absent: a recording is checked
    int cases = 200;
    std::optional<std::string> output;
};

/// Adds the settings to `table`, which must not outlive `settings`.
void add_check_settings(SettingTable& table, CheckSettings& settings);

/// Throws UsageError if one of the settings `given` does not go with --generated, or without.
void require_consistent(const CheckSettings& settings, const std::vector<std::string>& given);

/// How messages call the map that is expected: "the reference's map".
[[nodiscard]] std::string expected_map(const CheckSettings& settings);

/// Checks `backends` on generated flights, prints what was found, and saves the first flight that
/// differs. Throws CheckFailed if one does, Error if a device gives up.
void check_generated(const CheckSettings& settings, const std::vector<std::string>& backends);

} // namespace zonegrid
