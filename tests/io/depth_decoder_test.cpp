#include "io/depth_decoder.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace zonegrid {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatEq;
using ::testing::IsNan;
using testing::RecordingFolder;
using testing::refuses;

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

Camera camera_3x2() {
    Camera camera;
    camera.width_px = 3;
    camera.height_px = 2;
    camera.fx_px = 2.0;
    camera.fy_px = 2.0;
    camera.cx_px = 1.0;
    camera.cy_px = 0.0;
    return camera;
}

TEST(DepthDecoder, ScalesPngAndMarksMissingAndInfinite) {
    const RecordingFolder folder;
    const auto file =
        folder.write_depth("a.png", 3, std::array<std::uint16_t, 6>{0, 1000, 65535, 65534, 7, 1});
    const DepthDecoder decoder(
        {.units_per_m = 1000.0, .missing = {0.0F, 65535.0F}, .infinite = {65534.0F}}, camera_3x2());
    EXPECT_THAT(decoder.decode(file), ElementsAre(IsNan(), FloatEq(1.0F), IsNan(), infinite,
                                                  FloatEq(0.007F), FloatEq(0.001F)));
}

TEST(DepthDecoder, TakesZeroNegativeAndNanAsMissingWhateverTheListSays) {
    const RecordingFolder folder;
    const auto file = folder.write_npy(
        "a.npy", "(2, 3)", std::array{0.0F, -1.0F, not_a_number, -infinite, infinite, 99.9F});
    const DepthDecoder decoder({.missing = {99.9F}}, camera_3x2());
    EXPECT_THAT(decoder.decode(file),
                ElementsAre(IsNan(), IsNan(), IsNan(), IsNan(), infinite, IsNan()));
}

TEST(DepthDecoder, TurnsRayDistancesIntoAxisDistances) {
    const RecordingFolder folder;
    const auto file = folder.write_npy("a.npy", "(2, 3)", std::array{1.F, 1.F, 1.F, 1.F, 1.F, 1.F});
    const DepthDecoder decoder({.kind = DepthKind::ray}, camera_3x2());
    const float side = 1.0F / std::sqrt(1.25F);
    const float corner = 1.0F / std::sqrt(1.5F);
    EXPECT_THAT(decoder.decode(file), ElementsAre(FloatEq(side), FloatEq(1.0F), FloatEq(side),
                                                  FloatEq(corner), FloatEq(side), FloatEq(corner)));

    Camera table = camera_3x2();
    table.directions.assign(6, Eigen::Vector2f(2.0F, 2.0F));
    EXPECT_THAT(DepthDecoder({.kind = DepthKind::ray}, table).decode(file),
                ::testing::Each(FloatEq(1.0F / 3.0F)));
}

TEST(DepthDecoder, RefusesOtherSizesShapesAndEndings) {
    const RecordingFolder folder;
    const DepthDecoder decoder({}, camera_3x2());
    const auto decoding = [&](const std::filesystem::path& file) {
        return [&decoder, file] { static_cast<void>(decoder.decode(file)); };
    };
    const std::array six{1.F, 1.F, 1.F, 1.F, 1.F, 1.F};
    EXPECT_THAT(decoding(folder.write_npy("turned.npy", "(3, 2)", six)),
                refuses("turned.npy", "2 x 3", "3 x 2"));
    EXPECT_THAT(decoding(folder.write_npy("flat.npy", "(6,)", six)),
                refuses("flat.npy", "height x width"));
    EXPECT_THAT(decoding(folder.write_depth("small.png", 2, std::array<std::uint16_t, 4>{})),
                refuses("small.png", "2 x 2", "3 x 2"));
    EXPECT_THAT(decoding(folder.write("a.jpg", "x")), refuses("a.jpg", ".png, .npy or .pfm"));
}

TEST(DepthDecoder, RefusesAbsurdScales) {
    for (const double scale : {0.0, -1000.0, infinite * 1.0, std::nan(""), 1e-300, 1e300}) {
        EXPECT_THROW(DepthDecoder({.units_per_m = scale}, camera_3x2()), UsageError) << scale;
    }
}

} // namespace
} // namespace zonegrid
