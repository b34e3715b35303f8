#include "reference/integrate_image.h"

#include "model/window.h"
#include "support/oracle_compare.h"
#include "support/oracle_scenes.h"
#include "support/statements.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace zonegrid {
namespace {

using oracle::CellValues;
using oracle::Picture;
using oracle::Random;

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
constexpr float sky = std::numeric_limits<float>::infinity();
constexpr int free_cell = ZG_STATEMENT_FREE;
constexpr int occupied_cell = ZG_STATEMENT_OCCUPIED;

/// World cells and their statements, by the library.
CellValues integrated(const Camera& camera, const MapperOptions& options,
                      const Eigen::Isometry3d& world_from_camera,
                      const std::vector<float>& depth_m) {
    Window window = make_window(options, camera);
    window.move_to(cell_of(world_from_camera.translation(), options.cell_m).value());
    ImageRays rays;
    ImageQuantizer(camera, options).quantize(depth_m, world_from_camera, window, rays);
    LocalMap map(window);
    reference::integrate_image(rays, map);
    return statements_of(map);
}

/// A camera of one row that looks north from the middle of cell (0, 0, 0).
struct Worked {
    Camera camera;
    MapperOptions options;
    Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();

    explicit Worked(int width_px) {
        camera.width_px = width_px;
        camera.height_px = 1;
        camera.fx_px = 100.0;
        camera.fy_px = 100.0;
        options.range_m = 10.0;
        world_from_camera.linear() = body_from_forward_camera();
        world_from_camera.translation() = Eigen::Vector3d(0.5, 0.5, 0.5);
    }

    [[nodiscard]] CellValues operator()(const std::vector<float>& depth_m) const {
        return integrated(camera, options, world_from_camera, depth_m);
    }
};

/// Cells (first .. last, 0, 0) with one statement.
CellValues north(int first, int last, int statement) {
    CellValues values;
    for (int x = first; x <= last; ++x) {
        values[{x, 0, 0}] = statement;
    }
    return values;
}

TEST(IntegrateImage, LineFreesUpToTheObstacle) {
    const Worked image(1);
    // 0.5 m + 5 m is in cell 5.
    CellValues expected = north(0, 4, free_cell);
    expected[{5, 0, 0}] = occupied_cell;
    EXPECT_EQ(image({5.0F}), expected);
}

TEST(IntegrateImage, MissingSaysNothing) {
    const Worked image(1);
    EXPECT_TRUE(image({missing}).empty());
    EXPECT_TRUE(image({0.0F}).empty());
    EXPECT_TRUE(image({-3.0F}).empty());
    EXPECT_TRUE(image({-sky}).empty());
}

TEST(IntegrateImage, InfiniteAndBeyondRangeFreeToTheRange) {
    const Worked image(1);
    const CellValues expected = north(0, 10, free_cell); // 0.5 m + 10 m
    EXPECT_EQ(image({sky}), expected);
    EXPECT_EQ(image({11.0F}), expected);
    EXPECT_EQ(image({std::numeric_limits<float>::max()}), expected);
    // The range's end belongs to it, half a sub-cell more (rounded up) does not.
    CellValues with_obstacle = expected;
    with_obstacle[{10, 0, 0}] = occupied_cell;
    EXPECT_EQ(image({10.0F}), with_obstacle);
    EXPECT_EQ(image({10.0F + 0.49F / 256.0F}), with_obstacle);
    EXPECT_EQ(image({10.0F + 0.5F / 256.0F}), expected);
}

TEST(IntegrateImage, ShortestDepthOccupiesTheCamerasCell) {
    const Worked image(1);
    EXPECT_EQ(image({std::numeric_limits<float>::denorm_min()}),
              (CellValues{{{0, 0, 0}, occupied_cell}}));
}

TEST(IntegrateImage, OccupiedBeatsFreeWhateverTheOrder) {
    Worked image(2); // both pixels in the row of cells (x, 0, 0) up to the range
    CellValues expected = north(0, 8, free_cell);
    expected[{3, 0, 0}] = occupied_cell;
    expected[{8, 0, 0}] = occupied_cell;
    EXPECT_EQ(image({3.0F, 8.0F}), expected);
    EXPECT_EQ(image({8.0F, 3.0F}), expected);
}

TEST(IntegrateImage, SpanSpreadsTheObstacleByStereoNoise) {
    Worked image(1);
    image.options.model = SensorModel::span;
    image.camera.stereo = StereoNoise{0.5, 0.5};
    // sigma = 8^2 * 0.5 / (100 * 0.5) = 0.64 m: 0.5 + 8 +- 0.64 m, cells 7 to 9.
    CellValues expected = north(0, 6, free_cell);
    expected.merge(north(7, 9, occupied_cell));
    EXPECT_EQ(image({8.0F}), expected);
    // Cut off at the range: cells 8 to 10.
    image.options.span_sigmas = 2.0;
    expected = north(0, 7, free_cell);
    expected.merge(north(8, 10, occupied_cell));
    EXPECT_EQ(image({9.5F}), expected);
    // Cut off at the camera.
    image.options.span_sigmas = 100.0;
    EXPECT_EQ(image({9.5F}), north(0, 10, occupied_cell));
}

TEST(IntegrateImage, SpanFillsThePixelsPyramid) {
    Worked image(1);
    image.options.model = SensorModel::span;
    image.camera.fx_px = 2.0; // at 7 m the pixel is 3.5 m wide
    image.camera.fy_px = 2.0;
    const CellValues cells = image({7.0F});
    for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
            EXPECT_EQ(cells.at({7, y, z}), occupied_cell) << y << ' ' << z;
        }
    }
    EXPECT_FALSE(cells.contains({7, 3, 0}));
}

