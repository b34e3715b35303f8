#include "support/oracle_compare.h"
#include "support/oracle_mapper.h"
#include "support/oracle_scenes.h"
#include "zonegrid/mapper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

// Whole flights: every image through the Mapper and through the oracle, compared cell by cell.

namespace zonegrid {
namespace {

using oracle::CellValues;
using oracle::OracleMapper;
using oracle::Random;

CellValues cells_of(const Mapper& mapper) {
    CellValues values;
    mapper.for_each_cell([&](const CellIndex& cell, int value) { values[cell] = value; });
    return values;
}

/// The text under `digest.cells` in the order in which the mapper visits.
std::string visited_text(const Mapper& mapper) {
    std::string text;
    mapper.for_each_cell([&](const CellIndex& cell, int value) {
        text += std::to_string(cell.x) + ' ' + std::to_string(cell.y) + ' ' +
                std::to_string(cell.z) + ' ' + std::to_string(value) + '\n';
    });
    return text;
}

/// What a set of flights went through; a flight that meets nothing tests nothing.
struct Seen {
    std::uint64_t images = 0;
    std::uint64_t scans = 0;
    std::uint64_t skipped = 0;
    std::uint64_t entered = 0;
    std::uint64_t left = 0;
    std::uint64_t at_upper_limit = 0;
    std::uint64_t at_lower_limit = 0;
    std::uint64_t objects = 0;
    std::uint64_t large_objects = 0; ///< more cells than a zone has
    std::uint64_t across_edge = 0;   ///< occupied in the window and remembered outside it
    std::uint64_t partly_seen = 0;   ///< occupied, and spared by an image that says free
    std::uint64_t wholly_seen = 0;   ///< occupied, and denied by one
};

/// A mapper and its oracle that get the same calls.
class Pair {
public:
    Pair(const MapperOptions& options, const std::optional<Camera>& camera, Seen& seen)
        : options_(options), mapper_(options, camera), oracle_(options, camera), seen_(seen) {}

    void add_navigation(const NavigationSample& sample) {
        mapper_.add_navigation(sample);
        oracle_.add_navigation(sample);
    }

    void add_image(const DepthImage& image) {
        ++seen_.images;
        expect_equal(mapper_.add_image(image), oracle_.add_image(image));
    }

    void add_scan(const Scan& scan) {
        ++seen_.scans;
        expect_equal(mapper_.add_scan(scan), oracle_.add_scan(scan));
    }

    void compare_cells() {
        ASSERT_EQ(oracle::difference(oracle_.values(), cells_of(mapper_), options_.zone), "");
    }

    void compare_objects() {
        const auto objects = mapper_.objects();
        const auto expected = oracle_.objects();
        ASSERT_EQ(oracle::objects_text(objects), oracle::objects_text(expected));
        seen_.objects += objects.size();
        for (const Object& object : objects) {
            const auto zone = static_cast<std::uint64_t>(options_.zone);
            seen_.large_objects += object.cell_count > zone * zone ? 1U : 0U;
            const auto inside = [&](const CellIndex& cell) { return oracle_.window().holds(cell); };
            seen_.across_edge += inside(object.box_min) != inside(object.box_max) ? 1U : 0U;
        }
    }

    void compare_everything() {
        ASSERT_NO_FATAL_FAILURE(compare_cells());
        ASSERT_EQ(visited_text(mapper_), oracle::cells_text(oracle_.values()));
        ASSERT_NO_FATAL_FAILURE(compare_objects());
        ASSERT_EQ(mapper_.height_profile().columns, oracle_.height_profile());
        for (const double cut_m : {0.0, 1.0, -3.5 * options_.cell_m}) {
            ASSERT_EQ(mapper_.height_profile(cut_m).columns, oracle_.height_profile(cut_m));
        }
        compare_statistics();
        seen_.partly_seen += oracle_.partly_seen();
        seen_.wholly_seen += oracle_.wholly_seen();
    }

private:
    void expect_equal(const ImageResult& actual, const ImageResult& expected) {
        ASSERT_EQ(static_cast<int>(actual.status), static_cast<int>(expected.status));
        if (actual.status != ImageStatus::integrated) {
            ++seen_.skipped;
            return;
        }
        ASSERT_TRUE(actual.world_from_sensor.matrix() == expected.world_from_sensor.matrix())
            << actual.world_from_sensor.matrix() << "\nexpected\n"
            << expected.world_from_sensor.matrix();
        ASSERT_EQ(actual.missing, expected.missing);
        ASSERT_EQ(actual.dropped, expected.dropped);
        ASSERT_EQ(actual.cells_changed, expected.cells_changed);
        seen_.entered += actual.zones_entered;
        seen_.left += actual.zones_left;
    }

