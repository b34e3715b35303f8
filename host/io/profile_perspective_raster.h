#pragma once

#include "io/profile_perspective_view.h"
#include "io/profile_picture_canvas.h"

#include <array>
#include <vector>

namespace zonegrid {

/// A corner of a face, in samples of the raster.
struct RasterCorner {
    double x = 0.0;
    double y = 0.0;
    double inverse_depth = 0.0;
    double height_m = 0.0; ///< gives the colour
};

/// A depth buffer over the whole picture with `samples` x `samples` samples a pixel. Faces enter in
/// any order; colours are made at the end, from height, brightness and the steps in depth around.
class BlockRaster {
public:
    BlockRaster(int width_px, int height_px, int samples);

    [[nodiscard]] int samples() const { return samples_; }

    /// Enters a plane face with its corners in order around it; the nearest face wins.
    void fill_quad(const std::array<RasterCorner, 4>& corners, double brightness);

    /// Whether something entered lies clearly nearer than the point.
    [[nodiscard]] bool hides(const SeenPoint& point) const;

    /// Paints the pixels that have samples over the canvas. `slope_per_sample` is the relative step
    /// in depth from sample to sample on level ground; larger steps are drawn as dark rims, which
    /// lifts blocks off what lies behind.
    void paint(Canvas& canvas, const ColourTable& colours, double slope_per_sample) const;

private:
    void fill_triangle(const RasterCorner& a, const RasterCorner& b, const RasterCorner& c,
                       float brightness);
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] double rim_brightness(int x, int y, double slope_per_sample) const;

    int samples_;
    int width_;
    int height_;
    std::vector<float> inverse_depth_; ///< 0 where nothing is
    std::vector<float> height_m_;
    std::vector<float> brightness_;
};

} // namespace zonegrid
