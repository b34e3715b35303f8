#pragma once

#include "io/recording_inspection.h"

#include <nlohmann/json.hpp>

#include <string>

namespace zonegrid {

/// What `zonegrid inspect --json` prints.
[[nodiscard]] nlohmann::ordered_json inspection_report(const Recording& recording,
                                                       const RecordingInspection& inspection);

/// The same for a person.
[[nodiscard]] std::string inspection_text(const Recording& recording,
                                          const RecordingInspection& inspection);

} // namespace zonegrid
