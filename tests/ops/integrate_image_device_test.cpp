#include "ops/integrate_image.h"

#include "ops/reached_zones.h"
#include "reference/integrate_image.h"
#include "support/case_count.h"
#include "support/device_statements.h"
#include "support/each_device.h"
#include "support/oracle_scenes.h"
#include "support/statements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

// Every device draws the cells that the reference draws, no more and no fewer.

namespace zonegrid {
namespace {

using device::Device;
using ops::DeviceLocalMap;
using ops::IntegrateImage;
using oracle::Picture;
using oracle::Random;

/// One image taken both ways.
class ImagePair {
public:
    ImagePair(const Camera& camera, const MapperOptions& options, const Eigen::Isometry3d& pose,
              const std::vector<float>& depth_m)
        : window_(make_window(options, camera)) {
        window_.move_to(cell_of(pose.translation(), options.cell_m).value());
        ImageQuantizer(camera, options).quantize(depth_m, pose, window_, rays_);
    }

    [[nodiscard]] oracle::CellValues by_reference() const {
        LocalMap local_map(window_);
        reference::integrate_image(rays_, local_map);
        return statements_of(local_map);
    }

    [[nodiscard]] oracle::CellValues by_device(Device& device, IntegrateImage& operation) const {
        DeviceLocalMap local_map(device, window_);
        const auto places = ops::reached_zones(rays_, window_);
        local_map.reserve(places);
        operation.dispatch(rays_, local_map);
        local_map.check();
        return statements_of(local_map, places, window_);
    }

private:
    Window window_;
    ImageRays rays_;
};

ImagePair random_pair(std::uint64_t seed) {
    Random random(seed);
    const Camera camera = oracle::random_camera(random);
    const MapperOptions options = oracle::random_options(random, 20.0);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() =
        (oracle::random_attitude(random).toRotationMatrix() * camera.body_from_camera.linear())
            .eval();
    pose.translation() = oracle::random_position(random, options.cell_m, 5000.0);
    const auto picture = static_cast<Picture>(seed % oracle::picture_kinds);
    return {camera, options, pose, oracle::random_depths(random, camera, options, picture)};
}

/// What a flight sees: slanted planes with edges between them, noise, holes and sky. Larger images
/// and finer cells than `random_pair`, so that most cells are filled and few rays are walked whole.
ImagePair surface_pair(std::uint64_t seed) {
    Random random(seed);
    Camera camera;
    camera.width_px = random.pick(30, 200);
    camera.height_px = random.pick(20, 150);
    camera.fx_px = std::max(camera.width_px, camera.height_px) * random.real(0.4, 2.0);
    camera.fy_px = camera.fx_px * random.real(0.9, 1.1);
    camera.cx_px = camera.width_px * random.real(0.3, 0.7);
    camera.cy_px = camera.height_px * random.real(0.3, 0.7);
    camera.stereo = StereoNoise{0.3, 0.25};
    MapperOptions options;
    options.model = random.chance(0.4) ? SensorModel::span : SensorModel::line;
    options.zone = random.chance(0.5) ? 32 : random.chance(0.5) ? 16 : 8;
    options.range_m = random.real(3.0, 40.0);
    options.cell_m = options.range_m / random.real(5.0, 90.0);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = oracle::random_attitude(random).toRotationMatrix();
    pose.translation() = oracle::random_position(random, options.cell_m, 1000.0);

    struct Plane {
        double inverse_depth, right, down; // 1 / depth is linear in the image
    };
    std::vector<Plane> planes;
    for (int i = random.pick(1, 4); i > 0; --i) {
        planes.push_back({1.0 / random.real(0.1, 1.2) / options.range_m, random.real(-2.0, 2.0),
                          random.real(-2.0, 2.0)});
    }
    const double noise = random.chance(0.5) ? 0.0 : random.real(0.0, 0.05);
    const double holes = random.chance(0.5) ? 0.0 : random.real(0.0, 0.4);
    std::vector<float> depth_m;
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            double nearest = 0.0;
            for (const auto& plane : planes) {
                nearest =
                    std::max(nearest, plane.inverse_depth *
                                          (1.0 + plane.right * (1.0 * u / camera.width_px - 0.5) +
                                           plane.down * (1.0 * v / camera.height_px - 0.5)));
            }
            const double depth =
                nearest > 0.0 ? 1.0 / nearest : std::numeric_limits<double>::infinity();
            depth_m.push_back(
                random.chance(holes)
                    ? 0.0F
                    : static_cast<float>(depth * (1.0 + noise * random.real(-1.0, 1.0))));
        }
    }
    return {camera, options, pose, depth_m};
}

class IntegrateImageOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, IntegrateImageOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(IntegrateImageOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        const std::uint64_t count = case_count(2000);
        IntegrateImage wide(*device);
        IntegrateImage narrow(*device, 32);
        std::uint64_t compared = 0;
        std::uint64_t stated = 0;
        for (std::uint64_t seed = 1; seed <= count; ++seed, ++compared) {
            const ImagePair pair = random_pair(seed);
            const auto expected = pair.by_reference();
            ASSERT_EQ(oracle::difference(expected,
                                         pair.by_device(*device, seed % 2 == 0 ? wide : narrow), 8),
                      "")
                << "seed " << seed;
            stated += expected.size();
        }
        EXPECT_EQ(compared, count);
        EXPECT_TRUE(stated > 500000U || count < 2000) << stated;
    });
}

