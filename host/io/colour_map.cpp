#include "io/colour_map.h"

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

// Coefficients of x^0 .. x^5, see the header for the source.
constexpr std::array<double, 6> turbo_red = {0.13572138,   4.61539260,    -42.66032258,
                                             132.13108234, -152.94239396, 59.28637943};
constexpr std::array<double, 6> turbo_green = {0.09140261,   2.19418839, 4.84296658,
                                               -14.18503333, 4.27729857, 2.82956604};
constexpr std::array<double, 6> turbo_blue = {0.10667330,   12.64194608,  -60.58204836,
                                              110.36276771, -89.90310912, 27.34824973};

// The part of the map that is used.
constexpr double turbo_first = 0.10;
constexpr double turbo_last = 0.94;

std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

std::uint8_t polynomial(const std::array<double, 6>& coefficients, double x) {
    double value = 0.0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
        value = value * x + *c;
    }
    return to_byte(value);
}

} // namespace

Rgb height_colour(double fraction) {
    const double inside = fraction > 0.0 ? std::min(fraction, 1.0) : 0.0;
    const double x = turbo_first + inside * (turbo_last - turbo_first);
    return {polynomial(turbo_red, x), polynomial(turbo_green, x), polynomial(turbo_blue, x)};
}

Rgb shade(Rgb colour, double brightness) {
    const double darker = std::clamp(brightness, 0.0, 1.0);
    const double white = std::clamp(brightness - 1.0, 0.0, 1.0);
    const auto channel = [&](std::uint8_t value) {
        const double scaled = value / 255.0 * darker;
        return to_byte(scaled + (1.0 - scaled) * white);
    };
    return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

ColourTable::ColourTable(double low_m, double high_m)
    : low_m_(low_m), steps_per_m_(static_cast<double>(colours_.size() - 1) / (high_m - low_m)) {
    for (std::size_t i = 0; i < colours_.size(); ++i) {
        colours_[i] =
            height_colour(static_cast<double>(i) / static_cast<double>(colours_.size() - 1));
    }
}

Rgb ColourTable::operator()(double height_m) const {
    const double step = std::clamp((height_m - low_m_) * steps_per_m_, 0.0,
                                   static_cast<double>(colours_.size() - 1));
    return colours_[static_cast<std::size_t>(step + 0.5)];
}

} // namespace zonegrid
