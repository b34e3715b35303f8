#include "io/profile_picture_layout.h"

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

/// The nearest smaller scale at which cells of a pixel or more come out alike.
double even_scale(double px_per_m, double cell_m) {
    const double cell_px = px_per_m * cell_m;
    if (cell_px >= 4.0) {
        return std::floor(cell_px) / cell_m;
    }
    if (cell_px >= 1.0) {
        return 0.5 * std::floor(2.0 * cell_px) / cell_m;
    }
    return px_per_m;
}

} // namespace

double picture_unit(int width_px, int height_px) {
    return std::max(0.6, std::min(width_px / 1200.0, height_px / 900.0));
}

PictureFrame picture_frame(int width_px, int height_px) {
    const double unit = picture_unit(width_px, height_px);
    const auto margin = [unit](double at_unit) {
        return static_cast<int>(std::lround(at_unit * unit));
    };
    PictureFrame frame;
    frame.left_px = margin(82);
    frame.top_px = margin(78);
    frame.width_px = width_px - frame.left_px - margin(118);
    frame.height_px = height_px - frame.top_px - margin(86);
    return frame;
}

ProfileLayout layout_profile(const PictureFrame& frame, const GroundPlan& plan, double cell_m) {
    ProfileLayout layout;
    layout.frame = frame;
    layout.px_per_m = even_scale(
        std::min(frame.width_px / plan.east_extent_m(), frame.height_px / plan.north_extent_m()),
        cell_m);
    const double east_middle_m = 0.5 * (plan.east_min_m + plan.east_max_m);
    const double north_middle_m = 0.5 * (plan.north_min_m + plan.north_max_m);
    // The origin falls on a whole pixel, and with it every cell of whole pixels.
    const auto on_pixel = [&layout](double place_m) {
        return std::round(place_m * layout.px_per_m) / layout.px_per_m;
    };
    layout.west_m = on_pixel(east_middle_m - 0.5 * frame.width_px / layout.px_per_m);
    layout.north_m = on_pixel(north_middle_m + 0.5 * frame.height_px / layout.px_per_m);
    return layout;
}

} // namespace zonegrid
