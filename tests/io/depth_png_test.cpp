#include "io/depth_png.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>

namespace zonegrid {
namespace {

using testing::RecordingFolder;
using testing::refuses;

constexpr std::array<std::uint16_t, 6> stored_values{0, 1, 255, 256, 5000, 65535};

TEST(DepthPng, KeepsAll16BitsAndTheOrderOfPixels) {
    const RecordingFolder folder;
    const auto file = folder.write_depth("a.png", 3, stored_values);
    const DepthPng image = read_depth_png(file);
    EXPECT_EQ(image.size, (ImageSize{3, 2}));
    EXPECT_THAT(image.values, ::testing::ElementsAreArray(stored_values));
    EXPECT_EQ(read_depth_png_size(file), (ImageSize{3, 2}));
}

TEST(DepthPng, RefusesEveryTruncation) {
    const RecordingFolder folder;
    const auto file = folder.write_depth("a.png", 3, stored_values);
    const std::string whole = folder.bytes("a.png");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        folder.write("a.png", whole.substr(0, size));
        EXPECT_THAT([&] { static_cast<void>(read_depth_png(file)); }, refuses("a.png"))
            << "cut to " << size << " of " << whole.size() << " bytes";
    }
    EXPECT_GT(whole.size(), 60U);
}

TEST(DepthPng, RefusesEveryFlippedBitInThePixels) {
    const RecordingFolder folder;
    const auto file = folder.write_depth("a.png", 3, stored_values);
    const std::string whole = folder.bytes("a.png");
    const std::size_t data = whole.find("IDAT") + 4;
    const std::size_t end = whole.find("IEND") - 4;
    ASSERT_LT(data, end);
    for (std::size_t at = data; at < end; ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        folder.write("a.png", damaged);
        EXPECT_THAT([&] { static_cast<void>(read_depth_png(file)); },
                    refuses("a.png", "cannot be decoded"))
            << "byte " << at;
    }
}

TEST(DepthPng, RefusesOtherBitDepthsAndSays) {
    const RecordingFolder folder;
    const auto grey = folder.write_8_bit("grey.png", 4, 3, false);
    const auto colour = folder.write_8_bit("colour.png", 4, 3, true);
    EXPECT_THAT([&] { static_cast<void>(read_depth_png(grey)); },
                refuses("grey.png", "1 channel of 8 bits", "16-bit grey"));
    EXPECT_THAT([&] { static_cast<void>(read_depth_png_size(colour)); },
                refuses("colour.png", "3 channels of 8 bits", "16-bit grey"));
}

TEST(DepthPng, RefusesWhatIsNoPngOrIsTooLarge) {
    const RecordingFolder folder;
    const auto text = folder.write("text.png", "this is no image at all, only a text");
    EXPECT_THAT([&] { static_cast<void>(read_depth_png(text)); }, refuses("text.png"));
    const auto wide = folder.write_depth("wide.png", largest_image_px + 1,
                                         std::vector<std::uint16_t>(largest_image_px + 1));
    EXPECT_THAT([&] { static_cast<void>(read_depth_png(wide)); }, refuses("wide.png"));
    EXPECT_THAT([&] { static_cast<void>(read_depth_png(folder.path() / "none.png")); },
                refuses("none.png", "cannot be opened"));
}

} // namespace
} // namespace zonegrid
