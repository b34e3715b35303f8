#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>

namespace zonegrid {

/// How many of a test's random cases to run, printed. All, unless the environment says otherwise:
/// ZONEGRID_LONG_TESTS fifty times as many; ZONEGRID_TEST_CASES at most so many, for programs that
/// check every step and take a thousand times as long.
inline std::uint64_t case_count(std::uint64_t all) {
    std::uint64_t count = std::getenv("ZONEGRID_LONG_TESTS") == nullptr ? all : 50 * all;
    if (const char* const most = std::getenv("ZONEGRID_TEST_CASES"); most != nullptr) {
        count = std::min<std::uint64_t>(count, std::strtoull(most, nullptr, 10));
    }
    std::cout << count << " cases\n";
    return count;
}

} // namespace zonegrid