TEST_P(IntegrateImageOn, EqualsTheReferenceWhereCellsAreFilled) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        IntegrateImage operation(*device);
        const std::uint64_t count = case_count(400);
        std::uint64_t stated = 0;
        for (std::uint64_t seed = 1; seed <= count; ++seed) {
            const ImagePair pair = surface_pair(seed);
            const auto expected = pair.by_reference();
            ASSERT_EQ(oracle::difference(expected, pair.by_device(*device, operation), 8), "")
                << "seed " << seed;
            stated += expected.size();
        }
        EXPECT_TRUE(stated > 3000000U || count < 400) << stated;
    });
}

TEST_P(IntegrateImageOn, EqualsTheReferenceAtRealSizes) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        IntegrateImage operation(*device);
        for (const auto& [width_px, height_px] :
             std::vector<std::pair<int, int>>{{1, 1}, {13, 7}, {641, 479}, {1280, 720}}) {
            Random random(static_cast<std::uint64_t>(width_px));
            Camera camera;
            camera.width_px = width_px;
            camera.height_px = height_px;
            camera.fx_px = camera.fy_px = width_px;
            camera.cx_px = width_px / 2.0;
            camera.cy_px = height_px / 2.0;
            camera.stereo = StereoNoise{0.3, 0.25};
            MapperOptions options;
            options.cell_m = 0.5;
            options.range_m = 20.0;
            for (const auto model : {SensorModel::line, SensorModel::span}) {
                options.model = model;
                Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
                pose.linear() = oracle::random_attitude(random).toRotationMatrix();
                pose.translation() = oracle::random_position(random, options.cell_m, 100.0);
                const ImagePair pair(
                    camera, options, pose,
                    oracle::random_depths(random, camera, options, Picture::mixed));
                EXPECT_EQ(oracle::difference(pair.by_reference(),
                                             pair.by_device(*device, operation), options.zone),
                          "")
                    << width_px << " x " << height_px;
            }
        }
    });
}

TEST_P(IntegrateImageOn, WalksLongRaysOfPixelsThatAreSplitMost) {
    // 256 sub-rays a pixel of some 400 steps each: more than lavapipe lets an item go round in
    // loops.
    for_each_device([](const std::unique_ptr<Device>& device) {
        IntegrateImage operation(*device);
        Camera camera;
        camera.width_px = 3;
        camera.height_px = 2;
        camera.fx_px = camera.fy_px = 8.0;
        camera.cx_px = 1.0;
        camera.cy_px = 0.5;
        camera.stereo = StereoNoise{0.3, 0.01};
        MapperOptions options;
        options.cell_m = 0.05;
        options.range_m = 14.0;
        options.model = SensorModel::span;
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = Eigen::Quaterniond(0.9, 0.3, 0.2, 0.1).normalized().toRotationMatrix();
        const std::vector<float> depth_m{13.0F, 0.0F, std::numeric_limits<float>::infinity(),
                                         13.0F, 4.0F, 12.0F};
        const ImagePair pair(camera, options, pose, depth_m);
        EXPECT_EQ(oracle::difference(pair.by_reference(), pair.by_device(*device, operation),
                                     options.zone),
                  "");
    });
}

TEST_P(IntegrateImageOn, DrawsTheCameraCellOfRaysOfNoLength) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        IntegrateImage operation(*device);
        Window window(8, 5, 12);
        window.move_to({0, 0, 0});
        ImageRays rays;
        rays.width_px = rays.height_px = 5;
        rays.origin = {16 * ZG_SUB_PER_CELL, 16 * ZG_SUB_PER_CELL, 16 * ZG_SUB_PER_CELL};
        rays.a = {1 << ZG_DIRECTION_BITS, 0, 0};
        rays.u = {0, 1 << 24, 0};
        rays.v = {0, 0, 1 << 24};
        rays.depths.assign(25, {0, -1});
        const auto places = ops::reached_zones(rays, window);
        DeviceLocalMap local_map(*device, window);
        local_map.reserve(places);
        operation.dispatch(rays, local_map);
        local_map.check();
        const auto statements = statements_of(local_map, places, window);
        ASSERT_EQ(statements.size(), 1U);
        EXPECT_EQ(statements.begin()->second, ZG_STATEMENT_FREE);
    });
}

TEST_P(IntegrateImageOn, SaysSoIfAZoneWasNotReserved) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        IntegrateImage operation(*device);
        Window window(8, 5, 12);
        window.move_to({0, 0, 0});
        ImageRays rays;
        rays.width_px = rays.height_px = 1;
        rays.origin = {16 * ZG_SUB_PER_CELL, 16 * ZG_SUB_PER_CELL, 16 * ZG_SUB_PER_CELL};
        rays.a = {1 << ZG_DIRECTION_BITS, 0, 0};
        rays.depths = {{10 * ZG_SUB_PER_CELL, -1}};
        const auto places = ops::reached_zones(rays, window);
        ASSERT_GE(places.size(), 2U);
        DeviceLocalMap local_map(*device, window);
        local_map.reserve(std::span(places).first(0));
        operation.dispatch(rays, local_map);
        EXPECT_THROW(local_map.check(), std::logic_error);
    });
}

} // namespace
} // namespace zonegrid
