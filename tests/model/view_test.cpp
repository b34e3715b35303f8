#include "model/rays.h"

#include "support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// The view of docs/model.md, section 3: numbers worked by hand.

namespace zonegrid {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

constexpr std::int32_t diagonal = 11585; // 2^14 / sqrt(2), rounded
constexpr std::int32_t unit = 1 << 14;

/// 3 x 3 pixels with slopes of -1, 0 and 1 on both axes.
Camera wide_camera() {
    Camera camera = scenes::forward_camera(3, 3, 1.0);
    camera.cx_px = 1.0;
    camera.cy_px = 1.0;
    return camera;
}

/// The view of a camera that looks north, and the window's first cell.
std::pair<View, CellIndex> view_of(const Camera& camera, const std::vector<float>& depth_m,
                                   const Eigen::Vector3d& position_m,
                                   const MapperOptions& options = {}) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = body_from_forward_camera();
    pose.translation() = position_m;
    Window window = make_window(options, camera);
    window.move_to(*cell_of(position_m, options.cell_m));
    ImageRays rays;
    ImageQuantizer(camera, options).quantize(depth_m, pose, window, rays);
    return {rays.view, window.first_cell()};
}

View view_of(const Camera& camera, const std::vector<float>& depth_m) {
    return view_of(camera, depth_m, Eigen::Vector3d::Zero()).first;
}

TEST(View, SidesOfAWholeImagePassTheMiddlesOfItsOuterPixels) {
    const View view = view_of(wide_camera(), std::vector<float>(9, 5.0F));
    EXPECT_TRUE(view.bounded);
    // World axes: north is the optical axis, east is right, down is down.
    EXPECT_EQ(view.sides[0], (View::Vector{diagonal, diagonal, 0}));
    EXPECT_EQ(view.sides[1], (View::Vector{diagonal, -diagonal, 0}));
    EXPECT_EQ(view.sides[2], (View::Vector{diagonal, 0, diagonal}));
    EXPECT_EQ(view.sides[3], (View::Vector{diagonal, 0, -diagonal}));
}

TEST(View, EndsWithTheOutermostPixelsThatAreNotMissing) {
    // Of the middle column only the two lower pixels, of the right one the lowest.
    const View view = view_of(wide_camera(), {nan, nan, nan, nan, 5.0F, nan, nan, 5.0F, 5.0F});
    EXPECT_EQ(view.sides[0], (View::Vector{0, unit, 0}));             // x >= 0 z
    EXPECT_EQ(view.sides[1], (View::Vector{diagonal, -diagonal, 0})); // x <= z
    EXPECT_EQ(view.sides[2], (View::Vector{0, 0, unit}));             // y >= 0 z
    EXPECT_EQ(view.sides[3], (View::Vector{diagonal, 0, -diagonal})); // y <= z
}

TEST(View, OfAnImageWithoutAPixelHoldsNothing) {
    const View view = view_of(wide_camera(), std::vector<float>(9, nan));
    EXPECT_TRUE(view.bounded);
    EXPECT_EQ(view.radius, 0);
}

TEST(View, OfATableOfDirectionsKeepsInsideOfAllOuterPixels) {
    Camera camera = wide_camera();
    camera.directions = {
        {-1.0F, -1.0F}, {0.0F, -0.5F}, {1.0F, -1.0F}, // the top edge sags
        {-2.0F, 0.0F},  {0.0F, 0.0F},  {0.5F, 0.0F},  // the right edge is drawn in
        {-1.0F, 1.0F},  {0.0F, 1.0F},  {1.0F, 1.0F},
    };
    const View view = view_of(camera, std::vector<float>(9, 5.0F));
    const double of_half = 16384.0 / std::sqrt(1.25);
    const auto rounded = [](double value) {
        return static_cast<std::int32_t>(std::floor(value + 0.5));
    };
    EXPECT_EQ(view.sides[0], (View::Vector{diagonal, diagonal, 0})); // x >= -z, not -2 z
    EXPECT_EQ(view.sides[1], (View::Vector{rounded(0.5 * of_half), rounded(-of_half), 0}));
    EXPECT_EQ(view.sides[2], (View::Vector{rounded(0.5 * of_half), 0, rounded(of_half)}));
    EXPECT_EQ(view.sides[3], (View::Vector{diagonal, 0, -diagonal}));
}

TEST(View, CentreAndRadiusAreInSixteenthsOfACell) {
    MapperOptions options;
    options.cell_m = 0.5;
    options.range_m = 20.3;
    const auto [view, first] =
        view_of(wide_camera(), std::vector<float>(9, 5.0F), {3.3, -0.01, 0.0}, options);
    EXPECT_EQ(view.centre.x, 105 - 16 * first.x); // 6.6 cells, 105.6 sixteenths
    EXPECT_EQ(view.centre.y, -1 - 16 * first.y);
    EXPECT_EQ(view.centre.z, -16 * first.z);
    EXPECT_EQ(view.radius, 649); // 40.6 cells, 649.6 sixteenths
}

} // namespace
} // namespace zonegrid
