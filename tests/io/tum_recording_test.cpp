#include "io/recording.h"

#include "io/recording_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace zonegrid {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::RecordingFolder;
using testing::refuses;
using ::testing::SizeIs;

constexpr std::array<std::uint16_t, 6> stored_depth{5000, 0, 2500, 65535, 1, 10000};

/// Three images at 100 Hz poses, the camera at (1, 2, 3) looking along the world's x, z up.
void fill_published(const RecordingFolder& folder) {
    std::string depth = "# depth maps\n# file: 'x.bag'\n# timestamp filename\n";
    for (const char* time : {"100.00", "100.03", "100.06"}) {
        const std::string name = fmt::format("depth/{}.png", time);
        folder.write_depth(name, 3, stored_depth);
        depth += fmt::format("{} {}\n", time, name);
    }
    folder.write("depth.txt", depth);
    std::string poses = "# ground truth\n";
    for (int step = 0; step < 8; ++step) { // optical z along x, x along -y, y along -z; 1 m/s in y
        poses += fmt::format("{:.2f} 1 {} 3 0.5 -0.5 0.5 -0.5\n", 100.0 + 0.01 * step,
                             2.0 + 0.01 * step);
    }
    folder.write("groundtruth.txt", poses);
}

auto opening(const RecordingFolder& folder) {
    return [&folder] { return open_recording(folder.path()); };
}

