#pragma once

#include "io/recording.h"

#include <nlohmann/json.hpp>

namespace zonegrid {

/// What a recording says of itself, for reports.
[[nodiscard]] nlohmann::ordered_json recording_json(const Recording& recording);

} // namespace zonegrid
