#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace zonegrid {

/// The whole file. Throws InputError if it cannot be opened, cannot be read or is empty.
[[nodiscard]] std::vector<std::uint8_t> read_file_bytes(const std::filesystem::path& file);

/// The regular files and folders directly in `folder`, in order of their names.
/// Throws InputError if it cannot be listed.
[[nodiscard]] std::vector<std::filesystem::path> list_folder(const std::filesystem::path& folder);

} // namespace zonegrid