TEST(TumRecording, TurnsPosesIntoNorthEastDown) {
    const RecordingFolder folder;
    fill_published(folder);
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->layout(), "tum");
    EXPECT_THAT(recording->frames(), SizeIs(3));
    EXPECT_THAT(recording->warnings(), IsEmpty());
    ASSERT_THAT(recording->navigation(), SizeIs(8));
    const NavigationSample& sample = recording->navigation()[3];
    EXPECT_NEAR(sample.time_s, 100.03, 1e-12);
    EXPECT_NEAR((sample.position_m - Eigen::Vector3d(1, -2.03, -3)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((sample.velocity_mps - Eigen::Vector3d(0, -1, 0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(sample.body_rate_radps.norm(), 0.0, 1e-9);
    // Looking along x with y up: forward is north, right is east, down is down.
    EXPECT_TRUE(sample.world_from_body.toRotationMatrix().isIdentity(1e-12));
    EXPECT_TRUE(
        recording->camera()->body_from_camera.linear().isApprox(body_from_forward_camera(), 1e-12));
    EXPECT_FALSE(recording->origin().has_value());
}

TEST(TumRecording, DecodesDepthAt5000UnitsPerMetre) {
    const RecordingFolder folder;
    fill_published(folder);
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->camera()->width_px, 3);
    EXPECT_EQ(recording->camera()->height_px, 2);
    const std::vector<float> depth_m = recording->read_frame(1).depth_m;
    ASSERT_THAT(depth_m, SizeIs(6));
    EXPECT_FLOAT_EQ(depth_m[0], 1.0F);
    EXPECT_TRUE(std::isnan(depth_m[1]));
    EXPECT_FLOAT_EQ(depth_m[2], 0.5F);
    EXPECT_FLOAT_EQ(depth_m[3], 13.107F);
    EXPECT_FLOAT_EQ(
        open_recording(folder.path(), {.depth_units_per_m = 1000.0})->read_frame(0).depth_m[0],
        5.0F);
}

TEST(TumRecording, ChoosesIntrinsicsByTheFoldersName) {
    for (const auto& [name, fx, fy, cx, cy] :
         {std::tuple{"rgbd_dataset_freiburg1_xyz_cut", 517.3, 516.5, 318.6, 255.3},
          std::tuple{"freiburg2_desk", 520.9, 521.0, 325.1, 249.7},
          std::tuple{"my_freiburg3", 535.4, 539.2, 320.1, 247.6},
          std::tuple{"hall", 525.0, 525.0, 319.5, 239.5}}) {
        const RecordingFolder folder(name);
        fill_published(folder);
        const auto recording = open_recording(folder.path());
        EXPECT_EQ(recording->camera()->fx_px, fx);
        EXPECT_EQ(recording->camera()->fy_px, fy);
        EXPECT_EQ(recording->camera()->cx_px, cx);
        EXPECT_EQ(recording->camera()->cy_px, cy);
        EXPECT_THAT(recording->notes(), Contains(HasSubstr(fmt::format("Intrinsics fx {}", fx))));
    }
}

TEST(TumRecording, TakesIntrinsicsStereoAndAxesFromTheCaller) {
    const RecordingFolder folder;
    fill_published(folder);
    const auto recording = open_recording(folder.path(), {.world_axes = WorldAxes::east_north_up,
                                                          .intrinsics = {{10, 11, 12, 13}},
                                                          .stereo = StereoNoise{0.075, 0.5}});
    EXPECT_EQ(recording->camera()->cy_px, 13.0);
    EXPECT_EQ(recording->camera()->stereo->baseline_m, 0.075);
    EXPECT_NEAR((recording->navigation()[0].position_m - Eigen::Vector3d(2, 1, -3)).norm(), 0.0,
                1e-12);
}

TEST(TumRecording, SkipsAbsentImagesWithOneWarning) {
    const RecordingFolder folder;
    fill_published(folder);
    std::filesystem::remove(folder.path() / "depth/100.00.png");
    std::filesystem::remove(folder.path() / "depth/100.06.png");
    const auto recording = open_recording(folder.path());
    ASSERT_THAT(recording->frames(), SizeIs(1));
    EXPECT_NEAR(recording->frames()[0].time_s, 100.03, 1e-12);
    EXPECT_THAT(recording->frames()[0].where, HasSubstr("depth.txt:5"));
    ASSERT_THAT(recording->warnings(), SizeIs(1));
    EXPECT_THAT(recording->warnings()[0].problem, HasSubstr("2 of 3 frames listed do not exist"));
    std::filesystem::remove(folder.path() / "depth/100.03.png");
    EXPECT_THAT(opening(folder), refuses("depth.txt", "none of the 3 frames listed exists"));
}

TEST(TumRecording, RefusesBadLists) {
    const RecordingFolder folder;
    fill_published(folder);
    const std::string poses = folder.bytes("groundtruth.txt");
    const auto with_line = [&](const std::string& line) {
        folder.write("groundtruth.txt", poses + line + "\n");
        return opening(folder);
    };
    EXPECT_THAT(with_line("100.05 1 2 3 0 0 0 1"),
                refuses("groundtruth.txt:10", "is earlier than", "sort"));
    EXPECT_THAT(with_line("100.07 1 2 3 0 0 0 1"), refuses("groundtruth.txt:10", "doubles"));
    EXPECT_THAT(with_line("100.08 1 2 3 0 0 0 1.02"),
                refuses("groundtruth.txt:10", "norm 1.0200", "qx qy qz qw"));
    EXPECT_THAT(with_line("100.08 1 2 3 0 0 0 nan"), refuses("groundtruth.txt:10", "qw is 'nan'"));
    EXPECT_THAT(with_line("100.08 1 nan 3 0 0 0 1"), refuses("groundtruth.txt:10", "ty is 'nan'"));
    EXPECT_THAT(with_line("100.08 1 2,5 3 0 0 0 1"),
                refuses("groundtruth.txt:10", "ty is '2,5', which is no number"));
    EXPECT_THAT(with_line("inf 1 2 3 0 0 0 1"), refuses("groundtruth.txt:10", "the time is 'inf'"));
    EXPECT_THAT(with_line("100.08 1 2 3 0 0 0"), refuses("groundtruth.txt:10", "7 fields"));
    folder.write("groundtruth.txt", "# nothing\n");
    EXPECT_THAT(opening(folder), refuses("groundtruth.txt", "no line"));
    folder.write("groundtruth.txt", "");
    EXPECT_THAT(opening(folder), refuses("groundtruth.txt", "empty"));
    std::filesystem::remove(folder.path() / "groundtruth.txt");
    EXPECT_THAT(opening(folder), refuses("groundtruth.txt", "cannot be opened"));

    fill_published(folder);
    folder.write("depth.txt", "100.03 depth/100.03.png\n100.00 depth/100.00.png\n");
    EXPECT_THAT(opening(folder), refuses("depth.txt:2", "is earlier than"));
    folder.write("depth.txt", "100.03 depth/100.03.png\n\n100.03 depth/100.00.png\n");
    EXPECT_THAT(opening(folder), refuses("depth.txt:3", "doubles"));
    folder.write("depth.txt", "100.03\n");
    EXPECT_THAT(opening(folder), refuses("depth.txt:1", "1 fields"));
}

TEST(TumRecording, NormalisesQuaternionsThatAreOffByRounding) {
    const RecordingFolder folder;
    fill_published(folder);
    folder.write("groundtruth.txt", "100.0 0 0 0 0 0 0 0.995\n");
    EXPECT_NEAR(open_recording(folder.path())->navigation()[0].world_from_body.norm(), 1.0, 1e-12);
}

TEST(TumRecording, LeavesDamagedImagesToTheReadingOfTheFrame) {
    const RecordingFolder folder;
    fill_published(folder);
    folder.truncate("depth/100.00.png", 50); // the first image: the size must come from the next
    folder.write_8_bit("depth/100.06.png", 3, 2, true);
    const auto recording = open_recording(folder.path());
    EXPECT_EQ(recording->camera()->width_px, 3);
    EXPECT_THAT([&] { static_cast<void>(recording->read_frame(0)); }, refuses("100.00.png"));
    EXPECT_THAT(recording->read_frame(1).depth_m, SizeIs(6));
    EXPECT_THAT([&] { static_cast<void>(recording->read_frame(2)); },
                refuses("100.06.png", "3 channels of 8 bits"));
    folder.write_depth("depth/100.06.png", 2, stored_depth);
    EXPECT_THAT([&] { static_cast<void>(recording->read_frame(2)); },
                refuses("100.06.png", "2 x 3 pixels", "3 x 2"));
    for (const char* name : {"depth/100.00.png", "depth/100.03.png", "depth/100.06.png"}) {
        folder.write_8_bit(name, 3, 2, false);
    }
    EXPECT_THAT(opening(folder), refuses("100.00.png", "8 bits"));
}

TEST(TumAssociation, TakesTimesFromNamesAndMergesDoubledLines) {
    const RecordingFolder folder;
    folder.write_depth("depth/7.50.png", 3, stored_depth);
    folder.write("my_association.txt",
                 "# rgb depth tx ty tz qx qy qz qw\n"
                 "rgb/7.41.png depth/7.40.png 1 2 3 0 0 0 1 \n"
                 "rgb/7.48.png depth/7.50.png 1.1 2 3 0 0 0 1\n"
                 "rgb/7.52.png depth/7.50.png 9 9 9 0 0 0 1\n"
                 "rgb/8.00.png depth/8.00.png 4 2 3 0 0 0 1\n");
    const auto recording = open_recording(folder.path());
    ASSERT_THAT(recording->frames(), SizeIs(1));
    EXPECT_EQ(recording->frames()[0].time_s, 7.5);
    ASSERT_THAT(recording->navigation(), SizeIs(3)); // poses of absent images count
    EXPECT_EQ(recording->navigation()[1].time_s, 7.5);
    EXPECT_NEAR(recording->navigation()[1].position_m.x(), 1.1, 1e-12);
    EXPECT_NEAR(recording->navigation()[1].velocity_mps.x(), 1.0, 1e-6);
    EXPECT_EQ(recording->navigation()[2].velocity_mps, Eigen::Vector3d::Zero());
    ASSERT_THAT(recording->warnings(), SizeIs(2));
    EXPECT_THAT(recording->warnings()[0].problem, HasSubstr("1 lines name a depth image again"));
    EXPECT_THAT(recording->warnings()[1].problem, HasSubstr("2 of 3 frames"));
}

TEST(TumAssociation, TakesTimesBesideTheFiles) {
    for (const char* line :
         {"7.5 depth/x.png 1 2 3 0 0 0 1\n", "7.5 depth/x.png 7.51 rgb/x.png 1 2 3 0 0 0 1\n",
          "7.51 rgb/x.png 7.5 depth/x.png 1 2 3 0 0 0 1\n",
          "7.51 rgb/x.png 7.5 depth/x.png 7.505 1 2 3 0 0 0 1\n"}) {
        const RecordingFolder folder;
        folder.write_depth("depth/x.png", 3, stored_depth);
        folder.write("association.txt", line);
        const auto recording = open_recording(folder.path());
        ASSERT_THAT(recording->frames(), SizeIs(1)) << line;
        EXPECT_EQ(recording->frames()[0].time_s, 7.5) << line;
        EXPECT_EQ(recording->navigation()[0].time_s, 7.5) << line;
        EXPECT_NEAR(recording->navigation()[0].position_m.x(), 1.0, 1e-12) << line;
    }
}

TEST(TumAssociation, RefusesBadLines) {
    const RecordingFolder folder;
    folder.write_depth("depth/7.50.png", 3, stored_depth);
    folder.write_depth("depth/x.png", 3, stored_depth);
    const auto with_list = [&](const std::string& text) {
        folder.write("association.txt", text);
        return opening(folder);
    };
    EXPECT_THAT(with_list("7.5 rgb/7.5.png 7.5 depth/7.50.png\n"),
                refuses("association.txt:1", "4 fields are too few"));
    EXPECT_THAT(with_list("depth/x.png 1 2 3 0 0 0 1\n"),
                refuses("association.txt:1", "'x', which is no number"));
    EXPECT_THAT(with_list("7.5 1 2 3 0 0 0 1\n"), refuses("association.txt:1", "no depth image"));
    EXPECT_THAT(with_list("depth/7.50.png 1 2 3 0 0 0 1\ndepth/7.4.png 1 2 3 0 0 0 1\n"),
                refuses("association.txt:2", "is earlier than"));
    EXPECT_THAT(with_list("depth/7.50.png 1 2 3 0 0 0 1\n7.5 depth/x.png 1 2 3 0 0 0 1\n"),
                refuses("association.txt:2", "doubles"));
    EXPECT_THAT(with_list("depth/7.50.png 1 2 3 0 0 1 1\n"), refuses("association.txt:1", "norm"));
}

} // namespace
} // namespace zonegrid
