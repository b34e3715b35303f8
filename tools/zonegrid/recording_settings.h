#pragma once

#include "io/recording.h"
#include "setting_table.h"

#include <array>
#include <optional>
#include <string>

namespace zonegrid {

/// How to read a recording; shared by the commands that do.
struct RecordingSettings {
    std::optional<std::string> recording;
    std::string layout = "auto";
    std::string world_axes = "layout_default";
    std::optional<std::array<double, 4>> intrinsics;
    std::optional<double> depth_scale;
    std::optional<double> baseline;
    std::optional<double> disparity_sigma;
};

/// Adds RECORDING and the options to `table`, which must not outlive `settings`.
void add_recording_settings(SettingTable& table, RecordingSettings& settings);

/// Opens the recording. Throws UsageError if there is none or options contradict each other, and
/// what `open_recording` throws.
[[nodiscard]] std::unique_ptr<Recording> open_recording(const RecordingSettings& settings);

} // namespace zonegrid
