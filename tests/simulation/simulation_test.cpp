#include "simulation/simulation.h"

#include "io/recording.h"
#include "support/temporary_folder.h"
#include "truth/ray_caster.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>

namespace zonegrid::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A wall across the way, 30 m ahead to the north, from 20 m west to 20 m east, 8 m high, and a
/// camera of 64 x 48 pixels that flies 6 m towards it, then turns a little.
Scene wall_scene() {
    Scene scene;
    scene.name = "wall";
    for (const auto& [east_m, down_m] : {std::pair{-20.0F, 0.0F}, std::pair{20.0F, 0.0F},
                                         std::pair{20.0F, -8.0F}, std::pair{-20.0F, -8.0F}}) {
        scene.surfaces.vertices_m.emplace_back(30.0F, east_m, down_m);
    }
    scene.surfaces.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.surfaces.obstacles = {{"wall", ObstacleKind::building, 0, 2, false}};
    scene.texture = {0.8};
    Waypoint start;
    start.position_m = {0.0, 0.0, -5.0};
    start.hold_s = 0.5;
    Waypoint end = start;
    end.position_m = {6.0, 1.0, -5.0};
    scene.route.waypoints = {start, end};
    scene.camera.width_px = 64;
    scene.camera.height_px = 48;
    scene.camera.fx_px = 67.0;
    scene.camera.fy_px = 66.0;
    scene.camera.cx_px = 31.5;
    scene.camera.cy_px = 23.5;
    scene.camera.stereo = StereoNoise{1.0, 0.25}; // the wall has a disparity of 2.2 pixels
    scene.camera.body_from_camera.linear() = body_from_forward_camera();
    scene.camera.body_from_camera.translation() = Eigen::Vector3d(0.5, 0.0, 0.2);
    scene.duration_s = 2.0;
    return scene;
}

using Files = std::map<std::string, std::string>;

/// All files of a simulation with their bytes.
class Simulated {
public:
    explicit Simulated(const SimulationOptions& options, const Scene& scene = wall_scene())
        : flight(fly(scene, options)) {
        write_simulation(folder_.path(), scene, options, flight);
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
            if (entry.is_regular_file()) {
                std::ifstream stream(entry.path(), std::ios::binary);
                files[entry.path().lexically_relative(folder_.path()).string()] = {
                    std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
            }
        }
    }

