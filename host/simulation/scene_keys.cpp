#include "simulation/scene_keys.h"

#include <cmath>
#include <numbers>

namespace zonegrid {
namespace {

void require_within(const DescriptionTable& table, std::string_view key, double value,
                    const Span& limits) {
    if (!(value >= limits.low && value <= limits.high)) {
        table.refuse(key, fmt::format("is {}", value),
                     fmt::format("give a number from {} to {}", limits.low, limits.high));
    }
}

} // namespace

double read_number(DescriptionTable& table, std::string_view key, const Span& limits,
                   std::optional<double> fallback) {
    const std::optional<double> value = table.number(key);
    if (!value && !fallback) {
        table.refuse_absent(key);
    }
    if (value) {
        require_within(table, key, *value, limits);
    }
    return value ? *value : *fallback;
}

std::optional<Span> read_span(DescriptionTable& table, std::string_view key, const Span& limits) {
    const std::optional<std::array<double, 2>> range = table.range(key);
    if (!range) {
        return std::nullopt;
    }
    require_within(table, key, range->front(), limits);
    require_within(table, key, range->back(), limits);
    return Span{range->front(), range->back()};
}

int read_count(DescriptionTable& table, std::string_view key, int low, int high) {
    const double value = table.needed_number(key);
    if (!(value >= low && value <= high) || value != std::floor(value)) {
        table.refuse(key, fmt::format("is {}", value),
                     fmt::format("give a whole number from {} to {}", low, high));
    }
    return static_cast<int>(value);
}

Eigen::Vector2d read_place(DescriptionTable& table) {
    const double north_m = read_number(table, "north_m", place_limits);
    return {north_m, read_number(table, "east_m", place_limits)};
}

double read_angle_rad(DescriptionTable& table, std::string_view key) {
    return read_number(table, key, {-360.0, 360.0}, 0.0) * std::numbers::pi / 180.0;
}

double read_texture(DescriptionTable& table) {
    return read_number(table, "texture", {0.0, 1.0}, 1.0);
}

} // namespace zonegrid
