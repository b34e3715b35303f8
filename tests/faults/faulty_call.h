#pragma once

#include <cstdlib>
#include <string_view>

namespace zonegrid {

/// Whether ZONEGRID_TEST_FAULT, "CALL=CODE", names this call; then its code.
inline bool is_faulty(std::string_view call, int& code) {
    const char* const fault = std::getenv("ZONEGRID_TEST_FAULT");
    if (fault == nullptr) {
        return false;
    }
    const std::string_view text = fault;
    if (!text.starts_with(call) || text.substr(call.size(), 1) != "=") {
        return false;
    }
    code = std::atoi(fault + call.size() + 1);
    return true;
}

} // namespace zonegrid
