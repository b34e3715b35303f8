#include "io/recording.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <array>

namespace zonegrid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::RecordingFolder;
using testing::refuses;
using ::testing::SizeIs;

void fill(const RecordingFolder& folder) {
    folder.write_floats("000000/points.bin", std::array{1.F, 2.F, 3.F, 4.F, 5.F, 6.F});
    folder.write_floats("000002/points.bin", std::array{7.F, 8.F, 9.F});
    folder.write("graph.txt",
                 "v0 1 2 3 0 0 0 1\nv1 1 2 3 0 0 0 1\n"
                 "v2 1 2 3 0 0 0.70710678 0.70710678\n");
}

auto opening(const RecordingFolder& folder) {
    return [&folder] { return open_recording(folder.path()); };
}

TEST(CloudsRecording, ReadsPosesOfAForwardLeftUpScanner) {
    const RecordingFolder folder;
    fill(folder);
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->layout(), "clouds");
    EXPECT_FALSE(recording->camera().has_value());
    ASSERT_THAT(recording->frames(), SizeIs(2));
    EXPECT_NEAR(recording->frames()[1].time_s, 0.2, 1e-12);
    EXPECT_THAT(recording->read_frame(0).ends_m,
                ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)));
    ASSERT_THAT(recording->navigation(), SizeIs(3));
    EXPECT_NEAR((recording->navigation()[0].position_m - Eigen::Vector3d(1, -2, -3)).norm(), 0.0,
                1e-12);
    // The point (7, 8, 9) of a scanner turned left by 90 degrees: world (1 - 8, 2 + 7, 3 + 9).
    const NavigationSample& turned = recording->navigation()[2];
    const Eigen::Vector3d point =
        turned.position_m +
        turned.world_from_body * (recording->body_from_sensor() * Eigen::Vector3d(7, 8, 9));
    EXPECT_NEAR((point - Eigen::Vector3d(-7, -9, -12)).norm(), 0.0, 1e-6);
    ASSERT_THAT(recording->warnings(), SizeIs(1));
    EXPECT_THAT(recording->warnings()[0].problem, HasSubstr("1 of 3 frames"));
}

TEST(CloudsRecording, RefusesBadGraphsAndCameraOptions) {
    const RecordingFolder folder;
    fill(folder);
    const auto with_graph = [&](const std::string& text) {
        folder.write("graph.txt", text);
        return opening(folder);
    };
    EXPECT_THAT(with_graph("v0 1 2 3 0 0 1\n"), refuses("graph.txt:1", "7 fields"));
    EXPECT_THAT(with_graph("vx 1 2 3 0 0 0 1\n"), refuses("graph.txt:1", "'vx'"));
    EXPECT_THAT(with_graph("v0 1 2 3 0 0 0 2\n"), refuses("graph.txt:1", "norm"));
    EXPECT_THAT(with_graph("v0 1 2 3 0 0 0 1\nv0 1 2 3 0 0 0 1\n"),
                refuses("graph.txt:2", "doubles"));
    EXPECT_THAT(with_graph("v99999999999 1 2 3 0 0 0 1\n"), refuses("graph.txt:1"));
    EXPECT_THAT(with_graph("v7 1 2 3 0 0 0 1\n"), refuses("graph.txt", "none of the 1 frames"));
    fill(folder);
    EXPECT_THROW(static_cast<void>(open_recording(folder.path(), {.depth_units_per_m = 1000.0})),
                 UsageError);
    folder.truncate("000002/points.bin", 11);
    const auto recording = open_recording(folder.path());
    EXPECT_THAT([&] { static_cast<void>(recording->read_frame(1)); },
                refuses("000002/points.bin", "11 bytes"));
}

} // namespace
} // namespace zonegrid
