#include "io/recording.h"

#include "io/lens_distortion.h"
#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace zonegrid {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::RecordingFolder;
using testing::refuses;
using ::testing::SizeIs;

constexpr std::array<std::uint16_t, 6> stored_depth{1000, 0, 2000, 65535, 65534, 3000};
constexpr std::array<float, 6> metres{1.F, 2.F, 3.F, 4.F, 5.F, 6.F};

constexpr const char* camera_table =
    "[camera]\nmodel = \"pinhole\"\nwidth_px = 3\nheight_px = 2\n"
    "fx_px = 2\nfy_px = 2.5\ncx_px = 1.0\ncy_px = 0.5\n";
constexpr const char* navigation_rows =
    "time_s,north_m,east_m,down_m,roll_rad,pitch_rad,yaw_rad\n"
    "1.00,10,20,-30,0.1,-0.2,0.3\n"
    "1.01,10.1,20,-30.05,0.1,-0.2,0.3\n";

void fill(const RecordingFolder& folder, const std::string& description,
          const std::string& navigation = navigation_rows) {
    folder.write_depth("depth/a.png", 3, stored_depth);
    folder.write_npy("depth/b.npy", "(2, 3)", metres);
    std::string pfm = "Pf\n3 2\n-1\n";
    pfm.append(reinterpret_cast<const char*>(metres.data()), sizeof(metres));
    folder.write("depth/c.pfm", pfm);
    folder.write("description.toml", description);
    folder.write("navigation.csv", navigation);
    folder.write("frames.csv",
                 "time_s,file\n1.002,depth/a.png\n1.004,depth/b.npy\n"
                 "1.006,depth/c.pfm\n");
}

auto opening(const RecordingFolder& folder) {
    return [&folder] { return open_recording(folder.path()); };
}

TEST(PlainRecording, ReadsImagesOfAllFormats) {
    const RecordingFolder folder;
    fill(folder, std::string(camera_table) +
                     "[depth]\nunits_per_m = 1000\nmissing = [0, 65535]\n"
                     "infinite = [65534]\n");
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->layout(), "plain");
    EXPECT_THAT(recording->warnings(), IsEmpty());
    ASSERT_THAT(recording->frames(), SizeIs(3));
    EXPECT_EQ(recording->frames()[0].time_s, 1.002);
    const std::vector<float> png_m = recording->read_frame(0).depth_m;
    EXPECT_FLOAT_EQ(png_m[2], 2.0F);
    EXPECT_TRUE(std::isnan(png_m[1]));
    EXPECT_TRUE(std::isnan(png_m[3]));
    EXPECT_TRUE(std::isinf(png_m[4]));
    EXPECT_FLOAT_EQ(recording->read_frame(1).depth_m[0], 0.001F); // the scale counts for all
    EXPECT_FLOAT_EQ(recording->read_frame(2).depth_m[0], 0.004F);
    EXPECT_EQ(recording->camera()->fy_px, 2.5);
    EXPECT_FALSE(recording->camera()->stereo.has_value());
    EXPECT_FALSE(recording->truth_digest().has_value()); // nobody knows a real flight's
    EXPECT_TRUE(recording->camera()->body_from_camera.isApprox(
        Eigen::Isometry3d(body_from_forward_camera()), 1e-12));
}

