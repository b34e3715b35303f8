#pragma once

#include "io/depth_png.h"
#include "zonegrid/sensors.h"

#include <filesystem>
#include <vector>

namespace zonegrid {

/// What the values of a depth image mean.
enum class DepthKind {
    axis, ///< distance along the optical axis
    ray   ///< distance along the pixel's ray
};

/// How depth lies in the files of a recording.
struct DepthCoding {
    double units_per_m = 1.0; ///< value at 1 m
    DepthKind kind = DepthKind::axis;
    std::vector<float> missing{0.0F}; ///< values in the file that say nothing
    std::vector<float> infinite{};    ///< values in the file that stand for sky
};

/// True if `units_per_m` can be a depth scale: from 0.001 (kilometres) to 1e6 (micrometres).
[[nodiscard]] bool is_depth_scale(double units_per_m);

/// Turns the files of one recording into metres along the optical axis.
class DepthDecoder {
public:
    /// Throws UsageError if `coding.units_per_m` is no depth scale.
    DepthDecoder(DepthCoding coding, const Camera& camera);

    /// Decodes a 16-bit PNG, float32 NPY (height x width) or PFM, told apart by the name's ending.
    /// Returns height * width metres `[v][u]`; missing pixels are NaN, infinite ones +infinity.
    /// Throws InputError naming the file if it is damaged or its size is not the camera's.
    [[nodiscard]] std::vector<float> decode(const std::filesystem::path& file) const;

private:
    [[nodiscard]] float metres_of(float value) const;
    void require_size(ImageSize size, const std::filesystem::path& file) const;
    [[nodiscard]] std::vector<float> decode_png(const std::filesystem::path& file) const;

    DepthCoding coding_;
    ImageSize size_;
    std::vector<float> metres_of_png_; ///< by 16-bit value
    std::vector<float> axis_from_ray_; ///< by pixel; empty: the files hold axis distances
};

} // namespace zonegrid
