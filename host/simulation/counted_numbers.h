#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace zonegrid {

/// What random numbers are used for; each has numbers of its own, so that switching one fault
/// changes no other. The values are part of what a seed means.
enum class Stream : std::uint64_t {
    image_clock = 1,
    navigation_clock,
    vibration,
    disparity,
    weak_texture,
    outliers,
    exposure,
    stripes,
    slow_errors,
    quick_errors,
    late_images,
    lost_images,
    lost_navigation
};

/// Random numbers that are looked up by their number, in any order and from any thread.
///
/// Numbers are mixed by the finalizer of SplitMix64 (Steele, Lea, Flood: Fast splittable
/// pseudorandom number generators, 2014).
class CountedNumbers {
public:
    /// Bits that have nothing to do with those of `bits` + 1.
    [[nodiscard]] static std::uint64_t mix(std::uint64_t bits) {
        bits += 0x9e3779b97f4a7c15U;
        bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
        bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
        return bits ^ (bits >> 31U);
    }

    /// `part` tells apart what one stream is used for, such as images.
    CountedNumbers(std::uint64_t seed, Stream stream, std::uint64_t part = 0)
        : key_(mix(mix(mix(seed) + static_cast<std::uint64_t>(stream)) + part)) {}

    [[nodiscard]] std::uint64_t bits(std::uint64_t number) const {
        return mix(key_ + number * 0x9e3779b97f4a7c15U);
    }

    /// Evenly in [0, 1).
    [[nodiscard]] double share(std::uint64_t number) const {
        return static_cast<double>(bits(number) >> 11U) * 0x1.0p-53;
    }

    /// Normally distributed with mean 0 and deviation 1 (Box and Muller 1958).
    [[nodiscard]] double normal(std::uint64_t number) const {
        const std::uint64_t random = bits(number);
        const double radius = (static_cast<double>(random >> 32U) + 0.5) * 0x1.0p-32;
        const double angle = static_cast<double>(random & 0xffffffffU) * 0x1.0p-32;
        return std::sqrt(-2.0 * std::log(radius)) * std::cos(2.0 * std::numbers::pi * angle);
    }

private:
    std::uint64_t key_;
};

} // namespace zonegrid
