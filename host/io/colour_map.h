#pragma once

#include <array>
#include <cstdint>

namespace zonegrid {

/// An 8-bit sRGB colour.
struct Rgb {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Colour of a fraction from 0 (lowest) to 1 (highest): the Turbo map, whose hues keep their order
/// under shading, without its ends, which are so dark that shading and a black line drown in them.
/// Fractions outside are clamped; NaN counts as 0.
///
/// Source: A. Mikhailov, "Turbo, an improved rainbow colormap for visualization" (2019), in the
/// polynomial approximation published by R. Du.
[[nodiscard]] Rgb height_colour(double fraction);

/// `colour` times `brightness`; above 1 it goes towards white. Brightness 0..2.
[[nodiscard]] Rgb shade(Rgb colour, double brightness);

/// `height_colour` in 1024 steps, for pictures with millions of samples.
class ColourTable {
public:
    ColourTable(double low_m, double high_m);
    [[nodiscard]] Rgb operator()(double height_m) const;

private:
    std::array<Rgb, 1024> colours_{};
    double low_m_;
    double steps_per_m_;
};

} // namespace zonegrid