    void compare_statistics() {
        const MapStatistics statistics = mapper_.statistics();
        ASSERT_EQ(statistics.window_cells, oracle_.window().edge);
        ASSERT_EQ(statistics.window_first_cell.x, oracle_.window().first[0]);
        ASSERT_EQ(statistics.window_first_cell.y, oracle_.window().first[1]);
        ASSERT_EQ(statistics.window_first_cell.z, oracle_.window().first[2]);
        std::set<std::vector<double>> zones;
        for (const CellIndex& cell : oracle_.remembered()) {
            const auto zone = [&](std::int32_t c) {
                return std::floor(static_cast<double>(c) / options_.zone);
            };
            zones.insert({zone(cell.x), zone(cell.y), zone(cell.z)});
        }
        ASSERT_EQ(statistics.zones_remembered, zones.size());
        std::uint64_t occupied = 0;
        std::uint64_t free = 0;
        for (const auto& [cell, value] : oracle_.values()) {
            occupied += value >= options_.threshold ? 1U : 0U;
            free += value < 0 ? 1U : 0U;
            seen_.at_upper_limit += value == options_.limit ? 1U : 0U;
            seen_.at_lower_limit += value == -options_.limit ? 1U : 0U;
        }
        ASSERT_EQ(statistics.cells_occupied, occupied);
        ASSERT_EQ(statistics.cells_free, free);
    }

    MapperOptions options_;
    Mapper mapper_;
    OracleMapper oracle_;
    Seen& seen_;
};

/// A building of square rooms without a ceiling: depth of every pixel to the next wall or the
/// ground, rounded to float, with some missing.
std::vector<float> depths_of_rooms(Random& random, const Camera& camera,
                                   const Eigen::Isometry3d& world_from_camera, double room_m) {
    std::vector<float> depths;
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            const Eigen::Vector3d direction =
                world_from_camera.linear() * Eigen::Vector3d((u - camera.cx_px) / camera.fx_px,
                                                             (v - camera.cy_px) / camera.fy_px,
                                                             1.0);
            double depth_m = std::numeric_limits<double>::infinity();
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                const double here_m = world_from_camera.translation()[axis];
                const double behind_m = std::floor(here_m / room_m) * room_m;
                const double wall_m = direction[axis] > 0.0 ? behind_m + room_m : behind_m;
                const double at = ((axis < 2 ? wall_m : 0.3 * room_m) - here_m) / direction[axis];
                if (at > 0.0) {
                    depth_m = std::min(depth_m, at);
                }
            }
            depths.push_back(random.chance(0.05) ? std::numeric_limits<float>::quiet_NaN()
                                                 : static_cast<float>(depth_m));
        }
    }
    return depths;
}

/// A vehicle that wanders through several windows, hovers, turns back, and jumps now and then.
class Vehicle {
public:
    Vehicle(Random& random, const MapperOptions& options) : random_(random), options_(options) {}

    /// The next sample, `dt_s` after the last one.
    NavigationSample next(double dt_s) {
        const double window_m = 2.0 * options_.range_m + 2.0 * options_.zone * options_.cell_m;
        const double leg_m = 1.5 * window_m;
        if (random_.chance(0.15)) {
            target_m_ = {random_.real(-leg_m, leg_m), random_.real(-leg_m, leg_m),
                         random_.real(-0.3 * leg_m, 0.3 * leg_m)};
        }
        if (random_.chance(0.25)) {
            target_m_ = Eigen::Vector3d::Zero();
        }
        const Eigen::Vector3d way = target_m_ - sample_.position_m;
        const double step_m = random_.chance(0.1) ? 2.0 * window_m : 0.3 * window_m;
        sample_.time_s += dt_s;
        if (way.norm() > 1e-3) {
            sample_.position_m += way * std::min(1.0, step_m / way.norm());
        }
        const auto vector = [&](double most) {
            return Eigen::Vector3d{random_.real(-most, most), random_.real(-most, most),
                                   random_.real(-most, most)};
        };
        if (random_.chance(0.7)) {
            sample_.world_from_body = oracle::random_attitude(random_);
        }
        sample_.velocity_mps = vector(5.0 * options_.cell_m);
        sample_.acceleration_mps2 = vector(5.0 * options_.cell_m);
        sample_.body_rate_radps = random_.chance(0.2) ? Eigen::Vector3d::Zero() : vector(2.0);
        return sample_;
    }

    [[nodiscard]] const NavigationSample& last() const { return sample_; }

private:
    Random& random_;
    const MapperOptions& options_;
    NavigationSample sample_;
    Eigen::Vector3d target_m_ = Eigen::Vector3d::Zero();
};

