#pragma once

#include <bit>
#include <cstdint>

namespace zonegrid {

/// The float32 whose four bytes at `bytes` come least significant first, on any machine.
[[nodiscard]] inline float little_endian_float(const std::uint8_t* bytes) {
    return std::bit_cast<float>(std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 |
                                std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24);
}

/// The float32 whose four bytes at `bytes` come most significant first, on any machine.
[[nodiscard]] inline float big_endian_float(const std::uint8_t* bytes) {
    return std::bit_cast<float>(std::uint32_t{bytes[3]} | std::uint32_t{bytes[2]} << 8 |
                                std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[0]} << 24);
}

} // namespace zonegrid