TEST(IntegrateImage, TiesGoToZThenY) {
    Worked image(3); // rays to the left, ahead and to the right, at 45 degrees
    image.camera.fx_px = 1.0;
    image.camera.cx_px = 1.0;
    // To the right: x and y meet their borders together, y is crossed first.
    CellValues expected{{{0, 0, 0}, free_cell},
                        {{0, 1, 0}, free_cell},
                        {{1, 1, 0}, free_cell},
                        {{1, 2, 0}, free_cell},
                        {{2, 2, 0}, occupied_cell}};
    EXPECT_EQ(image({missing, missing, 2.0F}), expected);
    // To the left as well, from the same place in the cell seen the other way round.
    image.world_from_camera.translation().y() = 0.5 - 1.0 / 256.0;
    expected = {{{0, 0, 0}, free_cell},
                {{0, -1, 0}, free_cell},
                {{1, -1, 0}, free_cell},
                {{1, -2, 0}, free_cell},
                {{2, -2, 0}, occupied_cell}};
    EXPECT_EQ(image({2.0F, missing, missing}), expected);
    // Up, by a camera that lies on its side: z is crossed before y and x.
    image.world_from_camera.translation().y() = 0.5;
    image.world_from_camera.linear().col(0) = Eigen::Vector3d::UnitZ();
    image.world_from_camera.linear().col(1) = -Eigen::Vector3d::UnitY();
    expected = {{{0, 0, 0}, free_cell}, {{0, 0, 1}, free_cell}, {{1, 0, 1}, occupied_cell}};
    EXPECT_EQ(image({missing, missing, 1.0F}), expected);
}

TEST(IntegrateImage, EqualsTheOracle) {
    constexpr std::uint64_t first_seed = 1000;
    constexpr std::uint64_t images = 1200;
    std::uint64_t compared = 0;
    std::uint64_t occupied = 0;
    for (std::uint64_t seed = first_seed; seed < first_seed + images; ++seed, ++compared) {
        Random random(seed);
        const Camera camera = oracle::random_camera(random);
        const MapperOptions options = oracle::random_options(random, 12.0);
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() =
            (oracle::random_attitude(random).toRotationMatrix() * camera.body_from_camera.linear())
                .eval();
        pose.translation() = oracle::random_position(random, options.cell_m, 5000.0);
        const auto picture = static_cast<Picture>(seed % oracle::picture_kinds);
        const auto depths = oracle::random_depths(random, camera, options, picture);

        const auto expected = oracle::as_values(
            oracle::image_local_map(camera, options, oracle::pose_of(pose), depths).cells);
        ASSERT_EQ(
            oracle::difference(expected, integrated(camera, options, pose, depths), options.zone),
            "")
            << "seed " << seed;
        for (const auto& [cell, statement] : expected) {
            occupied += statement == occupied_cell ? 1 : 0;
        }
    }
    EXPECT_EQ(compared, images);
    EXPECT_GT(occupied, 10000U);
}

TEST(IntegrateImage, EqualsTheOracleInTheLargestWindow) {
    std::uint64_t compared = 0;
    for (std::uint64_t seed = 1; seed <= 16; ++seed, ++compared) {
        Random random(seed);
        Camera camera;
        camera.width_px = 2;
        camera.height_px = 1;
        camera.fx_px = random.real(2.0, 300.0);
        camera.fy_px = random.real(2.0, 300.0);
        camera.cx_px = 1.0;
        MapperOptions options;
        options.cell_m = 0.05;
        const double stretch = 1.0 + 0.5 / camera.fx_px + 0.5 / camera.fy_px;
        options.range_m =
            988.0 * options.cell_m / stretch; // reach 990: 2048 cells with zones of 32
        options.zone = 32;
        options.model = camera.fx_px > 150.0 ? SensorModel::span : SensorModel::line;
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = oracle::random_attitude(random).toRotationMatrix();
        pose.translation() = oracle::random_position(random, options.cell_m, 100000.0);
        const auto depths =
            oracle::random_depths(random, camera, options, static_cast<Picture>(3 + seed % 4));
        ASSERT_GE(make_window(options, camera).edge_cells(), 2016);
        const auto expected = oracle::as_values(
            oracle::image_local_map(camera, options, oracle::pose_of(pose), depths).cells);
        ASSERT_EQ(
            oracle::difference(expected, integrated(camera, options, pose, depths), options.zone),
            "")
            << "seed " << seed;
    }
    EXPECT_EQ(compared, 16U);
}

} // namespace
} // namespace zonegrid