    [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

    SimulatedFlight flight;
    Files files;

private:
    TemporaryFolder folder_;
};

/// Names of the files that differ, with "depth" for all images. Folders have the same names.
std::set<std::string> differences(const Files& first, const Files& second) {
    std::set<std::string> names;
    for (const auto& [name, bytes] : first) {
        const auto other = second.find(name);
        if (other == second.end() || other->second != bytes) {
            names.insert(name.starts_with("depth/") ? "depth" : name);
        }
    }
    return names;
}

std::unique_ptr<Recording> open(const Simulated& simulated) {
    return open_recording(simulated.path());
}

TEST(Simulation, MakesARecordingAndItsTruth) {
    const Simulated simulated{SimulationOptions{}};
    const auto recording = open(simulated);
    const Truth truth = read_truth(simulated.path() / "truth");
    EXPECT_EQ(recording->layout(), "plain");
    EXPECT_TRUE(recording->warnings().empty());
    EXPECT_EQ(recording->camera()->width_px, 64);
    EXPECT_EQ(recording->camera()->fy_px, 66.0);
    EXPECT_FALSE(recording->camera()->stereo); // depth is exact
    EXPECT_TRUE(recording->camera()->body_from_camera.isApprox(wall_scene().camera.body_from_camera,
                                                               1e-12));
    EXPECT_NEAR(static_cast<double>(recording->frames().size()), 60.0, 1.0);
    EXPECT_NEAR(static_cast<double>(recording->navigation().size()), 200.0, 1.0);
    ASSERT_EQ(truth.images.size(), recording->frames().size());
    ASSERT_EQ(truth.navigation.size(), recording->navigation().size());
    EXPECT_EQ(recording->truth_digest(), digest_of_truth(simulated.path() / "truth"));
    EXPECT_EQ(truth.scene, "wall");
    EXPECT_EQ(truth.camera.stereo->baseline_m, 1.0);
    for (std::size_t i = 0; i < truth.navigation.size(); ++i) {
        const NavigationSample& said = recording->navigation()[i];
        EXPECT_EQ(said.time_s, truth.navigation[i].time_s);
        EXPECT_LT((said.position_m - truth.navigation[i].position_m).norm(), 1e-12);
        EXPECT_LT(said.world_from_body.angularDistance(truth.navigation[i].world_from_body), 1e-9);
    }
}

TEST(Simulation, SeesTheWallWhereItIs) {
    const Simulated simulated{SimulationOptions{}};
    const auto recording = open(simulated);
    const Truth truth = read_truth(simulated.path() / "truth");
    for (const std::size_t image : {std::size_t{0}, truth.images.size() - 1}) {
        const Eigen::Isometry3d& pose = truth.images[image].world_from_camera;
        const std::vector<float> depth_m = recording->read_frame(image).depth_m;
        int on_wall = 0;
        for (int v = 0; v < 48; ++v) {
            for (int u = 0; u < 64; ++u) {
                const Eigen::Vector3d step =
                    pose.linear() * Eigen::Vector3d((u - 31.5) / 67.0, (v - 23.5) / 66.0, 1.0);
                const double expected_m = (30.0 - pose.translation().x()) / step.x();
                const Eigen::Vector3d place = pose.translation() + expected_m * step;
                const float depth = depth_m[static_cast<std::size_t>(64 * v + u)];
                if (std::abs(place.y()) < 19.9 && place.z() > -7.9 && place.z() < -0.1) {
                    ASSERT_NEAR(depth, expected_m, 0.5 / 512.0 + 1e-5) << u << " " << v;
                    ++on_wall;
                } else if (place.z() < -8.1 || place.z() > 0.1) {
                    ASSERT_TRUE(std::isinf(depth)) << u << " " << v;
                }
            }
        }
        EXPECT_GT(on_wall, 800);
    }
    EXPECT_NEAR(truth.images.front().world_from_camera.translation().x(), 0.5, 0.05);
    EXPECT_GT(truth.images.back().world_from_camera.translation().x(), 1.0);
}

TEST(Simulation, ComesFromItsSeedAlone) {
    SimulationOptions options;
    options.sensor.disparity_sigma_px = 0.25;
    options.sensor.vibration_deg = 0.1;
    options.navigation.scale = 1.0;
    const Simulated first(options);
    const Simulated again(options);
    EXPECT_TRUE(first.files == again.files);
    options.seed = 2;
    const Simulated other(options);
    for (const char* const name : {"depth", "navigation.csv", "frames.csv", "truth/images.csv",
                                   "truth/navigation.csv", "truth/truth.json"}) {
        EXPECT_THAT(differences(first.files, other.files), Contains(name));
    }
}

TEST(Simulation, ChangesWithAFaultWhatBelongsToIt) {
    const Simulated exact{SimulationOptions{}};
    const auto changed = [&](const auto& set) {
        SimulationOptions options;
        set(options);
        return differences(exact.files, Simulated(options).files);
    };
    using Options = SimulationOptions;
    // The description names the faults at its top, so it always changes.
    for (const auto& set : std::vector<std::function<void(Options&)>>{
             [](Options& o) { o.sensor.disparity_sigma_px = 0.2; },
             [](Options& o) { o.sensor.disparity_step_px = 0.5; },
             [](Options& o) { o.sensor.missing = 1.0; },
             [](Options& o) { o.sensor.bleeding_px = 1; },
             [](Options& o) { o.sensor.outlier_share = 0.1; },
             [](Options& o) { o.sensor.missing_sky = true; },
             [](Options& o) { o.sensor.screen_px = 1.0; }}) {
        EXPECT_THAT(changed(set), ElementsAre("depth", "description.toml"));
    }
    EXPECT_THAT(changed([](Options& o) { o.sensor.vibration_deg = 0.2; }),
                ElementsAre("depth", "description.toml", "truth/images.csv"));
    EXPECT_THAT(changed([](Options& o) { o.navigation.scale = 1.0; }),
                ElementsAre("description.toml", "navigation.csv"));
    EXPECT_THAT(changed([](Options& o) {
                    o.transfer.late_images = 0.5;
                    o.transfer.late_by_s = 0.02;
                }),
                ElementsAre("description.toml", "frames.csv"));
    EXPECT_THAT(changed([](Options& o) { o.transfer.lost_navigation = 0.3; }),
                ElementsAre("description.toml", "navigation.csv", "truth/navigation.csv",
                            "truth/truth.json"));
    EXPECT_THAT(changed([](Options& o) { o.transfer.lost_images = 0.3; }),
                ElementsAre("depth", "description.toml", "frames.csv", "truth/images.csv",
                            "truth/truth.json"));
}

TEST(Simulation, StatesAnotherTruthWhereverTheTruthIsAnother) {
    const auto stated = [](const SimulationOptions& options, const Scene& scene = wall_scene()) {
        return open(Simulated(options, scene))->truth_digest();
    };
    SimulationOptions options;
    const auto exact = stated(options);
    options.sensor.disparity_sigma_px = 0.2; // other images of the same things from the same places
    EXPECT_EQ(stated(options), exact);
    options.sensor.vibration_deg = 0.2;
    EXPECT_NE(stated(options), exact);
    options = {};
    options.seed = 2;
    EXPECT_NE(stated(options), exact);
    Scene edited = wall_scene(); // under the same name, flown at the same times
    edited.surfaces.vertices_m[2].z() = -9.0F;
    EXPECT_NE(stated(SimulationOptions{}, edited), exact);
}

TEST(Simulation, ShakesTheCameraButNotTheNavigation) {
    SimulationOptions options;
    const SimulatedFlight still = fly(wall_scene(), options);
    options.sensor.vibration_deg = 0.5;
    const SimulatedFlight shaken = fly(wall_scene(), options);
    double most_rad = 0.0;
    for (std::size_t i = 0; i < still.truth.images.size(); ++i) {
        most_rad =
            std::max(most_rad, Eigen::Quaterniond(still.truth.images[i].world_from_camera.linear())
                                   .angularDistance(Eigen::Quaterniond(
                                       shaken.truth.images[i].world_from_camera.linear())));
    }
    EXPECT_GT(most_rad, 0.005);
    EXPECT_LT(most_rad, 0.5 * 1.5 * std::sqrt(3.0) / 57.0);
    EXPECT_EQ(still.navigation[99].sample.position_m, shaken.navigation[99].sample.position_m);
}

TEST(Simulation, DelaysAndLosesImages) {
    Scene scene = wall_scene();
    scene.duration_s = 60.0;
    SimulationOptions options;
    options.transfer.late_images = 0.25;
    options.transfer.late_by_s = 0.02; // less than between images: none waits for another
    options.transfer.lost_images = 0.1;
    options.transfer.lost_navigation = 0.2;
    const SimulatedFlight flight = fly(scene, options);
    EXPECT_NEAR(static_cast<double>(flight.numbers.size()), 1620.0, 60.0);
    EXPECT_NEAR(static_cast<double>(flight.navigation.size()), 4800.0, 130.0);
    EXPECT_EQ(flight.navigation.size(), flight.truth.navigation.size());
    double late = 0.0;
    double most_s = 0.0;
    for (std::size_t i = 0; i < flight.numbers.size(); ++i) {
        const double delay_s = flight.image_times_s[i] - flight.truth.images[i].time_s;
        EXPECT_GE(delay_s, 0.0);
        late += delay_s > 0.0 ? 1.0 : 0.0;
        most_s = std::max(most_s, delay_s);
    }
    EXPECT_EQ(static_cast<double>(flight.images_late), late);
    EXPECT_NEAR(late / static_cast<double>(flight.numbers.size()), 0.25, 0.05);
    EXPECT_LE(most_s, 0.02);
    EXPECT_GT(most_s, 0.019);
    options.transfer.late_by_s = 0.5; // images would overtake each other
    const SimulatedFlight waiting = fly(scene, options);
    EXPECT_TRUE(std::ranges::adjacent_find(waiting.image_times_s, std::greater_equal<>{}) ==
                waiting.image_times_s.end());
}

TEST(Simulation, RefusesFlightsThatMemoryCannotHold) {
    Scene scene = wall_scene();
    scene.image_rate_hz = 1000.0;
    SimulationOptions options;
    options.duration_s = 86400.0;
    EXPECT_THAT([&] { static_cast<void>(fly(scene, options)); },
                ::testing::ThrowsMessage<UsageError>(
                    ::testing::HasSubstr("86400 s at 1000 Hz has more than 2e+07 samples")));
}

/// The wall, and before it a plate that rises from a standstill to the east.
Scene vehicle_scene() {
    Scene scene = wall_scene();
    for (const auto& [east_m, down_m] :
         {std::pair{-1.0F, 1.0F}, std::pair{1.0F, 1.0F}, std::pair{0.0F, -2.0F}}) {
        scene.surfaces.vertices_m.emplace_back(0.0F, east_m, down_m);
    }
    scene.surfaces.triangles.push_back({4, 5, 6});
    scene.surfaces.obstacles.push_back({"vehicle", ObstacleKind::aircraft, 2, 1, true});
    scene.texture.push_back(1.0);
    SecondVehicle vehicle;
    vehicle.obstacle = 1;
    Waypoint from;
    from.position_m = {15.0, 0.0, -5.0};
    from.yaw_rad = 0.0;
    Waypoint to = from;
    to.position_m = {15.0, 12.0, -6.0};
    vehicle.route.waypoints = {from, to};
    scene.vehicles = {vehicle};
    return scene;
}

TEST(Simulation, CarriesMovingObstacles) {
    const Simulated simulated(SimulationOptions{}, vehicle_scene());
    const auto recording = open(simulated);
    const Truth truth = read_truth(simulated.path() / "truth");
    ASSERT_EQ(truth.motions.size(), 1U);
    for (std::size_t i = 0; i < truth.images.size(); ++i) {
        const TrueImage& image = truth.images[i];
        const Eigen::Vector3d place = truth.motions[0].at(image.time_s).translation();
        const Eigen::Vector3d seen = image.world_from_camera.inverse() * place;
        const long u = std::lround(31.5 + 67.0 * seen.x() / seen.z());
        const long v = std::lround(23.5 + 66.0 * seen.y() / seen.z());
        const float depth_m =
            recording->read_frame(i).depth_m[static_cast<std::size_t>(64 * v + u)];
        ASSERT_NEAR(depth_m, seen.z(), 0.1) << i; // before the wall
    }
    EXPECT_GT(truth.motions[0].at(truth.images.back().time_s).translation().y(), 1.5);
}

TEST(Simulation, MixesAnExposureWithTheOneBefore) {
    Scene scene = vehicle_scene();
    scene.image_rate_hz = 4.0; // the vehicle moves on between two images
    SimulationOptions options;
    const Simulated clear(options, scene);
    options.sensor.screen_px = 1e-6;
    const Simulated mixed(options, scene);
    const auto exact = open(clear);
    const auto screen = open(mixed);
    std::size_t from_before = 0;
    for (std::size_t i = 1; i < exact->frames().size(); ++i) {
        const std::vector<float> now_m = exact->read_frame(i).depth_m;
        const std::vector<float> before_m = exact->read_frame(i - 1).depth_m;
        const std::vector<float> seen_m = screen->read_frame(i).depth_m;
        for (std::size_t pixel = 0; pixel < now_m.size(); ++pixel) {
            const auto is = [&](float depth_m) {
                return std::isinf(depth_m) ? std::isinf(seen_m[pixel])
                                           : std::abs(depth_m - seen_m[pixel]) < 0.005F;
            };
            ASSERT_TRUE(is(now_m[pixel]) || is(before_m[pixel])) << i << " " << pixel;
            from_before += is(now_m[pixel]) ? 0U : 1U;
        }
    }
    EXPECT_GT(from_before, 100U);
}

TEST(Simulation, WritesDepthUpTo128Metres) {
    EXPECT_EQ(depth_value(0.0F), 0);
    EXPECT_EQ(depth_value(1e-5F), 1);
    EXPECT_EQ(depth_value(1.0F), 512);
    EXPECT_EQ(depth_value(127.99F), 65531);
    EXPECT_EQ(depth_value(127.997F), 65534);
    EXPECT_EQ(depth_value(128.0F), 65535);
    EXPECT_EQ(depth_value(std::numeric_limits<float>::infinity()), 65535);
}

TEST(Simulation, NamesItsFaultsAsOptions) {
    SimulationOptions options;
    EXPECT_EQ(fault_arguments(options), "");
    options.sensor.disparity_sigma_px = 0.25;
    options.sensor.missing_sky = true;
    options.navigation.scale = 0.5;
    options.transfer.late_images = 0.1;
    options.transfer.late_by_s = 0.03;
    EXPECT_EQ(fault_arguments(options),
              "--stereo-noise 0.25 --missing-sky --navigation-errors 0.5 --navigation-constant 60 "
              "--late-images 0.1 --late-by 30");
}

TEST(Simulation, RefusesFlightsWithoutImagesOrAnEnd) {
    SimulationOptions options;
    options.transfer.lost_images = 1.0;
    EXPECT_THAT([&] { static_cast<void>(fly(wall_scene(), options)); },
                ThrowsMessage<UsageError>(HasSubstr("no image is left")));
    Scene scene = wall_scene();
    scene.route.loop = true;
    scene.duration_s.reset();
    EXPECT_THAT([&] { static_cast<void>(fly(scene, {})); },
                ThrowsMessage<UsageError>(HasSubstr("loop without an end")));
}

TEST(Simulation, EndsWhenItsObserverThrows) {
    const Scene scene = wall_scene();
    const SimulatedFlight flight = fly(scene, {});
    const TemporaryFolder folder;
    EXPECT_THROW(write_simulation(folder.path(), scene, {}, flight,
                                  [](std::uint64_t) { throw std::runtime_error("stop"); }),
                 std::runtime_error);
}

} // namespace
} // namespace zonegrid::testing
