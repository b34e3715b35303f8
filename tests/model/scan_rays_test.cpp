#include "model/rays.h"

#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

// docs/model.md, section 3, "Scans".

namespace zonegrid {
namespace {

using Eigen::Vector3f;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Cells of 1 m, range 10 m: reach 12 cells, zones of 8, window -16 .. 31 around the origin.
MapperOptions short_range() {
    MapperOptions options;
    options.range_m = 10.0;
    options.zone = 8;
    return options;
}

ScanRays quantize(const std::vector<Vector3f>& ends_m, const std::vector<Vector3f>& starts_m = {},
                  const Eigen::Isometry3d& world_from_sensor = Eigen::Isometry3d::Identity()) {
    const MapperOptions options = short_range();
    Window window = make_window(options, {});
    window.move_to({0, 0, 0});
    Scan scan;
    scan.ends_m = ends_m;
    scan.starts_m = starts_m;
    return quantize_scan(scan, world_from_sensor, options, window);
}

constexpr std::int32_t origin = 16 * 256;

TEST(ScanRays, HitsUpToTheRangeFreeBeyondIt) {
    const auto scan = quantize({{10.0F, 0.0F, 0.0F}, {0.0F, -20.0F, 0.0F}, {0.0F, 0.0F, 10.001F}});
    ASSERT_EQ(scan.rays.size(), 3U);
    EXPECT_EQ(scan.rays[0].start, (SubPoint{origin, origin, origin}));
    EXPECT_EQ(scan.rays[0].end, (SubPoint{origin + 2560, origin, origin}));
    EXPECT_TRUE(scan.rays[0].hit);
    EXPECT_EQ(scan.rays[1].end, (SubPoint{origin, origin - 2560, origin}));
    EXPECT_FALSE(scan.rays[1].hit);
    EXPECT_FALSE(scan.rays[2].hit);
}

TEST(ScanRays, MissingEnds) {
    const auto scan = quantize(
        {{nan, 0.0F, 0.0F}, {0.0F, infinity, 0.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}});
    EXPECT_EQ(scan.missing, 3U);
    EXPECT_EQ(scan.rays.size(), 1U);
    EXPECT_EQ(scan.dropped, 0U);
}

TEST(ScanRays, OwnStartsAndRaysOutsideTheWindow) {
    const auto scan = quantize({{1.0F, 0.0F, 0.0F}, {35.0F, 0.0F, 0.0F}, {-16.5F, 0.0F, 0.0F}},
                               {{2.0F, 0.0F, 0.0F}, {30.0F, 0.0F, 0.0F}, {-15.0F, 0.0F, 0.0F}});
    ASSERT_EQ(scan.rays.size(), 1U);
    EXPECT_EQ(scan.rays[0].start.x, origin + 512);
    EXPECT_EQ(scan.rays[0].end.x, origin + 256);
    EXPECT_EQ(scan.dropped, 2U);
    EXPECT_EQ(quantize({{1.0F, 0.0F, 0.0F}}, {{nan, 0.0F, 0.0F}}).missing, 1U);
}

TEST(ScanRays, PointsTurnWithTheSensor) {
    Eigen::Isometry3d world_from_sensor = Eigen::Isometry3d::Identity();
    world_from_sensor.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1; // yaw 90 degrees, exact
    world_from_sensor.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
    const auto scan = quantize({{4.0F, 0.5F, 0.25F}}, {}, world_from_sensor);
    EXPECT_EQ(scan.rays.at(0).start, (SubPoint{origin + 256, origin + 512, origin + 768}));
    EXPECT_EQ(scan.rays.at(0).end,
              (SubPoint{origin + 128, origin + 6 * 256, origin + 3 * 256 + 64}));
}

TEST(ScanRays, StartsMustMatchEnds) {
    try {
        const auto scan = quantize({{1.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}}, {{0.0F, 0.0F, 0.0F}});
        ADD_FAILURE() << "accepted with " << scan.rays.size() << " rays";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("1 starts for 2 ends; give one each or none"));
    }
}

} // namespace
} // namespace zonegrid
