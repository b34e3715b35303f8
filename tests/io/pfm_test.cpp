#include "io/pfm.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace zonegrid {
namespace {

using testing::RecordingFolder;
using testing::refuses;

/// Rows bottom first, as the format has them: the picture is 1 2 3 over 4 5 6.
constexpr std::array<float, 6> file_order{4.0F, 5.0F, 6.0F, 1.0F, 2.0F, 3.0F};

std::string pfm(const std::string& header, bool big_endian) {
    std::string bytes = header;
    for (const float value : file_order) {
        std::array<char, 4> four{};
        std::memcpy(four.data(), &value, 4);
        if (big_endian) {
            std::ranges::reverse(four);
        }
        bytes.append(four.data(), 4);
    }
    return bytes;
}

auto reading(const std::filesystem::path& file) {
    return [file] { static_cast<void>(read_pfm(file)); };
}

TEST(Pfm, ReadsBothByteOrdersTopRowFirst) {
    const RecordingFolder folder;
    for (const bool big_endian : {false, true}) {
        const std::string header = big_endian ? "Pf\n3 2\n1.0\n" : "Pf\n3 2\n-1.0\n";
        const PfmImage image = read_pfm(folder.write("a.pfm", pfm(header, big_endian)));
        EXPECT_EQ(image.size, (ImageSize{3, 2}));
        EXPECT_THAT(image.values, ::testing::ElementsAre(1, 2, 3, 4, 5, 6));
    }
}

TEST(Pfm, RefusesEveryTruncation) {
    const RecordingFolder folder;
    const std::string whole = pfm("Pf\n3 2\n-1.0\n", false);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_THAT(reading(folder.write("a.pfm", whole.substr(0, size))), refuses("a.pfm"))
            << "cut to " << size;
    }
}

TEST(Pfm, RefusesColoursAndAbsurdSizes) {
    const RecordingFolder folder;
    EXPECT_THAT(reading(folder.write("a.pfm", pfm("PF\n1 2\n-1.0\n", false))),
                refuses("a.pfm", "colours"));
    for (const char* header : {"Pf\n0 2\n-1\n", "Pf\n3 -2\n-1\n", "Pf\n1e9 1e9\n-1\n",
                               "Pf\n3 two\n-1\n", "Pf\n3 2\nnan\n", "P5\n3 2\n-1\n"}) {
        EXPECT_THAT(reading(folder.write("b.pfm", pfm(header, false))), refuses("b.pfm")) << header;
    }
}

} // namespace
} // namespace zonegrid