TEST(PlainRecording, ReadsNavigationAndDerivesWhatIsNotGiven) {
    const RecordingFolder folder;
    fill(folder, std::string(camera_table) + "[depth]\nunits_per_m = 1000\n");
    const auto recording = open_recording(folder.path());
    ASSERT_THAT(recording->navigation(), SizeIs(2));
    const NavigationSample& first = recording->navigation()[0];
    EXPECT_EQ(first.position_m, Eigen::Vector3d(10, 20, -30));
    EXPECT_NEAR((first.velocity_mps - Eigen::Vector3d(10, 0, -5)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(first.world_from_body.angularDistance(attitude_from_euler(0.1, -0.2, 0.3)), 0.0,
                1e-9);
}

TEST(PlainRecording, ReadsAllNavigationColumnsInAnyOrder) {
    const RecordingFolder folder;
    fill(folder, std::string(camera_table) + "[depth]\nunits_per_m = 1000\n",
         "# by the flight controller\n"
         "yaw_deg, time_s, north_m, east_m, down_m, north_mps, east_mps, down_mps, north_mps2, "
         "east_mps2, down_mps2, roll_deg, pitch_deg, roll_degps, pitch_degps, yaw_degps\n"
         "90, 1.00, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 180, 0, -90\r\n");
    const NavigationSample sample = open_recording(folder.path())->navigation().at(0);
    EXPECT_EQ(sample.position_m, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(sample.velocity_mps, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(sample.acceleration_mps2, Eigen::Vector3d(7, 8, 9));
    EXPECT_NEAR(
        (sample.world_from_body * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 0.0,
        1e-12);
    EXPECT_NEAR(sample.body_rate_radps.x(), 3.14159265, 1e-6);
    EXPECT_NEAR(sample.body_rate_radps.z(), -1.57079633, 1e-6);
}

TEST(PlainRecording, TurnsOtherWorldsByQuaternionColumns) {
    const RecordingFolder folder;
    fill(folder,
         std::string(camera_table) +
             "[depth]\nunits_per_m = 1000\n[world]\naxes = \"east_north_up\"\n",
         "time_s,x_m,y_m,z_m,x_mps,y_mps,z_mps,qx,qy,qz,qw\n1,1,2,3,4,5,6,1,0,0,0\n");
    const NavigationSample sample = open_recording(folder.path())->navigation().at(0);
    EXPECT_EQ(sample.position_m, Eigen::Vector3d(2, 1, -3));
    EXPECT_EQ(sample.velocity_mps, Eigen::Vector3d(5, 4, -6));
    // The body turned about x (east) by 180 degrees: forward is east, down is down.
    EXPECT_NEAR(
        (sample.world_from_body * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 0.0,
        1e-12);
    EXPECT_NEAR(
        (sample.world_from_body * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitZ()).norm(), 0.0,
        1e-12);
    EXPECT_EQ(open_recording(folder.path(), {.world_axes = WorldAxes::north_east_down})
                  ->navigation()[0]
                  .position_m,
              Eigen::Vector3d(1, 2, 3));
}

TEST(PlainRecording, ReadsMountingStereoAndOrigin) {
    const RecordingFolder folder;
    fill(folder, std::string(camera_table) +
                     "[depth]\nunits_per_m = 1000\n"
                     "[mounting]\nposition_m = [0.5, 0, -0.25]\npitch_deg = -90\n"
                     "[stereo]\nbaseline_m = 0.3\ndisparity_sigma_px = 0.25\n"
                     "[world]\nlatitude_deg = 52.3\nlongitude_deg = 10.5\naltitude_m = 80\n");
    const auto recording = open_recording(folder.path());
    const Eigen::Isometry3d& mounting = recording->camera()->body_from_camera;
    EXPECT_EQ(mounting.translation(), Eigen::Vector3d(0.5, 0, -0.25));
    // Pitched down by 90 degrees: the optical axis points down, the image's top forward.
    EXPECT_NEAR((mounting.linear().col(2) - Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-12);
    EXPECT_NEAR((mounting.linear().col(1) + Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-12);
    EXPECT_EQ(recording->camera()->stereo->baseline_m, 0.3);
    EXPECT_EQ(recording->camera()->stereo->disparity_sigma_px, 0.25);
    EXPECT_EQ(recording->origin()->longitude_deg, 10.5);
}

TEST(PlainRecording, TurnsALensIntoDirections) {
    const RecordingFolder folder;
    std::string camera = camera_table;
    camera.replace(camera.find("pinhole"), 7, "brown_conrady");
    fill(folder, camera + "k1 = -0.1\np1 = 0.01\n[depth]\nunits_per_m = 1000\nkind = \"ray\"\n");
    const auto recording = open_recording(folder.path());
    const std::vector<Eigen::Vector2f>& directions = recording->camera()->directions;
    ASSERT_THAT(directions, SizeIs(6));
    const Eigen::Vector2d shown = distort(directions[5].cast<double>(), {.k1 = -0.1, .p1 = 0.01});
    EXPECT_NEAR(shown.x(), (2 - 1.0) / 2.0, 1e-6);
    EXPECT_NEAR(shown.y(), (1 - 0.5) / 2.5, 1e-6);
    EXPECT_FLOAT_EQ(recording->read_frame(0).depth_m[5],
                    3.0F / std::sqrt(1.0F + directions[5].squaredNorm()));
    EXPECT_THROW(static_cast<void>(open_recording(folder.path(), {.intrinsics = {{1, 1, 1, 1}}})),
                 UsageError);

    fill(folder, camera + "k1 = -9\n[depth]\nunits_per_m = 1000\n");
    EXPECT_THAT(opening(folder), refuses("description.toml:2", "cannot be inverted at pixel"));
}

TEST(PlainRecording, ReadsATableOfDirections) {
    const RecordingFolder folder;
    fill(folder,
         "[camera]\nmodel = \"table\"\nwidth_px = 3\nheight_px = 2\ntable = \"rays.npy\"\n"
         "[depth]\nunits_per_m = 1000\n");
    std::vector<float> slopes;
    for (int v = 0; v < 2; ++v) {
        for (int u = 0; u < 3; ++u) {
            slopes.push_back(static_cast<float>((u - 1.25) / 2.0));
            slopes.push_back(static_cast<float>((v - 0.5) / 4.0));
        }
    }
    folder.write_npy("rays.npy", "(2, 3, 2)", slopes);
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->camera()->directions[5], Eigen::Vector2f(slopes[10], slopes[11]));
    EXPECT_NEAR(recording->camera()->fx_px, 2.0, 1e-6);
    EXPECT_NEAR(recording->camera()->cx_px, 1.25, 1e-6);
    EXPECT_NEAR(recording->camera()->fy_px, 4.0, 1e-6);
    EXPECT_NEAR(recording->camera()->cy_px, 0.5, 1e-6);

    folder.write_npy("rays.npy", "(3, 2, 2)", slopes);
    EXPECT_THAT(opening(folder), refuses("rays.npy", "(3, 2, 2), not (2, 3, 2)"));
    slopes[6] = std::nanf("");
    folder.write_npy("rays.npy", "(2, 3, 2)", slopes);
    EXPECT_THAT(opening(folder), refuses("rays.npy", "pixel (0, 1) is not finite"));
    folder.write_npy("rays.npy", "(2, 3, 2)", std::vector<float>(12));
    EXPECT_THAT(opening(folder), refuses("rays.npy", "do not grow"));
}

TEST(PlainRecording, ReadsScans) {
    const RecordingFolder folder;
    fill(folder, "[scanner]\n[mounting]\nposition_m = [0, 0, 1]\nyaw_deg = 90\n");
    folder.write_npy("scans/1.npy", "(2, 3)", metres);
    folder.write("frames.csv", "time_s,file\n1.002,scans/1.npy\n");
    const auto recording = open_recording(folder.path());
    EXPECT_FALSE(recording->camera().has_value());
    EXPECT_THAT(recording->read_frame(0).ends_m,
                ::testing::ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)));
    // Forward, left, up turned by 90 degrees to the right: forward is body right, left forward.
    EXPECT_NEAR(
        (recording->body_from_sensor() * Eigen::Vector3d(1, 2, 3) - Eigen::Vector3d(2, 1, -2))
            .norm(),
        0.0, 1e-12);
    EXPECT_THROW(static_cast<void>(open_recording(folder.path(), {.depth_units_per_m = 1.0})),
                 UsageError);
}

TEST(PlainRecording, SkipsAbsentFramesWithOneWarning) {
    const RecordingFolder folder;
    fill(folder, std::string(camera_table) + "[depth]\nunits_per_m = 1000\n");
    std::filesystem::remove(folder.path() / "depth/a.png");
    const auto recording = open_recording(folder.path());
    EXPECT_THAT(recording->frames(), SizeIs(2));
    ASSERT_THAT(recording->warnings(), SizeIs(1));
    EXPECT_THAT(recording->warnings()[0].problem, HasSubstr("1 of 3"));
}

} // namespace
} // namespace zonegrid
