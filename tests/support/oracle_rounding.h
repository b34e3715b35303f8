#pragma once

#include <cmath>
#include <cstdint>

namespace zonegrid::oracle {

inline std::int64_t floor_to_whole(double value) {
    return static_cast<std::int64_t>(std::floor(value));
}

/// Division by a positive number, rounded towards minus infinity.
inline std::int64_t floor_divide(std::int64_t value, std::int64_t by) {
    const std::int64_t rest = ((value % by) + by) % by;
    return (value - rest) / by;
}

} // namespace zonegrid::oracle
