#pragma once

#include "simulation/faults.h"
#include "zonegrid/sensors.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zonegrid {

/// What the pixels of an exposure see.
struct Exposure {
    std::vector<float> depth_m;           ///< `[v][u]`, along the optical axis; +infinity: sky
    std::vector<std::uint32_t> obstacles; ///< index, or sky_obstacle
};

/// A stereo camera that errs as its faults say (docs/simulation.md, "Faults"). What it makes of an
/// image depends on nothing but the seed, the image's number and what is to be seen.
class StereoSensor {
public:
    /// `texture` is that of each obstacle, 0 ... 1. Throws UsageError if a fault needs `stereo` and
    /// the camera has none.
    StereoSensor(const Camera& camera, std::span<const double> texture, const SensorFaults& faults,
                 std::uint64_t seed);

    /// Depth of image `number` in metres: missing pixels are 0, sky and what has no disparity is
    /// +infinity. `previous` is the exposure before, for the screen. Safe for concurrent calls.
    [[nodiscard]] std::vector<float> see(std::uint64_t number, const Exposure& exposure,
                                         const Exposure& previous) const;

    /// How far the disparities scatter, as description.toml tells the mapper; nothing if depth is
    /// exact. A step s scatters by s / sqrt(12).
    [[nodiscard]] std::optional<StereoNoise> noise() const;

private:
    [[nodiscard]] std::vector<float> disparities_of(const Exposure& exposure) const;
    void bleed(std::vector<float>& disparities_px, std::vector<std::uint32_t>& obstacles) const;
    void lose_unseen(std::vector<float>& disparities_px) const;
    void lose_weak(std::uint64_t number, std::span<const std::uint32_t> obstacles,
                   std::vector<float>& disparities_px) const;
    void add_noise(std::uint64_t number, std::vector<float>& disparities_px) const;
    void add_stripes(std::uint64_t number, std::vector<float>& disparities_px) const;
    void add_outliers(std::uint64_t number, std::vector<float>& disparities_px) const;

    Camera camera_;
    std::vector<float> weak_below_; ///< by obstacle: where the field is lower, nothing matches
    SensorFaults faults_;
    std::uint64_t seed_;
    float pixels_metres_ = 0.0F; ///< focal length times baseline: disparity times depth
};

} // namespace zonegrid