/// One step of a flight: a sample, and an image or a scan, or both, somewhere around it.
void fly_step(Random& random, Vehicle& vehicle, Pair& pair, const Camera& camera,
              const MapperOptions& options) {
    pair.add_navigation(vehicle.next(random.chance(0.2) ? 0.2 : 0.04));
    const NavigationSample& sample = vehicle.last();
    double time_s = sample.time_s;
    if (random.chance(0.7)) {
        time_s += random.real(-0.06, 0.06); // out of order now and then, or too far from a sample
    }
    if (random.chance(0.25)) {
        std::vector<Eigen::Vector3f> ends;
        for (int n = random.pick(0, 40); n > 0; --n) {
            const auto far_m = static_cast<float>(1.3 * options.range_m);
            const float x_m = random.real(-far_m, far_m);
            const float y_m = random.real(-far_m, far_m);
            ends.emplace_back(x_m, y_m, random.real(-far_m, far_m));
        }
        Scan scan;
        scan.time_s = time_s;
        scan.ends_m = ends;
        scan.body_from_sensor.translation() = Eigen::Vector3d(0.1, -0.2, 0.3);
        ASSERT_NO_FATAL_FAILURE(pair.add_scan(scan));
        time_s += 1e-3;
    }
    Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();
    world_from_body.linear() = sample.world_from_body.toRotationMatrix();
    world_from_body.translation() = sample.position_m;
    const auto depths =
        random.chance(0.6)
            ? depths_of_rooms(random, camera, world_from_body * camera.body_from_camera,
                              1.3 * options.range_m)
            : oracle::random_depths(
                  random, camera, options,
                  static_cast<oracle::Picture>(random.pick(0, oracle::picture_kinds - 1)));
    ASSERT_NO_FATAL_FAILURE(pair.add_image({time_s, depths}));
}

void fly(std::uint64_t seed, int steps, Seen& seen) {
    Random random(seed);
    const Camera camera = oracle::random_camera(random);
    const MapperOptions options = oracle::random_options(random, 9.0);
    Vehicle vehicle(random, options);
    Pair pair(options, camera, seen);
    for (int step = 0; step < steps; ++step) {
        ASSERT_NO_FATAL_FAILURE(fly_step(random, vehicle, pair, camera, options))
            << "step " << step;
        ASSERT_NO_FATAL_FAILURE(pair.compare_cells()) << "step " << step;
        if (random.chance(0.2)) { // at any time: pieces kept from before must not be stale
            ASSERT_NO_FATAL_FAILURE(pair.compare_objects()) << "step " << step;
        }
    }
    pair.compare_everything();
}

/// Images from within what a scan filled: of every cell they say free they decide whether they see
/// all of it, at places where corners of cells lie on the view's borders.
void fly_through_filled_cells(std::uint64_t seed, int steps, Seen& seen) {
    Random random(seed);
    const Camera camera = oracle::seeing_camera(random);
    const MapperOptions options = oracle::seeing_options(random);
    const auto ends = oracle::filling_ends(options);
    Pair pair(options, camera, seen);
    NavigationSample sample;
    for (int step = 0; step < steps; ++step) {
        sample.time_s += 0.1;
        sample.position_m = oracle::seeing_position(random, options.cell_m, 40);
        sample.world_from_body = oracle::random_attitude(random);
        pair.add_navigation(sample);
        Scan scan;
        scan.time_s = sample.time_s - 1e-3;
        scan.body_from_sensor = camera.body_from_camera;
        scan.ends_m = ends;
        ASSERT_NO_FATAL_FAILURE(pair.add_scan(scan)) << "step " << step;
        const auto depths = oracle::framed_depths(random, camera, options);
        ASSERT_NO_FATAL_FAILURE(pair.add_image({sample.time_s, depths})) << "step " << step;
        ASSERT_NO_FATAL_FAILURE(pair.compare_cells()) << "step " << step;
    }
    pair.compare_everything();
}

TEST(OracleFlight, MapperEqualsTheOracle) {
    constexpr std::uint64_t flights = 80;
    constexpr int steps = 60;
    Seen seen;
    for (std::uint64_t seed = 1; seed <= flights; ++seed) {
        ASSERT_NO_FATAL_FAILURE(fly(seed, steps, seen)) << "seed " << seed;
    }
    EXPECT_EQ(seen.images, flights * steps);
    EXPECT_GT(seen.scans, 500U);
    EXPECT_GT(seen.skipped, 300U);
    EXPECT_GT(seen.entered, 400U);
    EXPECT_GT(seen.left, 2000U);
    EXPECT_GT(seen.at_upper_limit, 1000U);
    EXPECT_GT(seen.at_lower_limit, 1000U);
    EXPECT_GT(seen.objects, 5000U);
    EXPECT_GT(seen.large_objects, 50U);
    EXPECT_GT(seen.across_edge, 100U);
    EXPECT_GT(seen.partly_seen, 10000U);
    EXPECT_GT(seen.wholly_seen, 1000U);
}

TEST(OracleFlight, ImagesDenyOnlyWhatTheySeeWhole) {
    constexpr std::uint64_t flights = 80;
    constexpr int steps = 10;
    Seen seen;
    for (std::uint64_t seed = 1; seed <= flights; ++seed) {
        ASSERT_NO_FATAL_FAILURE(fly_through_filled_cells(seed, steps, seen)) << "seed " << seed;
    }
    EXPECT_EQ(seen.skipped, 0U);
    EXPECT_GT(seen.partly_seen, 30000U);
    EXPECT_GT(seen.wholly_seen, 5000U);
}

} // namespace
} // namespace zonegrid
