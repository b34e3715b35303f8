#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace zonegrid {

/// How many of a test's random cases to run: all, unless ZONEGRID_TEST_CASES in the environment
/// names a lower number, for programs that check every step and take a thousand times as long.
inline std::uint64_t case_count(std::uint64_t all) {
    const char* const most = std::getenv("ZONEGRID_TEST_CASES");
    return most == nullptr ? all : std::min<std::uint64_t>(all, std::strtoull(most, nullptr, 10));
}

/// Whether a test of so many cases runs them all; only then it can tell whether they were enough.
inline bool runs_all(std::uint64_t all) {
    return case_count(all) == all;
}

} // namespace zonegrid
