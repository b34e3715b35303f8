#include "io/depth_decoder.h"

#include "io/npy.h"
#include "io/pfm.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace zonegrid {
namespace {

/// By pixel, the axis distance of a point at ray distance 1.
std::vector<float> axis_from_ray(const Camera& camera) {
    const auto width = static_cast<std::size_t>(camera.width_px);
    const auto height = static_cast<std::size_t>(camera.height_px);
    std::vector<float> factors(width * height);
    for (std::size_t index = 0; index < factors.size(); ++index) {
        Eigen::Vector2d slope((static_cast<double>(index % width) - camera.cx_px) / camera.fx_px,
                              (static_cast<double>(index / width) - camera.cy_px) / camera.fy_px);
        if (!camera.directions.empty()) {
            slope = camera.directions[index].cast<double>();
        }
        factors[index] = static_cast<float>(1.0 / std::sqrt(1.0 + slope.squaredNorm()));
    }
    return factors;
}

} // namespace

bool is_depth_scale(double units_per_m) {
    return units_per_m >= 1e-3 && units_per_m <= 1e6; // false for NaN
}

DepthDecoder::DepthDecoder(DepthCoding coding, const Camera& camera)
    : coding_(std::move(coding)), size_{camera.width_px, camera.height_px} {
    if (!is_depth_scale(coding_.units_per_m)) {
        throw UsageError(
            fmt::format("depth scale: {} units per metre is outside 0.001 ... 1e6; "
                        "give the pixel value that stands for 1 m, such as 1000",
                        coding_.units_per_m));
    }
    if (coding_.kind == DepthKind::ray) {
        axis_from_ray_ = axis_from_ray(camera);
    }
    metres_of_png_.resize(std::size_t{1} << 16);
    for (std::size_t value = 0; value < metres_of_png_.size(); ++value) {
        metres_of_png_[value] = metres_of(static_cast<float>(value));
    }
}

float DepthDecoder::metres_of(float value) const {
    if (std::ranges::find(coding_.infinite, value) != coding_.infinite.end()) {
        return std::numeric_limits<float>::infinity();
    }
    if (!(value > 0.0F) || std::ranges::find(coding_.missing, value) != coding_.missing.end()) {
        return std::numeric_limits<float>::quiet_NaN();
    }
    return static_cast<float>(static_cast<double>(value) / coding_.units_per_m);
}

void DepthDecoder::require_size(ImageSize size, const std::filesystem::path& file) const {
    if (size != size_) {
        throw InputError(
            file.string(),
            fmt::format("the image is {} x {} pixels, the camera {} x {}", size.width_px,
                        size.height_px, size_.width_px, size_.height_px),
            "keep images of one size in a recording, or correct the camera's size");
    }
}

std::vector<float> DepthDecoder::decode_png(const std::filesystem::path& file) const {
    const DepthPng image = read_depth_png(file);
    require_size(image.size, file);
    std::vector<float> depth_m(image.values.size());
    std::ranges::transform(image.values, depth_m.begin(),
                           [this](std::uint16_t value) { return metres_of_png_[value]; });
    return depth_m;
}

std::vector<float> DepthDecoder::decode(const std::filesystem::path& file) const {
    const auto to_metres = [this](float value) { return metres_of(value); };
    const std::filesystem::path ending = file.extension();
    std::vector<float> depth_m;
    if (ending == ".png") {
        depth_m = decode_png(file);
    } else if (ending == ".npy") {
        NpyArray array = read_npy(file);
        if (array.shape.size() != 2) {
            throw InputError(file.string(),
                             fmt::format("the NPY shape is ({})", fmt::join(array.shape, ", ")),
                             "a depth image has the shape height x width");
        }
        const auto clamped = [](std::size_t length) {
            return static_cast<int>(std::min<std::size_t>(length, largest_image_px + 1));
        };
        require_size({clamped(array.shape[1]), clamped(array.shape[0])}, file);
        std::ranges::transform(array.values, array.values.begin(), to_metres);
        depth_m = std::move(array.values);
    } else if (ending == ".pfm") {
        PfmImage image = read_pfm(file);
        require_size(image.size, file);
        std::ranges::transform(image.values, image.values.begin(), to_metres);
        depth_m = std::move(image.values);
    } else {
        throw InputError(file.string(), "the name's ending is no depth format",
                         "depth images end in .png, .npy or .pfm");
    }
    for (std::size_t index = 0; index < axis_from_ray_.size(); ++index) {
        depth_m[index] *= axis_from_ray_[index];
    }
    return depth_m;
}

} // namespace zonegrid
