#pragma once

#include <string>
#include <string_view>

namespace zonegrid {

/// The text as it may stand in a line of any file or picture: bytes that are no UTF-8, as names of
/// files may hold, become question marks, and control characters, such as ends of lines, spaces.
/// What JSON, TOML and cairo do with others is an error.
[[nodiscard]] std::string readable_text(std::string_view text);

} // namespace zonegrid
