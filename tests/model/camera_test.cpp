#include "zonegrid/mapper.h"

#include "support/scenes.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

// Cameras that cannot work are refused by the Mapper, before anything is computed with them.

namespace zonegrid {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Camera good_camera() {
    Camera camera = scenes::forward_camera(16, 12, 8.0);
    camera.stereo = StereoNoise{0.2, 0.5};
    return camera;
}

TEST(Camera, AGoodOneIsAccepted) {
    EXPECT_NO_THROW(Mapper(MapperOptions{}, good_camera()));
    Camera table = good_camera();
    table.directions.assign(192, {0.5F, -0.5F});
    EXPECT_NO_THROW(Mapper(MapperOptions{}, table));
    Camera exact = good_camera();
    exact.stereo->disparity_sigma_px = 0.0;
    EXPECT_NO_THROW(Mapper(MapperOptions{}, exact));
}

struct Refusal {
    const char* message;
    std::function<void(Camera&)> change;
};

void expect_refused(const std::vector<Refusal>& refusals) {
    for (const auto& [message, change] : refusals) {
        Camera camera = good_camera();
        change(camera);
        try {
            const Mapper mapper(MapperOptions{}, camera);
            ADD_FAILURE() << "accepted: " << message;
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr(message));
        } catch (const std::exception& error) {
            ADD_FAILURE() << "expected: " << message << ", got: " << error.what();
        }
    }
}

TEST(Camera, SizeMustBeInRange) {
    expect_refused({
        {"camera width: 0 pixels; it must be 1 .. 16384", [](auto& c) { c.width_px = 0; }},
        {"camera width: -5 pixels", [](auto& c) { c.width_px = -5; }},
        {"camera width: 16385 pixels", [](auto& c) { c.width_px = 16385; }},
        {"camera height: 0 pixels", [](auto& c) { c.height_px = 0; }},
        {"camera height: 20000 pixels", [](auto& c) { c.height_px = 20000; }},
    });
}

TEST(Camera, FocalLengthsAndPrincipalPointMustBeNumbers) {
    expect_refused({
        {"camera fx: 0; a focal length in pixels must be above 0", [](auto& c) { c.fx_px = 0.0; }},
        {"camera fx: -8", [](auto& c) { c.fx_px = -8.0; }},
        {"camera fx: nan", [](auto& c) { c.fx_px = nan; }},
        {"camera fx: inf", [](auto& c) { c.fx_px = infinity; }},
        {"camera fy: 0", [](auto& c) { c.fy_px = 0.0; }},
        {"camera fy: -0.5", [](auto& c) { c.fy_px = -0.5; }},
        {"camera fy: nan", [](auto& c) { c.fy_px = nan; }},
        {"camera cx, cy: not finite", [](auto& c) { c.cx_px = nan; }},
        {"camera cx, cy: not finite", [](auto& c) { c.cy_px = infinity; }},
    });
}

TEST(Camera, DirectionsMustFitTheImageAndTheModel) {
    expect_refused({
        {"camera directions: 5 entries for 192 pixels",
         [](auto& c) {
             c.directions.assign(5, {0.0F, 0.0F});
         }},
        {"camera directions: pixel (1, 2) looks more than 75 degrees off the axis",
         [](auto& c) {
             c.directions.assign(192, {0.0F, 0.0F});
             c.directions[33] = {0.0F, 5.0F};
         }},
        {"camera directions: pixel (15, 11)",
         [](auto& c) {
             c.directions.assign(192, {0.0F, 0.0F});
             c.directions[191].x() = std::numeric_limits<float>::quiet_NaN();
         }},
        {"camera directions: pixel (0, 0) looks more than 75 degrees off the axis",
         [](auto& c) { c.fx_px = 1.0; }},
        {"camera directions: pixel (0, 0)", [](auto& c) { c.cy_px = 1e6; }},
    });
}

TEST(Camera, StereoNoiseMustBeANumber) {
    expect_refused({
        {"camera baseline: 0 m; it must be above 0", [](auto& c) { c.stereo->baseline_m = 0.0; }},
        {"camera baseline: -0.1 m", [](auto& c) { c.stereo->baseline_m = -0.1; }},
        {"camera baseline: nan m", [](auto& c) { c.stereo->baseline_m = nan; }},
        {"camera disparity sigma: -1 pixels; it must be 0 or more",
         [](auto& c) { c.stereo->disparity_sigma_px = -1.0; }},
        {"camera disparity sigma: inf pixels",
         [](auto& c) { c.stereo->disparity_sigma_px = infinity; }},
    });
}

} // namespace
} // namespace zonegrid
