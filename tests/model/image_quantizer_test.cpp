#include "model/rays.h"

#include "support/scenes.h"
#include "zonegrid/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

// docs/model.md, section 3: numbers worked by hand.

namespace zonegrid {
namespace {

using Eigen::Vector3d;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Eigen::Isometry3d looking_north_from(const Vector3d& position_m) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = body_from_forward_camera();
    pose.translation() = position_m;
    return pose;
}

Window window_around(const MapperOptions& options, const Camera& camera, const CellIndex& cell) {
    Window window = make_window(options, camera);
    window.move_to(cell);
    return window;
}

ImageRays quantize(const Camera& camera, const MapperOptions& options,
                   const std::vector<float>& depth_m,
                   const Eigen::Isometry3d& pose = looking_north_from(Vector3d::Zero())) {
    ImageRays rays;
    ImageQuantizer(camera, options)
        .quantize(depth_m, pose,
                  window_around(options, camera, *cell_of(pose.translation(), options.cell_m)),
                  rays);
    return rays;
}

/// What a depth becomes on the optical axis, for cells of 1 m and a range of 40 m.
PixelDepth on_axis(float depth_m, const MapperOptions& options = {},
                   std::optional<StereoNoise> stereo = {}) {
    Camera camera = scenes::forward_camera(1, 1, 100.0);
    camera.stereo = stereo;
    return quantize(camera, options, {depth_m}).depths.at(0);
}

constexpr PixelDepth missing{-1, -1};
constexpr PixelDepth free_to_the_range{10240, -1};

TEST(ImageQuantizer, MissingDepths) {
    for (const float depth_m : {nan, 0.0F, -0.0F, -1.0F, -infinity}) {
        EXPECT_EQ(on_axis(depth_m), missing) << depth_m;
    }
}

TEST(ImageQuantizer, RoundsToTheNearestSubCell) {
    EXPECT_EQ(on_axis(1.0F), (PixelDepth{256, 256}));
    EXPECT_EQ(on_axis(0.001F), (PixelDepth{0, 0}));         // 0.256 sub-cells
    EXPECT_EQ(on_axis(1.0F / 512), (PixelDepth{1, 1}));     // half a sub-cell: up
    EXPECT_EQ(on_axis(10.0019F), (PixelDepth{2560, 2560})); // 2560.49
    EXPECT_EQ(on_axis(10.002F), (PixelDepth{2561, 2561}));  // 2560.51
    EXPECT_EQ(on_axis(std::numeric_limits<float>::denorm_min()), (PixelDepth{0, 0}));
}

TEST(ImageQuantizer, TheRangeIsInclusiveToTheSubCell) {
    EXPECT_EQ(on_axis(40.0F), (PixelDepth{10240, 10240}));
    EXPECT_EQ(on_axis(40.0019F), (PixelDepth{10240, 10240})); // rounds down to the range
    EXPECT_EQ(on_axis(40.0F + 1.0F / 512), free_to_the_range);
    EXPECT_EQ(on_axis(40.0F + 1.0F / 256), free_to_the_range);
    EXPECT_EQ(on_axis(infinity), free_to_the_range);
    EXPECT_EQ(on_axis(std::numeric_limits<float>::max()), free_to_the_range);
}

TEST(ImageQuantizer, TheRangeIsMeasuredAlongTheRay) {
    // fx 4, pixel 3 to the right of the centre: direction (0.75, 0, 1), length 1.25, so the range
    // of 40 m ends at a depth of 32 m.
    Camera camera = scenes::forward_camera(4, 1, 4.0);
    camera.cx_px = 0.0;
    const float beyond = 32.0F + 1.0F / 256;
    EXPECT_EQ(quantize(camera, {}, {nan, nan, nan, 32.0F}).depths[3], (PixelDepth{8192, 8192}));
    EXPECT_EQ(quantize(camera, {}, {nan, nan, nan, beyond}).depths[3], (PixelDepth{8192, -1}));
    EXPECT_EQ(quantize(camera, {}, {infinity, nan, nan, infinity}).depths,
              (std::vector<PixelDepth>{{10240, -1}, missing, missing, {8192, -1}}));
}

TEST(ImageQuantizer, SpreadGrowsWithTheSquareOfTheDepth) {
    // f 100 px, baseline 0.1 m, disparity off by 0.5 px: sigma = z^2 * 0.05 m = z^2 * 12.8 sub.
    const StereoNoise stereo{0.1, 0.5};
    MapperOptions span;
    span.model = SensorModel::span;
    EXPECT_EQ(on_axis(1.0F, span, stereo), (PixelDepth{256 - 13, 256 + 13})); // 12.8
    EXPECT_EQ(on_axis(2.0F, span, stereo), (PixelDepth{512 - 51, 512 + 51})); // 51.2
    EXPECT_EQ(on_axis(0.125F, span, stereo), (PixelDepth{32, 32}));           // 0.2
    EXPECT_EQ(on_axis(20.0F, span, stereo), (PixelDepth{0, 10240}));          // 5120, as its depth
    EXPECT_EQ(on_axis(38.0F, span, stereo), (PixelDepth{0, 10240}));          // 18483
    EXPECT_EQ(on_axis(16.0F, span, stereo), (PixelDepth{4096 - 3277, 4096 + 3277})); // 3276.8
    EXPECT_EQ(on_axis(41.0F, span, stereo), free_to_the_range);
    EXPECT_EQ(on_axis(nan, span, stereo), missing);

    span.span_sigmas = 3.0;
    EXPECT_EQ(on_axis(2.0F, span, stereo), (PixelDepth{512 - 154, 512 + 154})); // 153.6
    span.span_sigmas = 0.0;
    EXPECT_EQ(on_axis(2.0F, span, stereo), (PixelDepth{512, 512}));
}

TEST(ImageQuantizer, SpreadInSmallCellsAndAtTheRange) {
    MapperOptions span;
    span.model = SensorModel::span;
    span.cell_m = 0.5; // 512 sub-cells a metre: limit 20480, sigma z^2 * 25.6 sub
    EXPECT_EQ(on_axis(2.0F, span, StereoNoise{0.1, 0.5}), (PixelDepth{1024 - 102, 1024 + 102}));
    span.cell_m = 1.0; // sigma at 39 m: 1521 * 0.128 = 194.7, of which the range leaves 256
    EXPECT_EQ(on_axis(39.0F, span, StereoNoise{1.0, 0.05}), (PixelDepth{9984 - 195, 9984 + 195}));
    EXPECT_EQ(on_axis(39.5F, span, StereoNoise{1.0, 0.05}), (PixelDepth{10112 - 200, 10240}));
}

TEST(ImageQuantizer, NoSpreadWithoutBaselineOrInTheLineModel) {
    EXPECT_EQ(on_axis(2.0F, {}, StereoNoise{0.1, 0.5}), (PixelDepth{512, 512}));
    MapperOptions span;
    span.model = SensorModel::span;
    EXPECT_EQ(on_axis(2.0F, span), (PixelDepth{512, 512}));
}

TEST(ImageQuantizer, RayBasisOfACameraThatLooksNorth) {
    // Camera right is east, down is down, the axis is north; 2^28 = 268435456.
    Camera camera = scenes::forward_camera(3, 2, 4.0);
    camera.fy_px = 3.0;
    camera.cx_px = 1.0;
    camera.cy_px = 0.5;
    const ImageRays rays = quantize(camera, {}, std::vector<float>(6, nan));
    EXPECT_EQ(rays.width_px, 3);
    EXPECT_EQ(rays.height_px, 2);
    EXPECT_EQ(rays.u, (Direction{0, 1 << 26, 0}));
    EXPECT_EQ(rays.v, (Direction{0, 0, 89478485}));                 // 89478485.33
    EXPECT_EQ(rays.a, (Direction{1 << 28, -(1 << 26), -44739243})); // -44739242.67
    EXPECT_TRUE(rays.directions.empty());
    EXPECT_EQ(rays.direction(2, 1), (Direction{1 << 28, 1 << 26, 44739242}));
    EXPECT_EQ(rays.spacing, 768); // 256 * the lesser focal length
    EXPECT_FALSE(rays.spanned);
}

TEST(ImageQuantizer, SpacingIsCapped) {
    Camera camera = scenes::forward_camera(1, 1, 262144.0);
    EXPECT_EQ(quantize(camera, {}, {1.0F}).spacing, 1 << 26);
    camera.fx_px = camera.fy_px = 1e9;
    EXPECT_EQ(quantize(camera, {}, {1.0F}).spacing, 1 << 26);
    camera.fx_px = 262143.99;
    EXPECT_EQ(quantize(camera, {}, {1.0F}).spacing, (1 << 26) - 3);
}

TEST(ImageQuantizer, OriginIsRelativeToTheWindow) {
    const Camera camera = scenes::forward_camera(1, 1, 100.0);
    // Reach 42, zones of 32: cell (-1, 100, 0) sits in a window from zones (-2, 1, -2).
    const auto rays = quantize(camera, {}, {1.0F}, looking_north_from({-0.001, 100.5, 0.0}));
    EXPECT_EQ(rays.origin, (SubPoint{256 * 63 + 255, 256 * (100 - 32) + 128, 256 * 64}));
}

TEST(ImageQuantizer, TableOfDirections) {
    Camera camera = scenes::forward_camera(2, 1, 4.0);
    camera.directions = {{0.75F, 0.0F}, {-0.125F, 0.5F}};
    const ImageRays rays = quantize(camera, {}, {infinity, 1.0F});
    ASSERT_EQ(rays.directions.size(), 2U);
    EXPECT_EQ(rays.direction(0, 0), (Direction{1 << 28, 3 << 26, 0}));
    EXPECT_EQ(rays.direction(1, 0), (Direction{1 << 28, -(1 << 25), 1 << 27}));
    EXPECT_EQ(rays.depths[0], (PixelDepth{8192, -1})); // length 1.25
    EXPECT_EQ(rays.depths[1], (PixelDepth{256, 256}));
    EXPECT_EQ(rays.u, (Direction{0, 1 << 26, 0})) << "sub-rays take their spacing from fx";
}

TEST(ImageQuantizer, APinholeAsTableGivesTheSameLimits) {
    Camera pinhole = scenes::forward_camera(16, 12, 8.0);
    Camera table = pinhole;
    for (int v_px = 0; v_px < 12; ++v_px) {
        for (int u_px = 0; u_px < 16; ++u_px) {
            table.directions.push_back(
                Eigen::Vector2d((u_px - 7.5) / 8.0, (v_px - 5.5) / 8.0).cast<float>());
        }
    }
    const std::vector<float> sky(192, infinity);
    const auto from_pinhole = quantize(pinhole, {}, sky);
    const auto from_table = quantize(table, {}, sky);
    EXPECT_EQ(from_pinhole.depths, from_table.depths);
    EXPECT_EQ(from_pinhole.direction(3, 9), from_table.direction(3, 9));
}

TEST(ImageRays, PointAtFloorsOnEachAxis) {
    ImageRays rays;
    rays.origin = {1000, 1000, 1000};
    EXPECT_EQ(rays.point_at({1 << 28, -(1 << 28), 0}, 5), (SubPoint{1005, 995, 1000}));
    EXPECT_EQ(rays.point_at({1, -1, 0}, 1), (SubPoint{1000, 999, 1000}));
    EXPECT_EQ(rays.point_at({(1 << 27), -(1 << 27), (1 << 27) - 1}, 3),
              (SubPoint{1001, 998, 1001}));
    // 32 x 32 -> 64 bits: 2^30 * 10240 does not fit 32.
    EXPECT_EQ(rays.point_at({(1 << 30) - 1, 0, 0}, 10240).x, 1000 + 40959);
}

TEST(CellOf, FloorsAndRefusesWhatIsTooFar) {
    EXPECT_EQ(cell_of({-0.001, 0.0, 0.999}, 1.0), (CellIndex{-1, 0, 0}));
    EXPECT_EQ(cell_of({-1.0, 0.5, 2.4}, 0.5), (CellIndex{-2, 1, 4}));
    constexpr double farthest = 1 << 30;
    EXPECT_EQ(cell_of({farthest, -farthest, 0.0}, 1.0), (CellIndex{1 << 30, -(1 << 30), 0}));
    EXPECT_FALSE(cell_of({farthest + 1.0, 0.0, 0.0}, 1.0));
    EXPECT_FALSE(cell_of({0.0, -farthest - 0.5, 0.0}, 1.0));
    EXPECT_FALSE(cell_of({0.0, 0.0, std::nan("")}, 1.0));
    EXPECT_FALSE(cell_of({0.0, std::numeric_limits<double>::infinity(), 0.0}, 1.0));
}

TEST(WindowRelative, NothingOutsideTheWindow) {
    Window window(8, 3, 4);
    window.move_to({0, 0, 0}); // zones -1 .. 1, cells -8 .. 15
    EXPECT_EQ(window_relative({-8.0, 0.0, 15.999}, 1.0, window), (SubPoint{0, 2048, 24 * 256 - 1}));
    EXPECT_FALSE(window_relative({-8.001, 0.0, 0.0}, 1.0, window));
    EXPECT_FALSE(window_relative({0.0, 16.0, 0.0}, 1.0, window));
    EXPECT_FALSE(window_relative({0.0, 0.0, 1e300}, 1.0, window));
    EXPECT_FALSE(window_relative({0.0, std::nan(""), 0.0}, 1.0, window));
}

} // namespace
} // namespace zonegrid
