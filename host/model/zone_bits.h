#pragma once

#include "model/lattice.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid {

/// One bit a cell of a zone, bit i of word i / 32 for the cell at place i, order [z][y][x].
class ZoneBits {
public:
    explicit ZoneBits(std::int32_t zone_edge)
        : words_(static_cast<std::size_t>(zone_edge) * static_cast<std::size_t>(zone_edge) *
                 static_cast<std::size_t>(zone_edge) / 32) {}

    [[nodiscard]] bool test(std::uint32_t index) const {
        return (words_[index / 32] >> (index % 32) & 1U) != 0;
    }
    void set(std::uint32_t index) { words_[index / 32] |= 1U << (index % 32); }
    void reset(std::uint32_t index) { words_[index / 32] &= ~(1U << (index % 32)); }

    [[nodiscard]] bool any() const {
        for (const auto word : words_) {
            if (word != 0) {
                return true;
            }
        }
        return false;
    }

    /// Calls `visit(index)` for every set bit, ascending.
    template <class Visit>
    void for_each(Visit&& visit) const {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            for (auto word = words_[i]; word != 0; word &= word - 1) {
                visit(static_cast<std::uint32_t>(i) * 32 +
                      static_cast<std::uint32_t>(std::countr_zero(word)));
            }
        }
    }

    [[nodiscard]] std::span<const std::uint32_t> words() const { return words_; }
    [[nodiscard]] std::span<std::uint32_t> words() { return words_; }

    friend bool operator==(const ZoneBits&, const ZoneBits&) = default;

private:
    std::vector<std::uint32_t> words_;
};

/// Cells with a value of at least `threshold`.
[[nodiscard]] inline ZoneBits occupied_bits(std::span<const std::int8_t> values, int threshold,
                                            std::int32_t zone_edge) {
    ZoneBits bits(zone_edge);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] >= threshold) {
            bits.set(static_cast<std::uint32_t>(i));
        }
    }
    return bits;
}

} // namespace zonegrid
