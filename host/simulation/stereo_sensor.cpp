#include "simulation/stereo_sensor.h"

#include "simulation/counted_numbers.h"
#include "simulation/smooth_field.h"
#include "truth/ray_caster.h"
#include "zonegrid/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace zonegrid {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
/// No match.
constexpr float missing = -1.0F;

/// Matchers compare windows of about this size, so that errors are alike within them.
constexpr int window_px = 5;
/// Blank patches are larger than a window: smaller ones would have matched.
constexpr int blank_px = 8;
/// What a wrong match covers before a filter of small regions would remove it.
constexpr int outlier_px = 5;
/// Nearest distance that is searched for matches.
constexpr float nearest_m = 2.0F;
/// Neighbours whose disparities differ by less are one surface.
constexpr float edge_px = 1.0F;
/// A screen's exposures are mixed in patches, as windows match in one of them or the other.
constexpr int patch_px = 8;
constexpr int stripe_period_px = 80;
constexpr int stripe_px = 16;
constexpr int stripe_drift_px = 7;

/// The value below which a normal number lies with probability `share`.
double normal_quantile(double share) {
    if (share <= 0.0 || share >= 1.0) {
        return share <= 0.0 ? -std::numeric_limits<double>::infinity()
                            : std::numeric_limits<double>::infinity();
    }
    double low = -10.0;
    double high = 10.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2.0;
        const double below = std::erfc(-middle / std::numbers::sqrt2) / 2.0;
        (below < share ? low : high) = middle;
    }
    return low;
}

bool has_surface(float disparity_px) {
    return disparity_px > 0.0F;
}

/// Number of the patch of `size_px` that holds the pixel.
std::uint64_t patch_of(int u, int v, int size_px) {
    return static_cast<std::uint64_t>(v / size_px) << 32U | static_cast<std::uint64_t>(u / size_px);
}

/// Calls `visit(u, v, pixel)` for each pixel.
template <class Visit>
void for_each_pixel(const Camera& camera, const Visit& visit) {
    std::size_t pixel = 0;
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            visit(u, v, pixel++);
        }
    }
}

/// A camera that films a screen exposes while the picture changes: each patch shows one of the two.
Exposure mix(const Camera& camera, const Exposure& exposure, const Exposure& previous,
             const CountedNumbers& numbers) {
    Exposure mixed = exposure;
    for_each_pixel(camera, [&](int u, int v, std::size_t pixel) {
        if (numbers.share(patch_of(u, v, patch_px)) < 0.5) {
            mixed.depth_m[pixel] = previous.depth_m[pixel];
            mixed.obstacles[pixel] = previous.obstacles[pixel];
        }
    });
    return mixed;
}

} // namespace

StereoSensor::StereoSensor(const Camera& camera, std::span<const double> texture,
                           const SensorFaults& faults, std::uint64_t seed)
    : camera_(camera), faults_(faults), seed_(seed) {
    if (camera.stereo) {
        pixels_metres_ = static_cast<float>(camera.fx_px * camera.stereo->baseline_m);
    }
    SensorFaults mounted; // those that are no matter of disparities
    mounted.missing_sky = faults.missing_sky;
    mounted.vibration_deg = faults.vibration_deg;
    if (pixels_metres_ <= 0.0F && !(faults == mounted)) {
        throw UsageError(
            "the scene's camera is no stereo camera, and a fault needs its baseline: "
            "give camera.baseline_m in the scene or leave the fault out");
    }
    for (const double value : texture) {
        weak_below_.push_back(static_cast<float>(normal_quantile(faults.missing * (1.0 - value))));
    }
}

std::optional<StereoNoise> StereoSensor::noise() const {
    const double step = faults_.disparity_step_px;
    const double sigma_px =
        std::sqrt(faults_.disparity_sigma_px * faults_.disparity_sigma_px + step * step / 12.0);
    if (sigma_px == 0.0) {
        return std::nullopt;
    }
    return StereoNoise{camera_.stereo->baseline_m, sigma_px};
}

std::vector<float> StereoSensor::see(std::uint64_t number, const Exposure& exposure,
                                     const Exposure& previous) const {
    Exposure mixed;
    const Exposure* seen = &exposure;
    if (faults_.screen_px > 0.0) {
        mixed = mix(camera_, exposure, previous, CountedNumbers(seed_, Stream::exposure, number));
        seen = &mixed;
    }
    std::vector<float> depth_m = seen->depth_m;
    if (pixels_metres_ > 0.0F) {
        std::vector<float> exact_px = disparities_of(*seen);
        std::vector<float> disparities_px = exact_px;
        std::vector<std::uint32_t> obstacles = seen->obstacles;
        if (faults_.missing > 0.0) {
            lose_unseen(disparities_px);
        }
        if (faults_.bleeding_px > 0) {
            bleed(disparities_px, obstacles);
        }
        if (faults_.missing > 0.0) {
            lose_weak(number, obstacles, disparities_px);
        }
        if (faults_.screen_px > 0.0) {
            add_stripes(number, disparities_px);
        }
        if (faults_.disparity_sigma_px > 0.0) {
            add_noise(number, disparities_px);
        }
        if (faults_.outlier_share > 0.0) {
            add_outliers(number, disparities_px);
        }
        for (std::size_t i = 0; i < depth_m.size(); ++i) {
            float disparity_px = disparities_px[i];
            if (disparity_px > 0.0F && faults_.disparity_step_px > 0.0) {
                const auto step = static_cast<float>(faults_.disparity_step_px);
                disparity_px = step * std::round(disparity_px / step);
            }
            if (disparity_px == missing) {
                depth_m[i] = 0.0F;
            } else if (disparity_px != exact_px[i]) { // else exact depth stays exact
                depth_m[i] = disparity_px > 0.0F ? pixels_metres_ / disparity_px : infinity;
            }
        }
    }
    if (faults_.missing_sky) {
        for (std::size_t i = 0; i < depth_m.size(); ++i) {
            if (std::isinf(depth_m[i]) && seen->obstacles[i] == sky_obstacle) {
                depth_m[i] = 0.0F;
            }
        }
    }
    return depth_m;
}

