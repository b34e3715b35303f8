#pragma once

#include "evaluation/evaluation.h"

#include <string>

namespace zonegrid {

/// The evaluation as tables for a person.
[[nodiscard]] std::string text_of(const Evaluation& evaluation);

} // namespace zonegrid
