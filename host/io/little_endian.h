#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace zonegrid {

/// Appends a whole number, least significant byte first, on any machine.
template <std::integral Whole>
void append_little_endian(std::vector<std::uint8_t>& bytes, Whole value) {
    const auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t byte = 0; byte < sizeof(Whole); ++byte) {
        bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * byte) & 0xFFU));
    }
}

inline void append_little_endian(std::vector<std::uint8_t>& bytes, double value) {
    append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
}

/// The whole number whose first byte, the least significant, is the first of `bytes`.
template <std::integral Whole>
[[nodiscard]] Whole from_little_endian(std::span<const std::uint8_t> bytes) {
    std::uint64_t bits = 0;
    for (std::size_t byte = 0; byte < sizeof(Whole); ++byte) {
        bits |= std::uint64_t{bytes[byte]} << (8 * byte);
    }
    return static_cast<Whole>(static_cast<std::make_unsigned_t<Whole>>(bits));
}

} // namespace zonegrid