std::vector<float> StereoSensor::disparities_of(const Exposure& exposure) const {
    std::vector<float> disparities_px(exposure.depth_m.size());
    std::ranges::transform(exposure.depth_m, disparities_px.begin(),
                           [this](float depth_m) { return pixels_metres_ / depth_m; });
    return disparities_px;
}

void StereoSensor::lose_unseen(std::vector<float>& disparities_px) const {
    // The second camera, to the right, sees the pixel's surface at u less its disparity. Whatever
    // appears there or further left although it lies further right in this image stands before it.
    const auto width = static_cast<std::size_t>(camera_.width_px);
    for (std::size_t first = 0; first < disparities_px.size(); first += width) {
        float leftmost = infinity;
        for (std::size_t u = width; u-- > 0;) {
            float& disparity_px = disparities_px[first + u];
            const float appears = static_cast<float>(u) - disparity_px;
            if (leftmost <= appears || appears < 0.0F) {
                disparity_px = missing;
            }
            leftmost = std::min(leftmost, appears);
        }
    }
}

void StereoSensor::bleed(std::vector<float>& disparities_px,
                         std::vector<std::uint32_t>& obstacles) const {
    // Windows that straddle an edge match its near side: first along rows, then along columns.
    const std::ptrdiff_t reach = faults_.bleeding_px;
    const auto spread = [&](std::ptrdiff_t step, auto place, std::ptrdiff_t length) {
        const std::vector<float> before_px = disparities_px;
        const std::vector<std::uint32_t> before = obstacles;
        for_each_pixel(camera_, [&](int u, int v, std::size_t pixel) {
            const std::ptrdiff_t here = place(u, v);
            const auto middle = static_cast<std::ptrdiff_t>(pixel);
            std::ptrdiff_t nearest = middle;
            for (std::ptrdiff_t i = std::max(-reach, -here);
                 i <= std::min(reach, length - 1 - here); ++i) {
                const std::ptrdiff_t other = middle + i * step;
                if (before_px[static_cast<std::size_t>(other)] >
                    before_px[static_cast<std::size_t>(nearest)]) {
                    nearest = other;
                }
            }
            const auto source = static_cast<std::size_t>(nearest);
            if (before_px[source] - std::max(before_px[pixel], 0.0F) > edge_px) {
                disparities_px[pixel] = before_px[source];
                obstacles[pixel] = before[source];
            }
        });
    };
    spread(
        1, [](int u, int /*v*/) { return std::ptrdiff_t{u}; }, camera_.width_px);
    spread(
        camera_.width_px, [](int /*u*/, int v) { return std::ptrdiff_t{v}; }, camera_.height_px);
}

void StereoSensor::lose_weak(std::uint64_t number, std::span<const std::uint32_t> obstacles,
                             std::vector<float>& disparities_px) const {
    const SmoothField blank(camera_.width_px, camera_.height_px, blank_px,
                            CountedNumbers(seed_, Stream::weak_texture, number));
    for_each_pixel(camera_, [&](int u, int v, std::size_t pixel) {
        if (has_surface(disparities_px[pixel]) && blank.at(u, v) < weak_below_[obstacles[pixel]]) {
            disparities_px[pixel] = missing;
        }
    });
}

void StereoSensor::add_noise(std::uint64_t number, std::vector<float>& disparities_px) const {
    const SmoothField noise(camera_.width_px, camera_.height_px, window_px,
                            CountedNumbers(seed_, Stream::disparity, number));
    const auto sigma_px = static_cast<float>(faults_.disparity_sigma_px);
    for_each_pixel(camera_, [&](int u, int v, std::size_t pixel) {
        if (has_surface(disparities_px[pixel])) {
            // 0: matched at no disparity, as if infinitely far.
            disparities_px[pixel] =
                std::max(disparities_px[pixel] + sigma_px * noise.at(u, v), 0.0F);
        }
    });
}

void StereoSensor::add_stripes(std::uint64_t number, std::vector<float>& disparities_px) const {
    const CountedNumbers numbers(seed_, Stream::stripes);
    const auto start = static_cast<int>(numbers.bits(0) % stripe_period_px);
    const int drift = start + static_cast<int>(number % stripe_period_px) * stripe_drift_px;
    const auto error_px = static_cast<float>(faults_.screen_px);
    for_each_pixel(camera_, [&](int u, int v, std::size_t pixel) {
        const int along = u + v / 2 + drift;
        if (has_surface(disparities_px[pixel]) && along % stripe_period_px < stripe_px) {
            const float sign = along / stripe_period_px % 2 == 0 ? 1.0F : -1.0F;
            disparities_px[pixel] = std::max(disparities_px[pixel] + sign * error_px, 0.0F);
        }
    });
}

void StereoSensor::add_outliers(std::uint64_t number, std::vector<float>& disparities_px) const {
    const CountedNumbers numbers(seed_, Stream::outliers, number);
    const float most_px = pixels_metres_ / nearest_m;
    for_each_pixel(camera_, [&](int u, int v, std::size_t pixel) {
        const std::uint64_t patch = 2 * patch_of(u, v, outlier_px);
        if (has_surface(disparities_px[pixel]) && numbers.share(patch) < faults_.outlier_share) {
            disparities_px[pixel] = most_px * static_cast<float>(numbers.share(patch + 1));
        }
    });
}

} // namespace zonegrid
