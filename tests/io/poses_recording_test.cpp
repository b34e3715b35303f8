#include "io/recording.h"

#include "io/recording_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace zonegrid {
namespace {

using ::testing::HasSubstr;
using testing::RecordingFolder;
using testing::refuses;
using ::testing::SizeIs;

constexpr std::array<std::uint16_t, 4> stored_depth{1000, 0, 65535, 2500};
constexpr const char* identity = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

void add_frame(const RecordingFolder& folder, int number, const std::string& pose) {
    folder.write_depth(fmt::format("data/frame-{:06}.depth.png", number), 2, stored_depth);
    folder.write(fmt::format("data/frame-{:06}.pose.txt", number), pose);
}

void add_intrinsics(const RecordingFolder& folder, const std::string& matrix) {
    folder.write("data/camera-intrinsics.txt", matrix);
}

/// Two frames; the second camera is moved by (1, 2, 3) and turned by 90 degrees about y (down).
void fill(const RecordingFolder& folder) {
    add_frame(folder, 200, identity);
    add_frame(folder, 202, "0 0 1 1\n0 1 0 2\n-1 0 0 3\n0 0 0 1\n");
    add_intrinsics(folder, "585 0 320\n0 586 240\n0 0 1\n");
}

auto opening(const RecordingFolder& folder) {
    return [&folder] { return open_recording(folder.path()); };
}

TEST(PosesRecording, ReadsPosesTimesAndDepth) {
    const RecordingFolder folder;
    fill(folder);
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->layout(), "poses");
    ASSERT_THAT(recording->frames(), SizeIs(2));
    ASSERT_THAT(recording->navigation(), SizeIs(2));
    EXPECT_EQ(recording->frames()[1].time_s, 202.0 / 30.0);
    EXPECT_EQ(recording->navigation()[1].time_s, recording->frames()[1].time_s);
    EXPECT_EQ(recording->camera()->fy_px, 586.0);

    // World y down: north is the first camera's optical axis, east its right.
    const NavigationSample& first = recording->navigation()[0];
    const NavigationSample& second = recording->navigation()[1];
    EXPECT_TRUE(first.world_from_body.toRotationMatrix().isIdentity(1e-12));
    EXPECT_NEAR((second.position_m - Eigen::Vector3d(3, 1, 2)).norm(), 0.0, 1e-12);
    // Turned to the right: forward is east.
    EXPECT_NEAR(
        (second.world_from_body * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 0.0,
        1e-12);
    EXPECT_NEAR((first.velocity_mps - Eigen::Vector3d(45, 15, 30)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(first.body_rate_radps.z(), std::acos(0.0) * 15.0, 1e-9);

    const std::vector<float> depth_m = recording->read_frame(0).depth_m;
    EXPECT_FLOAT_EQ(depth_m[0], 1.0F);
    EXPECT_TRUE(std::isnan(depth_m[1]));
    EXPECT_TRUE(std::isnan(depth_m[2]));
    EXPECT_FLOAT_EQ(depth_m[3], 2.5F);
}

TEST(PosesRecording, OpensTheInnerFolderToo) {
    const RecordingFolder folder;
    fill(folder);
    EXPECT_THAT(open_recording(folder.path() / "data")->frames(), SizeIs(2));
}

TEST(PosesRecording, MakesRoundedRotationsOrthonormal) {
    const RecordingFolder folder;
    fill(folder);
    add_frame(folder, 203, "1.001 0 0 0\n0 0.999 0 0\n0 0 1 0\n0 0 0 1\n");
    const auto recording = open_recording(folder.path());
    EXPECT_TRUE(recording->navigation()[2].world_from_body.toRotationMatrix().isIdentity(1e-9));
    add_frame(folder, 203, "1.01 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
    EXPECT_THAT(opening(folder), refuses("frame-000203.pose.txt", "not orthonormal", "0.0201"));
}

TEST(PosesRecording, RefusesReflections) {
    const RecordingFolder folder;
    fill(folder);
    add_frame(folder, 203, "1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n");
    EXPECT_THAT(opening(folder), refuses("frame-000203.pose.txt", "camera is inside-out", "flip"));
}

TEST(PosesRecording, RefusesBadPosesAndIntrinsics) {
    const RecordingFolder folder;
    fill(folder);
    const auto with_pose = [&](const std::string& pose) {
        folder.write("data/frame-000202.pose.txt", pose);
        return opening(folder);
    };
    EXPECT_THAT(with_pose("1 0 0 nan\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"),
                refuses("frame-000202.pose.txt:1", "'nan'"));
    EXPECT_THAT(with_pose("1 0 0 0\n0 one 0 0\n0 0 1 0\n0 0 0 1\n"),
                refuses("frame-000202.pose.txt:2", "'one'"));
    EXPECT_THAT(with_pose("1 0 0 0\n0 1 0 0\n0 0 1 0\n"),
                refuses("frame-000202.pose.txt", "3 rows where 4 belong"));
    EXPECT_THAT(with_pose("1 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"),
                refuses("frame-000202.pose.txt:1", "3 fields where 4 belong"));
    EXPECT_THAT(with_pose("1 0 0 0\n0 1 0 0\n0 0 1 0\n1 2 3 1\n"),
                refuses("frame-000202.pose.txt", "last row", "transposed"));
    fill(folder);
    for (const char* matrix : {"0 0 320\n0 585 240\n0 0 1\n", "585 0 320\n0 -585 240\n0 0 1\n",
                               "585 1 320\n0 585 240\n0 0 1\n", "585 0 0\n0 585 0\n320 240 1\n"}) {
        add_intrinsics(folder, matrix);
        EXPECT_THAT(opening(folder), refuses("camera-intrinsics.txt", "no pinhole")) << matrix;
    }
    std::filesystem::remove(folder.path() / "data/camera-intrinsics.txt");
    EXPECT_THAT(opening(folder), refuses("camera-intrinsics.txt", "cannot be opened"));
    EXPECT_EQ(open_recording(folder.path(), {.intrinsics = {{5, 6, 7, 8}}})->camera()->cx_px, 7.0);
}

TEST(PosesRecording, SkipsImagesWithoutAPoseAndCountsThem) {
    const RecordingFolder folder;
    fill(folder);
    std::filesystem::remove(folder.path() / "data/frame-000200.pose.txt");
    const auto recording = open_recording(folder.path());
    EXPECT_THAT(recording->frames(), SizeIs(1));
    ASSERT_THAT(recording->warnings(), SizeIs(1));
    EXPECT_THAT(recording->warnings()[0].problem, HasSubstr("1 depth images have no .pose.txt"));
    std::filesystem::remove(folder.path() / "data/frame-000202.pose.txt");
    EXPECT_THAT(opening(folder), refuses("no depth image has a pose"));
}

} // namespace
} // namespace zonegrid
