#pragma once

#include "pipeline/map_history.h"

#include <cstdint>
#include <filesystem>

namespace zonegrid {

/// What history.zgrid holds (docs/formats.md): its options are cell_m, zone, limit and threshold.
struct StoredHistory {
    MapperOptions options;
    std::uint32_t frames = 0; ///< in the recording; images are counted among them
    std::map<ZoneIndex, ZoneHistory> zones;
};

/// Writes history.zgrid. Zones that hold nothing are left out. Throws OutputError.
void write_history_file(const std::filesystem::path& file, const MapHistory& history,
                        std::uint32_t frames);

/// Throws InputError if the file is missing, cut off, damaged or of an unknown version.
[[nodiscard]] StoredHistory read_history_file(const std::filesystem::path& file);

} // namespace zonegrid
