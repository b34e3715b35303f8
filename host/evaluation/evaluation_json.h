#pragma once

#include "evaluation/evaluation.h"

#include <nlohmann/json.hpp>

namespace zonegrid {

/// evaluation.json (docs/evaluation.md).
[[nodiscard]] nlohmann::ordered_json json_of(const Evaluation& evaluation);

} // namespace zonegrid
