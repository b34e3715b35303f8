#pragma once

#include "io/replay.h"
#include "recording_settings.h"
#include "zonegrid/options.h"

#include <optional>
#include <string>

namespace zonegrid {

/// Everything that `zonegrid map` can be told.
struct MapSettings {
    RecordingSettings source;
    MapperOptions mapper;
    std::string model = "line";
    std::optional<std::string> device;
    std::optional<double> device_memory; ///< 2^20 bytes
    bool copy_memory = false;
    std::optional<std::string> output;
    std::optional<std::string> frames;
    std::optional<double> cut_height;
    bool history = false;
    bool overwrite = false;
    bool json = false;
    bool quiet = false;

    MapSettings();
};

/// Adds the settings that decide which map is made of which recording to `table`, which must not
/// outlive `settings`.
void add_mapping_settings(SettingTable& table, MapSettings& settings);

/// Adds these and where the map goes.
void add_map_settings(SettingTable& table, MapSettings& settings);

/// --max-gap, which `zonegrid inspect` has too.
[[nodiscard]] Setting max_gap_setting(double& max_gap_s);

/// The mapper's options, complete and checked, but for the backend, which `choose_backend` finds.
/// Throws UsageError.
[[nodiscard]] MapperOptions mapper_options(const MapSettings& settings);

/// Which frames of `count` to map. Throws UsageError if --frames asks for more than there are.
[[nodiscard]] FrameSpan frame_span(const MapSettings& settings, std::size_t count);

} // namespace zonegrid
