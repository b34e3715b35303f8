#pragma once

#include "evaluation/evaluation.h"

#include <filesystem>

namespace zonegrid {

/// Map and truth (of the truth: what was visible) side by side, in the same colours: height profile
/// from above, or in perspective. Throws OutputError.
void draw_profiles(const Evaluation& evaluation, const std::filesystem::path& file);
void draw_profiles_3d(const Evaluation& evaluation, const std::filesystem::path& file);

/// Precision and recall over the distance at which cells are compared, and for each obstacle the
/// distances of first sight and detection. Throws OutputError.
void draw_measures(const Evaluation& evaluation, const std::filesystem::path& file);

} // namespace zonegrid
