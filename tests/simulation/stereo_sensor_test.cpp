#include "simulation/stereo_sensor.h"

#include "truth/ray_caster.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int width = 320;
constexpr int height = 240;
constexpr std::array full_texture{1.0};
constexpr float sky_m = std::numeric_limits<float>::infinity();

/// f b = 335 * 0.3 = 100.5: at 20 m a disparity of 5.025 pixels.
Camera stereo_camera() {
    Camera camera;
    camera.width_px = width;
    camera.height_px = height;
    camera.fx_px = 335.0;
    camera.fy_px = 335.0;
    camera.cx_px = 159.5;
    camera.cy_px = 119.5;
    camera.stereo = StereoNoise{0.3, 0.25};
    return camera;
}

std::size_t pixel_at(int u, int v) {
    return static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
}

/// Obstacle 0, but for sky where `depth_m` is infinite.
Exposure exposure_of(const std::function<float(int u, int v)>& depth_m) {
    Exposure exposure;
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            const float value = depth_m(u, v);
            exposure.depth_m.push_back(value);
            exposure.obstacles.push_back(std::isinf(value) ? sky_obstacle : 0U);
        }
    }
    return exposure;
}

Exposure wall(float depth_m) {
    return exposure_of([depth_m](int, int) { return depth_m; });
}

/// A plate of 60 x 80 pixels at 5 m (disparity 20.1) before a wall at 20 m (5.025).
bool on_plate(int u, int v) {
    return u >= 100 && u < 160 && v >= 80 && v < 160;
}

Exposure plate() {
    return exposure_of([](int u, int v) { return on_plate(u, v) ? 5.0F : 20.0F; });
}

std::vector<float> see(const SensorFaults& faults, const Exposure& exposure,
                       std::uint64_t number = 0, std::uint64_t seed = 1, double texture = 1.0) {
    return StereoSensor(stereo_camera(), std::array{texture}, faults, seed)
        .see(number, exposure, exposure);
}

SensorFaults with_noise(double sigma_px) {
    SensorFaults faults;
    faults.disparity_sigma_px = sigma_px;
    return faults;
}

TEST(StereoSensor, IsExactWithoutFaults) {
    const Exposure exposure = exposure_of(
        [](int u, int v) { return v < 50 ? sky_m : 3.0F + 0.37F * static_cast<float>(u % 100); });
    EXPECT_EQ(see({}, exposure), exposure.depth_m);
    EXPECT_FALSE(StereoSensor(stereo_camera(), full_texture, {}, 1).noise());
}

TEST(StereoSensor, ScattersAsTheFormulaSays) {
    for (const auto& [depth_m, sigma_px] :
         {std::pair{20.0, 0.1}, std::pair{20.0, 0.25}, std::pair{40.0, 0.1}}) {
        double sum = 0.0;
        double squares = 0.0;
        double count = 0.0;
        for (std::uint64_t number = 0; number < 8; ++number) {
            for (const float value :
                 see(with_noise(sigma_px), wall(static_cast<float>(depth_m)), number)) {
                sum += value;
                squares += static_cast<double>(value) * value;
                ++count;
            }
        }
        const double mean_m = sum / count;
        const double sigma_m = std::sqrt(squares / count - mean_m * mean_m);
        const double expected_m = depth_m * depth_m * sigma_px / (335.0 * 0.3);
        EXPECT_NEAR(sigma_m / expected_m, 1.0, 0.03) << depth_m << " " << sigma_px;
        EXPECT_NEAR(mean_m, depth_m, 0.02 * depth_m);
    }
}

TEST(StereoSensor, TellsTheMapperHowItScatters) {
    SensorFaults faults = with_noise(0.3);
    faults.disparity_step_px = 0.5;
    const auto noise = StereoSensor(stereo_camera(), full_texture, faults, 1).noise();
    ASSERT_TRUE(noise);
    EXPECT_DOUBLE_EQ(noise->baseline_m, 0.3);
    EXPECT_DOUBLE_EQ(noise->disparity_sigma_px, std::sqrt(0.09 + 0.25 / 12.0));
}

