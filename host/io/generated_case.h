#pragma once

#include "io/generated_flight.h"

#include <filesystem>
#include <string>

namespace zonegrid {

/// The options of `zonegrid map` and `zonegrid check` that give exactly these, but for the backend.
[[nodiscard]] std::string mapping_arguments(const MapperOptions& options);

/// `text` as one word of a shell.
[[nodiscard]] std::string shell_word(const std::string& text);

/// The command that checks a flight saved in `folder` image by image, on `backend` against
/// `against`, as it was checked when it was generated.
[[nodiscard]] std::string replay_command(const std::filesystem::path& folder,
                                         const MapperOptions& options, const std::string& backend,
                                         const std::string& against);

/// Saves a flight as a recording of the plain layout, with `story` in its file replay.txt: what
/// happened, and the commands that make it happen again. A case that was saved there before is
/// replaced. Throws OutputError; then nothing is left behind.
void save_case(const std::filesystem::path& folder, const GeneratedFlight& flight,
               const std::string& story);

} // namespace zonegrid
