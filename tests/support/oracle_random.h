#pragma once

#include <cstdint>
#include <random>

namespace zonegrid::oracle {

/// Seeded numbers that are the same with every standard library (its distributions are not).
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Whole number in low .. high, both inclusive.
    std::int64_t whole(std::int64_t low, std::int64_t high) {
        const auto choices = static_cast<std::uint64_t>(high - low) + 1;
        return low + static_cast<std::int64_t>(engine_() % choices);
    }

    int pick(int low, int high) { return static_cast<int>(whole(low, high)); }

    /// In [low, high).
    double real(double low, double high) {
        const double share = static_cast<double>(engine_() >> 11U) * 0x1.0p-53;
        return low + (high - low) * share;
    }

    float real(float low, float high) {
        return static_cast<float>(real(static_cast<double>(low), static_cast<double>(high)));
    }

    bool chance(double probability) { return real(0.0, 1.0) < probability; }

private:
    std::mt19937_64 engine_;
};

} // namespace zonegrid::oracle