TEST(StereoSensor, ErrsAlikeWithinAMatchersWindow) {
    const std::vector<float> depth_m = see(with_noise(0.1), wall(20.0F));
    const auto correlation = [&](int shift_u, int shift_v) {
        double products = 0.0;
        double squares = 0.0;
        for (int v = 0; v + shift_v < height; ++v) {
            for (int u = 0; u + shift_u < width; ++u) {
                const double here = depth_m[pixel_at(u, v)] - 20.0;
                products += here * (depth_m[pixel_at(u + shift_u, v + shift_v)] - 20.0);
                squares += here * here;
            }
        }
        return products / squares;
    };
    EXPECT_GT(correlation(1, 0), 0.8);
    EXPECT_GT(correlation(0, 1), 0.8);
    EXPECT_NEAR(correlation(10, 0), 0.0, 0.05); // two windows away nothing is shared
    EXPECT_NEAR(correlation(0, 10), 0.0, 0.05);
    const std::vector<float> next_m = see(with_noise(0.1), wall(20.0F), 1);
    double products = 0.0;
    for (std::size_t i = 0; i < depth_m.size(); ++i) {
        products += (depth_m[i] - 20.0) * (next_m[i] - 20.0);
    }
    EXPECT_NEAR(products / static_cast<double>(depth_m.size()) / 0.158, 0.0, 0.05); // 0.398 m ^2
}

TEST(StereoSensor, QuantisesDisparities) {
    SensorFaults faults;
    faults.disparity_step_px = 1.0;
    const Exposure slope =
        exposure_of([](int u, int) { return 4.0F + 0.3F * static_cast<float>(u); });
    std::set<float> values;
    const std::vector<float> depth_m = see(faults, slope);
    for (int u = 0; u < width; ++u) {
        const float value = depth_m[pixel_at(u, 7)];
        const double disparity_px = 335.0 * 0.3 / value;
        EXPECT_NEAR(disparity_px, std::round(disparity_px), 1e-5);
        EXPECT_NEAR(disparity_px, 335.0 * 0.3 / (4.0 + 0.3 * u), 0.5 + 1e-4);
        values.insert(value);
    }
    EXPECT_EQ(values.size(), 23U); // disparities 1 ... 25, but for two that neighbours skip
}

TEST(StereoSensor, LosesWhatTheSecondCameraDoesNotSee) {
    SensorFaults faults;
    faults.missing = 1.0;
    const std::vector<float> depth_m = see(faults, plate());
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            // The second camera stands to the right: of the wall it sees what lies 15.075 pixels to
            // the left of the plate, but for the plate's own width; and nothing of the first five
            // columns, which are outside its image.
            const bool hidden = v >= 80 && v < 160 && u >= 85 && u < 100;
            const bool outside = u < 6 && u < 5.025;
            EXPECT_EQ(depth_m[pixel_at(u, v)] == 0.0F, hidden || outside) << u << " " << v;
        }
    }
}

TEST(StereoSensor, LosesWeakTexture) {
    SensorFaults faults;
    faults.missing = 1.0;
    const auto share = [&](double texture, double strength) {
        faults.missing = strength;
        double lost = 0.0;
        for (std::uint64_t number = 0; number < 8; ++number) {
            const std::vector<float> depth_m = see(faults, wall(20.0F), number, 1, texture);
            for (int v = 0; v < height; ++v) {
                for (int u = 10; u < width; ++u) {
                    lost += depth_m[pixel_at(u, v)] == 0.0F ? 1.0 : 0.0;
                }
            }
        }
        return lost / (8.0 * height * (width - 10));
    };
    EXPECT_EQ(share(1.0, 1.0), 0.0);
    EXPECT_EQ(share(0.0, 1.0), 1.0);
    EXPECT_NEAR(share(0.7, 1.0), 0.3, 0.02);
    EXPECT_NEAR(share(0.6, 0.5), 0.2, 0.02);
}

TEST(StereoSensor, BleedsNearOverFar) {
    SensorFaults faults;
    faults.bleeding_px = 2;
    const std::vector<float> depth_m = see(faults, plate());
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            const bool spread = u >= 98 && u < 162 && v >= 78 && v < 162;
            EXPECT_EQ(depth_m[pixel_at(u, v)], spread ? 5.0F : 20.0F) << u << " " << v;
        }
    }
    // No edge, no bleeding: the ground's disparity changes by less than a pixel a row.
    const Exposure ground = exposure_of([](int, int v) {
        return v < 125 ? sky_m : 335.0F * 2.0F / (static_cast<float>(v) - 119.5F);
    });
    const std::vector<float> ground_m = see(faults, ground);
    for (int v = 130; v < height; ++v) {
        EXPECT_EQ(ground_m[pixel_at(50, v)], ground.depth_m[pixel_at(50, v)]) << v;
    }
}

