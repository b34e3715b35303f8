#pragma once

#include "io/generated_flight.h"

#include <array>
#include <filesystem>
#include <string_view>

namespace zonegrid {

/// Names in the folder of a flight that was written.
inline constexpr std::array<std::string_view, 3> flight_file_names{"description.toml",
                                                                   "navigation.csv", "frames.csv"};
inline constexpr std::string_view flight_frames_name = "frames";

/// Writes a flight to the existing `folder` as a recording of the plain layout (docs/formats.md),
/// exactly: what is read back gives the same map, bit for bit. Throws OutputError.
void write_flight(const std::filesystem::path& folder, const GeneratedFlight& flight);

} // namespace zonegrid
