#include "io/generated_flight.h"

#include "io/flight_writer.h"
#include "io/map_comparison.h"
#include "io/replay.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace zonegrid {
namespace {

void ignore(const ReplaySummary& /*so_far*/) {}

/// Bit for bit; what is missing may be written as NaN, 0 or a negative number.
void expect_same_frame(const FrameData& written, const FrameData& read) {
    ASSERT_EQ(written.depth_m.size(), read.depth_m.size());
    for (std::size_t i = 0; i < written.depth_m.size(); ++i) {
        const bool missing = !(written.depth_m[i] > 0.0F);
        EXPECT_EQ(missing, !(read.depth_m[i] > 0.0F));
        EXPECT_TRUE(missing || written.depth_m[i] == read.depth_m[i]) << i;
    }
    ASSERT_EQ(written.ends_m.size(), read.ends_m.size());
    for (std::size_t i = 0; i < written.ends_m.size(); ++i) {
        EXPECT_TRUE(written.ends_m[i] == read.ends_m[i] || !written.ends_m[i].allFinite()) << i;
    }
}

void expect_same_camera(const Camera& written, const Camera& read) {
    EXPECT_EQ(written.width_px, read.width_px);
    EXPECT_EQ(written.height_px, read.height_px);
    EXPECT_EQ(written.fx_px, read.fx_px);
    EXPECT_EQ(written.fy_px, read.fy_px);
    EXPECT_EQ(written.cx_px, read.cx_px);
    EXPECT_EQ(written.cy_px, read.cy_px);
    EXPECT_EQ(written.directions, read.directions);
    EXPECT_EQ(written.body_from_camera.matrix(), read.body_from_camera.matrix());
    ASSERT_EQ(written.stereo.has_value(), read.stereo.has_value());
    if (written.stereo) {
        EXPECT_EQ(written.stereo->baseline_m, read.stereo->baseline_m);
        EXPECT_EQ(written.stereo->disparity_sigma_px, read.stereo->disparity_sigma_px);
    }
}

TEST(GeneratedFlight, IsTheSameForTheSameSeedAndNumberOnly) {
    const auto steps = [](std::uint64_t seed, std::uint64_t number) {
        const GeneratedFlight flight(seed, number);
        return take_steps(flight, {}, {flight.options()}, 1, ignore);
    };
    EXPECT_EQ(steps(7, 3), steps(7, 3));
    EXPECT_NE(steps(7, 3), steps(7, 2));
    EXPECT_NE(steps(7, 3), steps(8, 3));
}

TEST(GeneratedFlight, GoesWhereKernelsErr) {
    constexpr std::uint64_t flights = 500;
    std::uint64_t scanners = 0;
    std::uint64_t tables = 0;
    std::uint64_t odd_sizes = 0;
    std::uint64_t spanned = 0;
    std::uint64_t returned = 0;
    std::uint64_t saturated = 0;
    std::uint64_t with_objects = 0;
    std::uint64_t skipped = 0;
    std::uint64_t on_cell_borders = 0;
    std::uint64_t on_zone_borders = 0;
    std::uint64_t missing = 0;
    std::uint64_t infinite = 0;
    for (std::uint64_t number = 0; number < flights; ++number) {
        const GeneratedFlight flight(1, number);
        const MapperOptions& options = flight.options();
        Mapper mapper(options, flight.camera());
        const ReplaySummary summary = replay(flight, {}, mapper, ignore);
        EXPECT_GE(summary.images, 4U);
        scanners += flight.camera() ? 0U : 1U;
        tables += flight.camera() && !flight.camera()->directions.empty() ? 1U : 0U;
        odd_sizes += flight.camera() && flight.camera()->width_px % 2 == 1 ? 1U : 0U;
        spanned += options.model == SensorModel::span ? 1U : 0U;
        returned += summary.zones_entered > 0 && summary.zones_left > 0 ? 1U : 0U;
        with_objects += mapper.objects().empty() ? 0U : 1U;
        skipped += summary.images - summary.integrated;
        bool at_limit = false;
        mapper.for_each_cell([&](const CellIndex& /*cell*/, int value) {
            at_limit = at_limit || std::abs(value) == options.limit;
        });
        saturated += at_limit ? 1U : 0U;
        for (const NavigationSample& sample : flight.navigation()) {
            const Eigen::Vector3d cells = sample.position_m / options.cell_m;
            const Eigen::Vector3d zones = cells / options.zone;
            on_cell_borders += (cells.array() == cells.array().round()).any() ? 1U : 0U;
            on_zone_borders += (zones.array() == zones.array().round()).any() ? 1U : 0U;
        }
        for (std::size_t i = 0; i < flight.frames().size(); ++i) {
            for (const float depth_m : flight.read_frame(i).depth_m) {
                missing += depth_m > 0.0F ? 0U : 1U;
                infinite += std::isinf(depth_m) && depth_m > 0.0F ? 1U : 0U;
            }
        }
    }
    EXPECT_EQ(scanners, flights / 5);
    EXPECT_GT(tables, 40U);
    EXPECT_GT(odd_sizes, 200U);
    EXPECT_GT(spanned, 200U);
    EXPECT_GT(returned, 50U);
    EXPECT_GT(saturated, 200U);
    EXPECT_GT(with_objects, 200U);
    EXPECT_GT(skipped, 10U);
    EXPECT_LT(skipped, 200U);
    EXPECT_GT(on_cell_borders, 1000U);
    EXPECT_GT(on_zone_borders, 500U);
    EXPECT_GT(missing, 10000U);
    EXPECT_GT(infinite, 10000U);
}

TEST(GeneratedFlight, ComesBackExactlyFromItsFolder) {
    std::uint64_t tables = 0;
    for (std::uint64_t number = 0; number < 100; ++number) {
        SCOPED_TRACE(number);
        const GeneratedFlight flight(2, number);
        const testing::TemporaryFolder folder;
        write_flight(folder.path(), flight);
        const auto read = open_recording(folder.path());
        ASSERT_EQ(flight.camera().has_value(), read->camera().has_value());
        if (flight.camera()) {
            expect_same_camera(*flight.camera(), *read->camera());
            tables += flight.camera()->directions.empty() ? 0U : 1U;
        } else {
            EXPECT_EQ(flight.body_from_sensor().matrix(), read->body_from_sensor().matrix());
        }
        ASSERT_EQ(flight.navigation().size(), read->navigation().size());
        for (std::size_t i = 0; i < flight.navigation().size(); ++i) {
            const NavigationSample& sample = flight.navigation()[i];
            const NavigationSample& other = read->navigation()[i];
            EXPECT_EQ(sample.time_s, other.time_s);
            EXPECT_EQ(sample.position_m, other.position_m);
            EXPECT_EQ(sample.velocity_mps, other.velocity_mps);
            EXPECT_EQ(sample.acceleration_mps2, other.acceleration_mps2);
            EXPECT_EQ(sample.world_from_body.coeffs(), other.world_from_body.coeffs());
            EXPECT_EQ(sample.body_rate_radps, other.body_rate_radps);
        }
        ASSERT_EQ(flight.frames().size(), read->frames().size());
        for (std::size_t i = 0; i < flight.frames().size(); ++i) {
            EXPECT_EQ(flight.frames()[i].time_s, read->frames()[i].time_s);
            expect_same_frame(flight.read_frame(i), read->read_frame(i));
        }
        EXPECT_EQ(take_steps(flight, {}, {flight.options()}, 1, ignore),
                  take_steps(*read, {}, {flight.options()}, 1, ignore));
    }
    EXPECT_GT(tables, 8U);
}

} // namespace
} // namespace zonegrid
