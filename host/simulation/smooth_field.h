#pragma once

#include "simulation/counted_numbers.h"

#include <cstddef>
#include <vector>

namespace zonegrid {

/// Normal noise over an image, deviation 1 in each pixel, alike within about `window_px`: what a
/// matcher that compares windows makes, whose neighbouring results share most of their pixels.
class SmoothField {
public:
    SmoothField(int width_px, int height_px, int window_px, const CountedNumbers& numbers);

    [[nodiscard]] float at(int u, int v) const;

private:
    int window_px_;
    int first_u_; ///< where the image begins in the lattice, in pixels: another in each image
    int first_v_;
    std::size_t columns_;
    std::vector<float> lattice_;
};

} // namespace zonegrid