TEST(StereoSensor, MatchesWrongly) {
    SensorFaults faults;
    faults.outlier_share = 0.02;
    double wrong = 0.0;
    for (std::uint64_t number = 0; number < 20; ++number) {
        for (const float value : see(faults, wall(20.0F), number)) {
            wrong += value == 20.0F ? 0.0 : 1.0;
            EXPECT_GE(value, 2.0F);
        }
    }
    EXPECT_NEAR(wrong / (20.0 * width * height), 0.02, 0.003);
}

TEST(StereoSensor, TakesSkyAsInfiniteOrMissing) {
    SensorFaults faults = with_noise(0.25);
    faults.outlier_share = 0.1;
    const Exposure half = exposure_of([](int, int v) { return v < 100 ? sky_m : 30.0F; });
    EXPECT_EQ(see(faults, half)[pixel_at(7, 50)], sky_m);
    faults.missing_sky = true;
    const std::vector<float> depth_m = see(faults, half);
    EXPECT_EQ(depth_m[pixel_at(7, 50)], 0.0F);
    EXPECT_GT(depth_m[pixel_at(7, 150)], 0.0F);
}

TEST(StereoSensor, MixesExposuresOfAScreen) {
    SensorFaults faults;
    faults.screen_px = 1e-6; // stripes that hardly show
    const StereoSensor sensor(stereo_camera(), full_texture, faults, 1);
    const std::vector<float> depth_m = sensor.see(3, wall(20.0F), wall(10.0F));
    double earlier = 0.0;
    for (const float value : depth_m) {
        const bool before = std::abs(value - 10.0F) < 0.01F;
        ASSERT_TRUE(before || std::abs(value - 20.0F) < 0.01F);
        earlier += before ? 1.0 : 0.0;
    }
    EXPECT_NEAR(earlier / (width * height), 0.5, 0.05);
    EXPECT_NEAR(depth_m[pixel_at(0, 0)], depth_m[pixel_at(7, 7)], 0.01F); // one patch
}

TEST(StereoSensor, SeesStripesOfAScreen) {
    SensorFaults faults;
    faults.screen_px = 1.0;
    std::vector<double> counts(3, 0.0);
    for (const float value : see(faults, wall(20.0F))) { // disparity 5.025
        const double error_px = 335.0 * 0.3 / value - 5.025;
        const double off = std::round(error_px);
        EXPECT_NEAR(error_px, off, 1e-4);
        counts.at(static_cast<std::size_t>(off + 1.0)) += 1.0 / (width * height);
    }
    EXPECT_NEAR(counts[0], 0.1, 0.03);
    EXPECT_NEAR(counts[1], 0.8, 0.03);
    EXPECT_NEAR(counts[2], 0.1, 0.03);
}

TEST(StereoSensor, KeepsFaultsApart) {
    // What one fault does is the same with and without another.
    SensorFaults noise = with_noise(0.1);
    SensorFaults both = noise;
    both.outlier_share = 0.05;
    const std::vector<float> noisy_m = see(noise, wall(20.0F));
    const std::vector<float> both_m = see(both, wall(20.0F));
    std::size_t same = 0;
    for (std::size_t i = 0; i < noisy_m.size(); ++i) {
        same += noisy_m[i] == both_m[i] ? 1U : 0U;
    }
    EXPECT_GT(same, noisy_m.size() * 9 / 10);
    EXPECT_LT(same, noisy_m.size());
    EXPECT_NE(see(noise, wall(20.0F), 0, 2), noisy_m); // another seed
    EXPECT_NE(see(noise, wall(20.0F), 1), noisy_m);    // another image
    EXPECT_EQ(see(noise, wall(20.0F)), noisy_m);
}

TEST(StereoSensor, NeedsAStereoCameraForItsFaults) {
    Camera camera = stereo_camera();
    camera.stereo.reset();
    EXPECT_THAT([&] { const StereoSensor sensor(camera, full_texture, with_noise(0.1), 1); },
                ThrowsMessage<UsageError>(HasSubstr("no stereo camera")));
    SensorFaults sky;
    sky.missing_sky = true;
    const StereoSensor sensor(camera, full_texture, sky, 1);
    EXPECT_EQ(sensor.see(0, wall(sky_m), wall(sky_m))[0], 0.0F);
    EXPECT_EQ(sensor.see(0, wall(9.0F), wall(9.0F))[0], 9.0F);
}

} // namespace
} // namespace zonegrid::testing
