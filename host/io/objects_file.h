#pragma once

#include "zonegrid/objects.h"

#include <filesystem>
#include <span>
#include <vector>

namespace zonegrid {

/// Writes objects.json (docs/formats.md): one object a line, with boxes and centres also in metres.
/// Throws OutputError if the file cannot be written.
void write_objects_file(const std::filesystem::path& file, std::span<const Object> objects,
                        double cell_m);

/// The objects of a file that `write_objects_file` wrote.
/// Throws InputError if the file is missing, cut off or changed in its form.
[[nodiscard]] std::vector<Object> read_objects_file(const std::filesystem::path& file);

} // namespace zonegrid
