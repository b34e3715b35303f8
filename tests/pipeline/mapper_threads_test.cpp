#include "zonegrid/mapper.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace zonegrid {
namespace {

/// A short flight along a wall; returns the objects seen.
std::vector<Object> fly() {
    Camera camera;
    camera.width_px = 24;
    camera.height_px = 18;
    camera.fx_px = 20.0;
    camera.fy_px = 20.0;
    camera.cx_px = 11.5;
    camera.cy_px = 8.5;
    camera.body_from_camera.linear() = body_from_forward_camera();
    MapperOptions options;
    options.cell_m = 0.5;
    options.range_m = 12.0;
    options.zone = 8;
    Mapper mapper(options, camera);
    const std::vector<float> wall(24 * 18, 7.0F);
    std::vector<Object> objects;
    for (int i = 0; i < 30; ++i) {
        NavigationSample sample;
        sample.time_s = 0.1 * i;
        sample.position_m = {0.0, 1.5 * i, -3.0};
        mapper.add_navigation(sample);
        EXPECT_EQ(mapper.add_image({sample.time_s, wall}).status, ImageStatus::integrated);
        objects = mapper.objects();
    }
    return objects;
}

TEST(MapperThreads, MappersInSeveralThreadsDoNotMeet) {
    const auto alone = fly();
    ASSERT_FALSE(alone.empty());
    std::vector<std::vector<Object>> together(4);
    std::vector<std::thread> threads;
    for (auto& objects : together) {
        threads.emplace_back([&objects] { objects = fly(); });
    }
    for (auto& thread : threads) {
        thread.join();
    }
    for (const auto& objects : together) {
        EXPECT_EQ(objects, alone);
    }
}

} // namespace
} // namespace zonegrid
