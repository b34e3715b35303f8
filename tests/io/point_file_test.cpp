#include "io/point_file.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace zonegrid {
namespace {

using ::testing::ElementsAre;
using testing::RecordingFolder;
using testing::refuses;

constexpr std::array twelve{1.F, 2.F, 3.F, 4.F, 5.F, 6.F, 7.F, 8.F, 9.F, 10.F, 11.F, 12.F};

auto reading(const std::filesystem::path& file, PointFields fields = PointFields::xyz) {
    return [=] { static_cast<void>(read_points(file, fields)); };
}

TEST(PointFile, ReadsBinaryWithAndWithoutReflectance) {
    const RecordingFolder folder;
    const auto file = folder.write_floats("a.bin", twelve);
    EXPECT_THAT(read_points(file, PointFields::xyz),
                ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6),
                            Eigen::Vector3f(7, 8, 9), Eigen::Vector3f(10, 11, 12)));
    EXPECT_THAT(read_points(file, PointFields::xyz_reflectance),
                ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(5, 6, 7),
                            Eigen::Vector3f(9, 10, 11)));
}

TEST(PointFile, ReadsTextAndNpy) {
    const RecordingFolder folder;
    EXPECT_THAT(
        read_points(folder.write("a.txt", "1 2 3 0.5\n4 5 6 0.1\n"), PointFields::xyz_reflectance),
        ElementsAre(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6)));
    EXPECT_EQ(read_points(folder.write_npy("a.npy", "(4, 3)", twelve), PointFields::xyz).size(),
              4U);
}

TEST(PointFile, KeepsNonFinitePointsAsMissingRays) {
    const RecordingFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto points =
        read_points(folder.write_floats("a.bin", std::array{nan, 0.F, 0.F}), PointFields::xyz);
    ASSERT_EQ(points.size(), 1U);
    EXPECT_TRUE(std::isnan(points[0].x()));
}

TEST(PointFile, RefusesTruncatedEmptyAndMisshapenFiles) {
    const RecordingFolder folder;
    const auto file = folder.write_floats("a.bin", twelve);
    folder.truncate("a.bin", 47);
    EXPECT_THAT(reading(file), refuses("a.bin", "47 bytes", "truncated"));
    folder.truncate("a.bin", 44);
    EXPECT_THAT(reading(file, PointFields::xyz_reflectance), refuses("a.bin", "44 bytes"));
    folder.truncate("a.bin", 0);
    EXPECT_THAT(reading(file), refuses("a.bin", "empty"));
    EXPECT_THAT(reading(folder.write("a.txt", "1 2 3\n4 5\n")), refuses("a.txt:2", "2 fields"));
    EXPECT_THAT(reading(folder.write("b.txt", "1 2 3\n4 five 6\n")), refuses("b.txt:2", "five"));
    EXPECT_THAT(reading(folder.write_npy("a.npy", "(3, 4)", twelve)), refuses("a.npy", "N x 3"));
    EXPECT_THAT(reading(folder.write("a.ply", "ply")), refuses("a.ply", ".npy, .bin or .txt"));
}

} // namespace
} // namespace zonegrid
