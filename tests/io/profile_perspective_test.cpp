#include "io/colour_map.h"
#include "io/profile_perspective_blocks.h"
#include "io/profile_perspective_grid.h"
#include "io/profile_perspective_raster.h"
#include "io/profile_perspective_view.h"
#include "io/profile_picture_canvas.h"
#include "io/profile_picture_layout.h"
#include "io/profile_picture_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

constexpr HeightRange everything{-1e9, 1e9, false, false};
constexpr GroundPlan square{0.0, 20.0, 0.0, 20.0};

PerspectiveView view_from(double azimuth_deg) {
    return {SceneBox{square, 0.0, 10.0, 1.0}, picture_frame(640, 480), azimuth_deg, 35.0};
}

HeightProfile flat_ground(int side) {
    HeightProfile profile{1.0, {}};
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) {
            profile.columns.push_back({x, y, 0});
        }
    }
    return profile;
}

TEST(PerspectiveView, LooksFromTheDirectionAsked) {
    const PerspectiveView south_west = view_from(215.0);
    const SeenPoint middle = south_west.project(10.0, 10.0, 0.0);
    const SeenPoint north = south_west.project(15.0, 10.0, 0.0);
    const SeenPoint east = south_west.project(10.0, 15.0, 0.0);
    const SeenPoint above = south_west.project(10.0, 10.0, 5.0);
    EXPECT_LT(north.y_px, middle.y_px);
    EXPECT_LT(north.inverse_depth, middle.inverse_depth);
    EXPECT_GT(east.x_px, middle.x_px);
    EXPECT_LT(above.y_px, middle.y_px);
    EXPECT_GT(above.inverse_depth, middle.inverse_depth);

    const PerspectiveView north_east = view_from(35.0);
    EXPECT_GT(north_east.project(15.0, 10.0, 0.0).y_px, north_east.project(10.0, 10.0, 0.0).y_px);
    EXPECT_LT(north_east.project(10.0, 15.0, 0.0).x_px, north_east.project(10.0, 10.0, 0.0).x_px);
}

TEST(PerspectiveView, KeepsTheWholeBoxInTheFrame) {
    const PictureFrame frame = picture_frame(640, 480);
    int looked_at = 0;
    for (double azimuth_deg = 5.0; azimuth_deg < 360.0; azimuth_deg += 30.0) {
        const PerspectiveView view = view_from(azimuth_deg);
        for (int corner = 0; corner < 8; ++corner) {
            const SeenPoint seen =
                view.project(corner % 2 * 20.0, corner / 2 % 2 * 20.0, corner / 4 * 10.0);
            EXPECT_GT(seen.x_px, frame.left_px);
            EXPECT_LT(seen.x_px, frame.right_px());
            EXPECT_GT(seen.y_px, frame.top_px);
            EXPECT_LT(seen.y_px, frame.bottom_px());
            ++looked_at;
        }
    }
    EXPECT_EQ(looked_at, 96);
}

TEST(PerspectiveView, IsChosenWhereAWallHidesLeast) {
    // A wall along the south and west: from the south-west it would hide all the rest.
    HeightProfile profile = flat_ground(20);
    for (ProfileColumn& column : profile.columns) {
        column.z = column.x == 0 || column.y == 0 ? -30 : 0;
    }
    const SceneBox box{ground_plan(profile, {}), 0.0, 30.0, 1.0};
    const PerspectiveView walled =
        choose_view(box, picture_frame(640, 480), TileGrid(profile, everything, 100));
    EXPECT_TRUE(walled.azimuth_deg() < 90.0) << walled.azimuth_deg();

    const PerspectiveView open =
        choose_view(box, picture_frame(640, 480), TileGrid(flat_ground(20), everything, 100));
    EXPECT_GT(open.azimuth_deg(), 180.0);
    EXPECT_LT(open.azimuth_deg(), 270.0);
}

