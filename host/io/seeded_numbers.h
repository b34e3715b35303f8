#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

namespace zonegrid {

/// Numbers from a seed that are the same everywhere; the standard's engines are, its distributions
/// are not.
class SeededNumbers {
public:
    /// `stream` tells apart what one seed is used for.
    SeededNumbers(std::uint64_t seed, std::uint64_t stream) {
        // Neighbouring seeds and streams must have nothing in common: mix all their bits.
        std::seed_seq mixed{low(seed), high(seed), low(stream), high(stream)};
        engine_.seed(mixed);
    }

    /// A whole number in low ... high, both included.
    int whole(int low, int high) {
        const auto choices = static_cast<std::uint64_t>(high - low) + 1;
        return low + static_cast<int>(engine_() % choices);
    }

    /// A number in [low, high).
    double real(double low, double high) {
        const double share = static_cast<double>(engine_() >> 11U) * 0x1.0p-53;
        return low + (high - low) * share;
    }

    bool chance(double share) { return real(0.0, 1.0) < share; }

    template <class Value, std::size_t size>
    const Value& one_of(const std::array<Value, size>& values) {
        return values[static_cast<std::size_t>(whole(0, static_cast<int>(size) - 1))];
    }

private:
    static std::uint32_t low(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }
    static std::uint32_t high(std::uint64_t bits) {
        return static_cast<std::uint32_t>(bits >> 32U);
    }

    std::mt19937_64 engine_;
};

} // namespace zonegrid
