#pragma once

#include "io/description_table.h"
#include "io/seeded_numbers.h"

#include <fmt/format.h>
#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace zonegrid {

// What the tables of a scene have in common. All errors are InputErrors naming file, line and key.

/// Between which ends a seed draws a number.
struct Span {
    double low = 0.0;
    double high = 0.0;

    [[nodiscard]] double draw(SeededNumbers& numbers) const { return numbers.real(low, high); }
};

/// The number of `key` or the fallback; needed if there is none. It must lie within the limits.
[[nodiscard]] double read_number(DescriptionTable& table, std::string_view key, const Span& limits,
                                 std::optional<double> fallback = std::nullopt);

/// One number or [least, most] of `key`, if it is there. Both must lie within the limits.
[[nodiscard]] std::optional<Span> read_span(DescriptionTable& table, std::string_view key,
                                            const Span& limits);

/// Places lie within these, in metres: farther out, the rays' single precision shows.
inline constexpr Span place_limits{-1e5, 1e5};

/// A needed whole number within the limits.
[[nodiscard]] int read_count(DescriptionTable& table, std::string_view key, int low, int high);

/// A needed list of exactly `size` numbers within the limits of places.
template <int size>
[[nodiscard]] Eigen::Matrix<double, size, 1> read_point(DescriptionTable& table,
                                                        std::string_view key,
                                                        const std::string& what) {
    const std::optional<std::vector<double>> values = table.numbers(key);
    if (!values) {
        table.refuse_absent(key);
    }
    Eigen::Matrix<double, size, 1> point;
    if (values->size() == size) {
        point = Eigen::Map<const Eigen::Matrix<double, size, 1>>(values->data());
    }
    if (values->size() != size || !point.allFinite()) {
        table.refuse(key, "is no point", "give " + what);
    }
    if (point.minCoeff() < place_limits.low || point.maxCoeff() > place_limits.high) {
        table.refuse(
            key, "is too far away",
            fmt::format("give numbers from {} to {}", place_limits.low, place_limits.high));
    }
    return point;
}

/// The values of `north_m` and `east_m`, both needed.
[[nodiscard]] Eigen::Vector2d read_place(DescriptionTable& table);

/// An angle in degrees of `key`, in radians; 0 if it is absent.
[[nodiscard]] double read_angle_rad(DescriptionTable& table, std::string_view key);

/// 0 ... 1 of the key `texture`, 1 if it is absent.
[[nodiscard]] double read_texture(DescriptionTable& table);

/// The choice that `key` names; the first if it is absent.
template <class Choice, std::size_t count>
[[nodiscard]] Choice read_choice(
    DescriptionTable& table, std::string_view key,
    const std::array<std::pair<std::string_view, Choice>, count>& choices) {
    const std::string name = table.text(key).value_or(std::string(choices[0].first));
    std::string known;
    for (const auto& [text, choice] : choices) {
        if (text == name) {
            return choice;
        }
        known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", text);
    }
    table.refuse(key, fmt::format("is '{}'", name), "give one of " + known);
}

/// What a seed is used for; every table draws from numbers of its own, so that adding one does not
/// change the others.
enum class Draw : std::uint64_t { terrain, tree, bush, row, forest };

[[nodiscard]] inline SeededNumbers numbers_of(std::uint64_t seed, Draw what, std::size_t index) {
    return {seed, static_cast<std::uint64_t>(what) << 32U | index};
}

} // namespace zonegrid
