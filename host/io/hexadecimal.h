#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

/// Two lower-case digits a byte.
[[nodiscard]] std::string to_hexadecimal(std::span<const std::uint8_t> bytes);

/// The bytes; nothing if `text` is not an even number of lower-case hexadecimal digits.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> from_hexadecimal(std::string_view text);

} // namespace zonegrid
