#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace zonegrid {

/// JSON as reports are written: indented, with an end of line. Bytes that are no UTF-8, as paths
/// may hold, become U+FFFD.
[[nodiscard]] inline std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace zonegrid
