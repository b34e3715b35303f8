#include "io/recording.h"

#include "io/recording_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <string>

namespace zonegrid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::RecordingFolder;
using testing::refuses;
using ::testing::SizeIs;

constexpr const char* calibration =
    "calib_time: 25-May-2012 16:47:16\n"
    "R: 1 0 0 0 1 0 0 0 1\n"
    "T: -0.8 0.3 -0.8\n";

/// A row with the given attitude and motion; gravity is felt upwards.
std::string row(double latitude_deg, double longitude_deg, double roll_rad, double pitch_rad,
                double yaw_rad) {
    return fmt::format(
        "{:.12f} {:.12f} 110 {} {} {} "
        "3 4 0 0 -0.5 " // velocities: north, east, forward, left, up
        "1 2 9.81 0 0 0 "
        "0.1 0.2 0.3 0 0 0 0.05 0.05 4 9 4 5 0\n",
        latitude_deg, longitude_deg, roll_rad, pitch_rad, yaw_rad);
}

/// Two rows and sweeps: heading north, then heading east and 0.00001 degrees further north.
void fill(const RecordingFolder& folder) {
    folder.write("calib_imu_to_velo.txt", calibration);
    const std::string times =
        "2011-09-26 13:04:32.335337762\n2011-09-26 13:04:32.438625628\n"
        "2011-09-26 13:04:32.541951663\n";
    folder.write("oxts/timestamps.txt", times);
    folder.write("velodyne_points/timestamps.txt", times);
    folder.write("oxts/data/0000000000.txt", row(49.0, 8.4, 0.0, 0.0, std::numbers::pi / 2));
    folder.write("oxts/data/0000000001.txt", row(49.00001, 8.40001, 0.1, -0.2, 0.0));
    folder.write("oxts/data/0000000002.txt", row(49.00002, 8.40002, 0.0, 0.0, 0.0));
    folder.write_floats("velodyne_points/data/0000000001.bin",
                        std::array{10.F, 2.F, -1.5F, 0.3F, 20.F, 0.F, 0.F, 0.1F});
    folder.write("velodyne_points/data/0000000002.txt", "1 2 3 0.5\n");
}

auto opening(const RecordingFolder& folder) {
    return [&folder] { return open_recording(folder.path()); };
}

