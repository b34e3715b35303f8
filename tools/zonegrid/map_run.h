#pragma once

#include "backend_choice.h"
#include "io/map_folder.h"
#include "io/recording.h"
#include "io/replay.h"
#include "map_settings.h"
#include "zonegrid/mapper.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace zonegrid {

/// What one `zonegrid map` did, for its report and its summary.
struct MapRun {
    const Recording& recording;
    const MapSettings& settings;
    const BackendChoice& backend;
    MapperOptions options;
    FrameSpan span;
    ReplaySummary replay{};
    MapStatistics statistics{};
    MapFolderContents contents{};
    std::vector<std::string> warnings{}; ///< about the map, for a person
    double total_s = 0.0;
    std::uint64_t memory_most_bytes = 0;
};

/// report.json (docs/formats.md).
[[nodiscard]] nlohmann::ordered_json report_of(const MapRun& run);

/// The text that a person reads at the end; `folder` is where the map lies.
[[nodiscard]] std::string summary_of(const MapRun& run, const std::filesystem::path& folder);

/// Why a replay gave no map at all; one sentence.
[[nodiscard]] std::string explain_no_image(const ReplaySummary& replay);

/// What looks wrong with the map and why that usually happens; often nothing.
[[nodiscard]] std::vector<std::string> find_map_warnings(const ReplaySummary& replay,
                                                         const MapStatistics& statistics,
                                                         const MapperOptions& options);

} // namespace zonegrid
