#include "io/plain_camera.h"

#include "io/lens_distortion.h"
#include "io/npy.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace zonegrid {
namespace {

void read_intrinsics(DescriptionTable& table, Camera& camera) {
    camera.fx_px = table.positive_number("fx_px");
    camera.fy_px = table.positive_number("fy_px");
    camera.cx_px = table.needed_number("cx_px");
    camera.cy_px = table.needed_number("cy_px");
}

void undistort_directions(DescriptionTable& table, Camera& camera) {
    const BrownConrady lens{.k1 = table.number("k1").value_or(0.0),
                            .k2 = table.number("k2").value_or(0.0),
                            .p1 = table.number("p1").value_or(0.0),
                            .p2 = table.number("p2").value_or(0.0),
                            .k3 = table.number("k3").value_or(0.0)};
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            const Eigen::Vector2d shown((u - camera.cx_px) / camera.fx_px,
                                        (v - camera.cy_px) / camera.fy_px);
            Eigen::Vector2d ideal;
            if (!undistort(shown, lens, ideal)) {
                table.refuse("model", fmt::format("cannot be inverted at pixel ({}, {})", u, v),
                             "check k1 k2 p1 p2 k3, or give a table of directions");
            }
            camera.directions.push_back(ideal.cast<float>());
        }
    }
}

/// Focal length and centre of the straight line closest to the slopes of one axis over its pixels.
struct MeanSpacing {
    double focal_px;
    double centre_px;
};

MeanSpacing fit_spacing(const Camera& camera, int axis) {
    const auto width = static_cast<std::size_t>(camera.width_px);
    const double pixels = static_cast<double>(camera.directions.size());
    double mean_pixel = 0.0;
    double mean_slope = 0.0;
    const auto pixel_of = [&](std::size_t index) {
        return static_cast<double>(axis == 0 ? index % width : index / width);
    };
    for (std::size_t index = 0; index < camera.directions.size(); ++index) {
        mean_pixel += pixel_of(index) / pixels;
        mean_slope += static_cast<double>(camera.directions[index][axis]) / pixels;
    }
    double pixel_squares = 0.0;
    double products = 0.0;
    for (std::size_t index = 0; index < camera.directions.size(); ++index) {
        const double pixel = pixel_of(index) - mean_pixel;
        pixel_squares += pixel * pixel;
        products += pixel * (static_cast<double>(camera.directions[index][axis]) - mean_slope);
    }
    const double focal_px = pixel_squares / products;
    return {focal_px, mean_pixel - mean_slope * focal_px};
}

void read_directions(DescriptionTable& table, const std::filesystem::path& folder, Camera& camera) {
    const std::filesystem::path file = folder / table.needed_text("table");
    const NpyArray array = read_npy(file);
    const std::vector<std::size_t> shape{static_cast<std::size_t>(camera.height_px),
                                         static_cast<std::size_t>(camera.width_px), 2};
    if (array.shape != shape) {
        throw InputError(file.string(),
                         fmt::format("the NPY shape is ({}), not ({})",
                                     fmt::join(array.shape, ", "), fmt::join(shape, ", ")),
                         "give (x/z, y/z) for each pixel of the camera: height x width x 2");
    }
    for (std::size_t at = 0; at < array.values.size(); at += 2) {
        camera.directions.emplace_back(array.values[at], array.values[at + 1]);
        if (!camera.directions.back().allFinite()) {
            throw InputError(file.string(),
                             fmt::format("the direction of pixel ({}, {}) is not finite",
                                         (at / 2) % shape[1], (at / 2) / shape[1]),
                             "give each pixel a direction, and missing depth where it sees none");
        }
    }
    if (!fit_mean_spacing(camera)) {
        throw InputError(file.string(), "the directions do not grow with the pixel",
                         "x/z grows to the right, y/z downwards, over at least 2 x 2 pixels");
    }
}

} // namespace

bool fit_mean_spacing(Camera& camera) {
    const MeanSpacing across = fit_spacing(camera, 0);
    const MeanSpacing down = fit_spacing(camera, 1);
    camera.fx_px = across.focal_px;
    camera.cx_px = across.centre_px;
    camera.fy_px = down.focal_px;
    camera.cy_px = down.centre_px;
    return across.focal_px > 0.0 && down.focal_px > 0.0 && std::isfinite(across.focal_px) &&
           std::isfinite(down.focal_px);
}

Camera read_plain_camera(DescriptionTable& table, const std::filesystem::path& folder) {
    Camera camera;
    camera.width_px = table.needed_size("width_px");
    camera.height_px = table.needed_size("height_px");
    const std::string model = table.needed_text("model");
    if (model == "pinhole") {
        read_intrinsics(table, camera);
    } else if (model == "brown_conrady") {
        read_intrinsics(table, camera);
        undistort_directions(table, camera);
    } else if (model == "table") {
        read_directions(table, folder, camera);
    } else {
        table.refuse("model", fmt::format("is '{}'", model),
                     R"(give "pinhole", "brown_conrady" or "table")");
    }
    table.require_all_read();
    return camera;
}

} // namespace zonegrid
