#include "io/npy.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace zonegrid {
namespace {

using testing::RecordingFolder;
using testing::refuses;

constexpr std::array<float, 6> stored_values{1.0F, -2.5F, 3.0F, 0.0F, 1e30F, 6.0F};

auto reading(const std::filesystem::path& file) {
    return [file] { static_cast<void>(read_npy(file)); };
}

TEST(Npy, ReadsVersions1And2) {
    const RecordingFolder folder;
    const auto file = folder.write_npy("a.npy", "(2, 3)", stored_values);
    EXPECT_THAT(read_npy(file).shape, ::testing::ElementsAre(2U, 3U));
    EXPECT_THAT(read_npy(file).values, ::testing::ElementsAreArray(stored_values));

    std::string second = folder.bytes("a.npy");
    second[6] = 2;
    second.insert(10, 2, '\0'); // the length takes four bytes instead of two
    const auto second_file = folder.write("b.npy", second);
    EXPECT_THAT(read_npy(second_file).shape, ::testing::ElementsAre(2U, 3U));
    EXPECT_THAT(read_npy(second_file).values, ::testing::ElementsAreArray(stored_values));
}

TEST(Npy, ReadsOneDimension) {
    const RecordingFolder folder;
    EXPECT_THAT(read_npy(folder.write_npy("a.npy", "(6,)", stored_values)).shape,
                ::testing::ElementsAre(6U));
}

TEST(Npy, RefusesOtherTypesAndOrders) {
    const RecordingFolder folder;
    EXPECT_THAT(reading(folder.write_npy("a.npy", "(3,)", stored_values, "'<f8'")),
                refuses("a.npy", "'<f8'", "float32"));
    EXPECT_THAT(reading(folder.write_npy("b.npy", "(6,)", stored_values, "'>f4'")),
                refuses("b.npy", "'>f4'", "little-endian"));
    EXPECT_THAT(reading(folder.write_npy("c.npy", "(2, 3)", stored_values, "'<f4'", "True")),
                refuses("c.npy", "Fortran order"));
}

TEST(Npy, RefusesEveryTruncation) {
    const RecordingFolder folder;
    const auto file = folder.write_npy("a.npy", "(2, 3)", stored_values);
    const std::string whole = folder.bytes("a.npy");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        folder.write("a.npy", whole.substr(0, size));
        EXPECT_THAT(reading(file), refuses("a.npy")) << "cut to " << size;
    }
    EXPECT_EQ(whole.size(), 128U + 24U);
}

TEST(Npy, RefusesShapesThatDoNotFit) {
    const RecordingFolder folder;
    for (const char* shape :
         {"(2, 2)", "(7,)", "(4294967296, 4294967296, 6)", "(18446744073709551615, 6)", "(-6,)",
          "(2, x)", "(2, 3", "2, 3", "(99999999999999999999999,)", "(0, 6)", "()"}) {
        EXPECT_THAT(reading(folder.write_npy("a.npy", shape, stored_values)),
                    refuses("a.npy", "shape"))
            << shape;
    }
    EXPECT_THAT(reading(folder.write("b.npy", "\x93NUMPY\x03 and so on and on")),
                refuses("b.npy", "version 3"));
    EXPECT_THAT(reading(folder.write("c.npy", "not an array at all")), refuses("c.npy", "no NPY"));
}

} // namespace
} // namespace zonegrid
