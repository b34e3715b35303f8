#include "simulation/smooth_field.h"

#include <cmath>

namespace zonegrid {

SmoothField::SmoothField(int width_px, int height_px, int window_px, const CountedNumbers& numbers)
    : window_px_(window_px),
      first_u_(static_cast<int>(numbers.bits(0) % static_cast<std::uint64_t>(window_px))),
      first_v_(static_cast<int>(numbers.bits(1) % static_cast<std::uint64_t>(window_px))),
      columns_(static_cast<std::size_t>((width_px + first_u_) / window_px) + 2) {
    const std::size_t rows = static_cast<std::size_t>((height_px + first_v_) / window_px) + 2;
    lattice_.resize(columns_ * rows);
    for (std::size_t i = 0; i < lattice_.size(); ++i) {
        lattice_[i] = static_cast<float>(numbers.normal(i + 2));
    }
}

float SmoothField::at(int u, int v) const {
    const int lattice_u = u + first_u_;
    const int lattice_v = v + first_v_;
    const auto window = static_cast<float>(window_px_);
    const float right = static_cast<float>(lattice_u % window_px_) / window;
    const float below = static_cast<float>(lattice_v % window_px_) / window;
    const float* const corner = lattice_.data() +
                                static_cast<std::size_t>(lattice_v / window_px_) * columns_ +
                                static_cast<std::size_t>(lattice_u / window_px_);
    const float left = 1.0F - right;
    const float above = 1.0F - below;
    const float sum = above * (left * corner[0] + right * corner[1]) +
                      below * (left * corner[columns_] + right * corner[columns_ + 1]);
    // A mean of four varies less than each of them.
    return sum / std::sqrt((left * left + right * right) * (above * above + below * below));
}

} // namespace zonegrid
