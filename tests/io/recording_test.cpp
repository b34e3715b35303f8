#include "io/recording.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace zonegrid {
namespace {

using testing::RecordingFolder;
using testing::refuses;

void fill_tum(const RecordingFolder& folder) {
    folder.write_depth("depth/1.png", 2, std::array<std::uint16_t, 4>{5000, 0, 1, 2});
    folder.write("depth.txt", "1.0 depth/1.png\n");
    folder.write("groundtruth.txt", "1.0 0 0 0 0 0 0 1\n");
}

TEST(Recording, IsNotRecognisedInAnEmptyFolder) {
    const RecordingFolder folder("empty");
    EXPECT_THAT([&] { return open_recording(folder.path()); },
                refuses("empty", "no recording of a known layout", "description.toml (plain)",
                        "depth.txt", "frame-*.depth.png (poses)"));
}

TEST(Recording, NeedsAFolder) {
    const RecordingFolder folder;
    EXPECT_THAT([&] { return open_recording(folder.path() / "absent"); },
                refuses("absent", "no such"));
    const auto file = folder.write("file.txt", "x");
    EXPECT_THAT([&] { return open_recording(file); }, refuses("file.txt", "no such folder"));
}

TEST(Recording, LayoutCanBeForcedByItsName) {
    const RecordingFolder folder;
    fill_tum(folder);
    EXPECT_EQ(open_recording(folder.path())->layout(), "tum");
    EXPECT_EQ(open_recording(folder.path(), {.layout = "tum"})->layout(), "tum");
    EXPECT_THAT([&] { return open_recording(folder.path(), {.layout = "kitti"}); },
                refuses("calib_imu"));
    EXPECT_THAT([&] { return open_recording(folder.path(), {.layout = "plain"}); },
                refuses("description.toml", "no such file"));
    EXPECT_THROW(static_cast<void>(open_recording(folder.path(), {.layout = "rosbag"})),
                 UsageError);
}

TEST(Recording, RefusesOptionsOutOfRange) {
    const RecordingFolder folder;
    fill_tum(folder);
    const auto opening = [&](const RecordingOptions& options) {
        return [&folder, options] { return open_recording(folder.path(), options); };
    };
    const auto usage_error = ::testing::Throws<UsageError>();
    EXPECT_THAT(opening({.intrinsics = {{0.0, 1.0, 1.0, 1.0}}}), usage_error);
    EXPECT_THAT(opening({.intrinsics = {{1.0, -1.0, 1.0, 1.0}}}), usage_error);
    EXPECT_THAT(opening({.intrinsics = {{1.0, 1.0, std::nan(""), 1.0}}}), usage_error);
    EXPECT_THAT(opening({.depth_units_per_m = 0.0}), usage_error);
    EXPECT_THAT(opening({.depth_units_per_m = INFINITY}), usage_error);
    EXPECT_THAT(opening({.stereo = StereoNoise{0.0, 0.5}}), usage_error);
    EXPECT_THAT(opening({.stereo = StereoNoise{0.1, -0.5}}), usage_error);
}

TEST(Recording, RefusesAFrameThatDoesNotExist) {
    const RecordingFolder folder;
    fill_tum(folder);
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->read_frame(0).depth_m.size(), 4U);
    EXPECT_THROW(static_cast<void>(recording->read_frame(1)), UsageError);
}

} // namespace
} // namespace zonegrid
