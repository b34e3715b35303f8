#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace zonegrid {

/// A line of a summary: the label in its column, then the text.
[[nodiscard]] inline std::string labelled(std::string_view label, std::string_view text) {
    return fmt::format("{:<14}{}\n", label, text);
}

} // namespace zonegrid