TEST(KittiRecording, TurnsOxtsIntoNorthEastDown) {
    const RecordingFolder folder;
    fill(folder);
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->layout(), "kitti");
    ASSERT_THAT(recording->navigation(), SizeIs(3));
    const NavigationSample& first = recording->navigation()[0];
    EXPECT_NEAR(first.time_s, 1317042272.335337762, 1e-6);
    EXPECT_EQ(first.position_m, Eigen::Vector3d::Zero());
    EXPECT_TRUE(first.world_from_body.toRotationMatrix().isIdentity(1e-9)); // heading north, level
    EXPECT_NEAR((first.velocity_mps - Eigen::Vector3d(3, 4, 0.5)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((first.body_rate_radps - Eigen::Vector3d(0.1, -0.2, -0.3)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((first.acceleration_mps2 - Eigen::Vector3d(1, -2, 0)).norm(), 0.0, 2e-2);

    const NavigationSample& second = recording->navigation()[1];
    EXPECT_NEAR(second.position_m.x(), 1.112, 1e-3); // 1e-5 deg of a meridian
    EXPECT_NEAR(second.position_m.y(), 0.7315, 1e-3);
    // Heading east; positive roll is left side up, negative pitch is nose up: the same as in
    // forward-right-down, with yaw 90 degrees and the pitch's sign turned.
    EXPECT_NEAR(
        second.world_from_body.angularDistance(attitude_from_euler(0.1, 0.2, std::numbers::pi / 2)),
        0.0, 1e-9);
    ASSERT_TRUE(recording->origin().has_value());
    EXPECT_EQ(recording->origin()->latitude_deg, 49.0);
    EXPECT_EQ(recording->origin()->longitude_deg, 8.4);
    EXPECT_EQ(recording->origin()->altitude_m, 110.0);
}

TEST(KittiRecording, MountsTheVelodyneByItsCalibration) {
    const RecordingFolder folder;
    fill(folder);
    const auto recording = open_recording(folder.path());
    EXPECT_FALSE(recording->camera().has_value());
    // The Velodyne sits 0.8 m before, 0.3 m to the right of and 0.8 m above the IMU.
    EXPECT_NEAR(
        (recording->body_from_sensor().translation() - Eigen::Vector3d(0.8, 0.3, -0.8)).norm(), 0.0,
        1e-12);
    EXPECT_NEAR((recording->body_from_sensor().linear() * Eigen::Vector3d(1, 2, 3) -
                 Eigen::Vector3d(1, -2, -3))
                    .norm(),
                0.0, 1e-12);
}

TEST(KittiRecording, ReadsSweepsAndCountsAbsentOnes) {
    const RecordingFolder folder;
    fill(folder);
    std::filesystem::remove(folder.path() / "oxts/data/0000000002.txt");
    const auto recording = open_recording(folder.path());
    ASSERT_THAT(recording->frames(), SizeIs(2));
    EXPECT_THAT(recording->read_frame(0).ends_m,
                ElementsAre(Eigen::Vector3f(10, 2, -1.5F), Eigen::Vector3f(20, 0, 0)));
    EXPECT_THAT(recording->read_frame(1).ends_m, ElementsAre(Eigen::Vector3f(1, 2, 3)));
    ASSERT_THAT(recording->warnings(), SizeIs(2));
    EXPECT_THAT(recording->warnings()[0].where, HasSubstr("oxts"));
    EXPECT_THAT(recording->warnings()[0].problem, HasSubstr("1 of 3"));
    EXPECT_THAT(recording->warnings()[1].where, HasSubstr("velodyne_points"));
    EXPECT_THAT(recording->warnings()[1].problem, HasSubstr("1 of 3"));
    folder.truncate("velodyne_points/data/0000000001.bin", 30);
    EXPECT_THAT([&] { static_cast<void>(recording->read_frame(0)); },
                refuses("0000000001.bin", "30 bytes", "truncated"));
}

TEST(KittiRecording, FindsTheCalibrationOfTheDay) {
    const RecordingFolder day("2011_09_26");
    const RecordingFolder drive;
    fill(drive);
    std::filesystem::copy(drive.path(), day.path() / "drive",
                          std::filesystem::copy_options::recursive);
    std::filesystem::rename(day.path() / "drive/calib_imu_to_velo.txt",
                            day.path() / "calib_imu_to_velo.txt");
    EXPECT_NEAR(open_recording(day.path() / "drive")->body_from_sensor().translation().x(), 0.8,
                1e-12);
}

TEST(KittiRecording, RefusesBadFiles) {
    const RecordingFolder folder;
    fill(folder);
    folder.write("oxts/data/0000000001.txt", "49 8.4 110 0 0 0\n");
    EXPECT_THAT(opening(folder), refuses("0000000001.txt:1", "6 fields", "30 numbers"));
    folder.write("oxts/data/0000000001.txt", row(149.0, 8.4, 0, 0, 0));
    EXPECT_THAT(opening(folder), refuses("0000000001.txt:1", "latitude 149"));
    std::string bad_row = row(49.0, 8.4, 0, 0, 0);
    bad_row.replace(bad_row.find("110"), 3, "nan");
    folder.write("oxts/data/0000000001.txt", bad_row);
    EXPECT_THAT(opening(folder), refuses("0000000001.txt:1", "field 3 is 'nan'"));

    fill(folder);
    for (const char* time : {"2011-13-26 13:04:32.1", "2011-02-30 13:04:32.1", "2011-09-26",
                             "2011-09-26 25:04:32.1", "2011-09-26 13:04:xx", "2011-9-26 1:04:32"}) {
        folder.write("oxts/timestamps.txt", fmt::format("2011-09-26 13:04:30.0\n{}\n", time));
        EXPECT_THAT(opening(folder), refuses("timestamps.txt:2")) << time;
    }
    folder.write("oxts/timestamps.txt", "2011-09-26 13:04:30.5\n2011-09-26 13:04:30.4\n");
    EXPECT_THAT(opening(folder), refuses("timestamps.txt:2", "is earlier than"));

    fill(folder);
    folder.write("calib_imu_to_velo.txt", "T: 0 0 0\n");
    EXPECT_THAT(opening(folder), refuses("calib_imu_to_velo.txt", "no line 'R:'"));
    folder.write("calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0\nT: 0 0 0\n");
    EXPECT_THAT(opening(folder), refuses("calib_imu_to_velo.txt:1", "8 numbers where 9 belong"));
    folder.write("calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 -1\nT: 0 0 0\n");
    EXPECT_THAT(opening(folder), refuses("calib_imu_to_velo.txt", "inside-out"));
}

TEST(KittiRecording, RefusesOptionsThatDoNotApply) {
    const RecordingFolder folder;
    fill(folder);
    EXPECT_THROW(static_cast<void>(open_recording(folder.path(), {.world_axes = WorldAxes::z_up})),
                 UsageError);
    EXPECT_THROW(static_cast<void>(open_recording(folder.path(), {.intrinsics = {{1, 1, 1, 1}}})),
                 UsageError);
}

} // namespace
} // namespace zonegrid