TEST(TileGrid, TakesTheHighestColumnOfEachTileAndClampsIt) {
    HeightProfile profile = flat_ground(8);
    profile.columns[0].z = -3;                // column (0, 0)
    profile.columns.push_back({-1, -1, -50}); // a tile of its own
    const HeightRange drawn{-5.0, 20.0, false, true};
    const TileGrid tiles(profile, drawn, 5); // 9 cells a side: 2 a tile
    EXPECT_DOUBLE_EQ(tiles.tile_m(), 2.0);
    EXPECT_EQ(tiles.north_count(), 5);
    EXPECT_DOUBLE_EQ(tiles.north_m(0), -2.0);
    EXPECT_DOUBLE_EQ(tiles.top_at_m(-0.5, -0.5), 20.0);
    EXPECT_DOUBLE_EQ(tiles.top_at_m(1.5, 1.5), 3.0);
    EXPECT_DOUBLE_EQ(tiles.top_at_m(2.5, 1.5), 0.0);
    EXPECT_TRUE(std::isnan(tiles.top_at_m(-0.5, 4.5)));
    EXPECT_TRUE(std::isnan(tiles.top_at_m(100.0, 0.0)));
    EXPECT_DOUBLE_EQ(tiles.ground_m(0, 0), 0.0);
}

TEST(BlockRaster, ShowsBlocksWhereTheViewSaysAndNearerOnesInFront) {
    HeightProfile profile = flat_ground(20);
    profile.columns[10 * 20 + 10].z = -8;
    const TileGrid tiles(profile, everything, 100);
    const PerspectiveView view = view_from(215.0);
    BlockRaster raster(640, 480, 2);
    const SceneBox box{square, 0.0, 10.0, 1.0};
    fill_blocks(raster, tiles, view, box);

    // Behind the block, seen from the south-west, ground is hidden; before it, it is not.
    EXPECT_TRUE(raster.hides(view.project(12.5, 12.0, 0.2)));
    EXPECT_FALSE(raster.hides(view.project(8.5, 9.0, 0.2)));
    EXPECT_FALSE(raster.hides(view.project(10.5, 10.5, 8.2)));
    EXPECT_TRUE(raster.hides(view.project(10.5, 10.5, 7.0)));

    Canvas canvas(640, 480);
    raster.paint(canvas, ColourTable(0.0, 8.0), 1e9);
    const auto colour_at = [&](double north_m, double east_m, double height_m) {
        const SeenPoint seen = view.project(north_m, east_m, height_m);
        return canvas.pixel(static_cast<int>(seen.x_px), static_cast<int>(seen.y_px));
    };
    const Rgb roof = colour_at(10.5, 10.5, 8.0);
    const Rgb ground = colour_at(4.5, 4.5, 0.0);
    EXPECT_EQ(ground, height_colour(0.0));
    EXPECT_GT(roof.r, 2 * roof.b);
    // Half way up, the west side has the colour of half the height, in its own light.
    const Rgb side = colour_at(10.5, 10.0, 4.0);
    EXPECT_GT(side.g, side.r);
    EXPECT_GT(side.g, side.b);
    EXPECT_EQ(canvas.pixel(1, 1), paper_colour);
}

TEST(BlockRaster, LeavesNoCracksBetweenTiles) {
    const int side = 150; // about one sample and a half a tile
    const TileGrid tiles(flat_ground(side), everything, 1000);
    const GroundPlan plan{0.0, side, 0.0, side};
    const SceneBox box{plan, -1.0, 1.0, 1.0};
    const PerspectiveView view(box, picture_frame(640, 480), 215.0, 35.0);
    BlockRaster raster(640, 480, 1);
    fill_blocks(raster, tiles, view, box);
    int looked_at = 0;
    for (double north_m = 1.0; north_m < side - 1; north_m += 0.37) {
        for (double east_m = 1.0; east_m < side - 1; east_m += 0.37) {
            SeenPoint below = view.project(north_m, east_m, 0.0);
            below.inverse_depth *= 0.9;
            ASSERT_TRUE(raster.hides(below)) << north_m << ", " << east_m;
            ++looked_at;
        }
    }
    EXPECT_GT(looked_at, 100000);
}

} // namespace
} // namespace zonegrid
