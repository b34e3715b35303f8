#include "io/profile_picture.h"

#include "io/colour_map.h"
#include "io/profile_picture_canvas.h"
#include "io/profile_picture_layout.h"
#include "io/profile_picture_range.h"
#include "zonegrid/errors.h"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace zonegrid {
namespace {

using testing::HasSubstr;

using Draw = void (*)(const HeightProfile&, std::span<const Eigen::Vector3d>,
                      const ProfilePictureOptions&, const std::filesystem::path&);

/// A PNG as cairo reads it back.
class Picture {
public:
    explicit Picture(const std::filesystem::path& file)
        : surface_(cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy) {
        EXPECT_EQ(cairo_surface_status(surface_.get()), CAIRO_STATUS_SUCCESS) << file;
    }
    [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_.get()); }
    [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_.get()); }
    [[nodiscard]] Rgb at(double x_px, double y_px) const {
        const auto x = static_cast<std::ptrdiff_t>(std::floor(x_px));
        const auto y = static_cast<std::ptrdiff_t>(std::floor(y_px));
        if (x < 0 || y < 0 || x >= width() || y >= height()) {
            ADD_FAILURE() << "no pixel " << x << ", " << y;
            return {};
        }
        std::uint32_t word = 0;
        std::memcpy(&word,
                    cairo_image_surface_get_data(surface_.get()) +
                        y * cairo_image_surface_get_stride(surface_.get()) + 4 * x,
                    sizeof(word));
        return {static_cast<std::uint8_t>(word >> 16U), static_cast<std::uint8_t>(word >> 8U),
                static_cast<std::uint8_t>(word)};
    }

private:
    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
};

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class ProfilePicture : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) /
                  (std::string("profile_picture_") + test->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        options_.width_px = 640;
        options_.height_px = 480;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    Picture plan(const HeightProfile& profile, std::span<const Eigen::Vector3d> trajectory_m = {}) {
        draw_profile(profile, trajectory_m, options_, folder_ / "plan.png");
        return Picture(folder_ / "plan.png");
    }
    [[nodiscard]] ProfileLayout layout(const HeightProfile& profile) const {
        return layout_profile(picture_frame(options_.width_px, options_.height_px),
                              ground_plan(profile, {}), profile.cell_m);
    }
    [[nodiscard]] std::size_t file_count() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

    std::filesystem::path folder_;
    ProfilePictureOptions options_;
};

/// Pixel in the middle of column (x, y).
Rgb colour_of_column(const Picture& picture, const ProfileLayout& layout, double cell_m, int x,
                     int y) {
    return picture.at(layout.x_px((y + 0.5) * cell_m), layout.y_px((x + 0.5) * cell_m));
}

TEST_F(ProfilePicture, PutsASingleColumnWhereTheLayoutSays) {
    const HeightProfile profile{0.5, {{7, -3, -4}}};
    const Picture picture = plan(profile);
    const ProfileLayout place = layout(profile);
    EXPECT_EQ(colour_of_column(picture, place, 0.5, 7, -3), height_colour(0.0));
    for (const auto& [x, y] : {std::pair{8, -3}, {6, -3}, {7, -2}, {7, -4}}) {
        EXPECT_EQ(colour_of_column(picture, place, 0.5, x, y), unknown_colour) << x << ", " << y;
    }
    // Crisp to its last pixel.
    const double left_px = place.x_px(-1.5);
    const double top_px = place.y_px(4.0);
    EXPECT_EQ(picture.at(left_px + 0.5, top_px + 0.5), height_colour(0.0));
    EXPECT_EQ(picture.at(left_px - 0.5, top_px + 0.5), unknown_colour);
    EXPECT_EQ(picture.at(left_px + 0.5, top_px - 0.5), unknown_colour);
}

TEST_F(ProfilePicture, HasNorthUpAndEastRight) {
    const HeightProfile profile{1.0, {{0, 0, 0}, {0, 9, 0}, {9, 0, -10}}};
    const Picture picture = plan(profile);
    const ProfileLayout place = layout(profile);
    EXPECT_EQ(colour_of_column(picture, place, 1.0, 0, 0), height_colour(0.0));
    EXPECT_EQ(colour_of_column(picture, place, 1.0, 0, 9), height_colour(0.0));
    EXPECT_EQ(colour_of_column(picture, place, 1.0, 9, 0), height_colour(1.0));
    EXPECT_LT(place.y_px(9.5), place.y_px(0.5));
    EXPECT_GT(place.x_px(9.5), place.x_px(0.5));
    // Where the high column would be if north were right or down.
    EXPECT_EQ(colour_of_column(picture, place, 1.0, 9, 9), unknown_colour);
}

TEST_F(ProfilePicture, ColoursHeightsByTheirShareOfTheRange) {
    // Two cells apart, so that no column has a slope.
    const HeightProfile profile{1.0, {{0, 0, 0}, {0, 2, -1}, {0, 4, -2}, {0, 6, -3}, {0, 8, -4}}};
    const Picture picture = plan(profile);
    const ProfileLayout place = layout(profile);
    for (int i = 0; i <= 4; ++i) {
        const Rgb seen = colour_of_column(picture, place, 1.0, 0, 2 * i);
        const Rgb expected = height_colour(i / 4.0);
        EXPECT_NEAR(seen.r, expected.r, 2) << i;
        EXPECT_NEAR(seen.g, expected.g, 2) << i;
        EXPECT_NEAR(seen.b, expected.b, 2) << i;
    }
}

TEST_F(ProfilePicture, LightsSlopesFromTheNorthWest) {
    HeightProfile profile{1.0, {}};
    for (int x = 0; x < 10; ++x) {
        for (int y = 0; y < 10; ++y) {
            const bool roof = x >= 3 && x <= 6 && y >= 3 && y <= 6;
            profile.columns.push_back({x, y, roof ? -2 : 0});
        }
    }
    const Picture picture = plan(profile);
    const ProfileLayout place = layout(profile);
    const auto sum = [&](int x, int y) {
        const Rgb colour = colour_of_column(picture, place, 1.0, x, y);
        return colour.r + colour.g + colour.b;
    };
    // The roof's edge tiles slope towards the ground beside them.
    EXPECT_GT(sum(5, 3), sum(4, 5));
    EXPECT_LT(sum(5, 6), sum(4, 5));
    EXPECT_GT(sum(6, 5), sum(4, 5));
    EXPECT_LT(sum(3, 5), sum(4, 5));
}

TEST_F(ProfilePicture, ShowsTheHighestOfTheColumnsInAPixel) {
    // Ground columns far apart stretch the plan, so that a pixel holds more than 5 x 5 columns.
    HeightProfile profile{1.0, {{0, 0, 0}, {3000, 4000, 0}}};
    for (int x = 1500; x < 1530; ++x) {
        for (int y = 2000; y < 2030; ++y) {
            profile.columns.push_back({x, y, x == 1515 && y == 2015 ? -500 : -250});
        }
    }
    std::ranges::sort(profile.columns);
    const Picture picture = plan(profile);
    const ProfileLayout place = layout(profile);
    ASSERT_LT(place.px_per_m, 0.2);
    const HeightRange range = height_ranges(profile, ground_plan(profile, {})).colour;
    ASSERT_TRUE(range.some_above); // one in 902 columns
    const Rgb peak = colour_of_column(picture, place, 1.0, 1515, 2015);
    const Rgb beside = colour_of_column(picture, place, 1.0, 1505, 2005);
    EXPECT_NE(peak, beside);
    EXPECT_EQ(peak, height_colour(1.0));
    EXPECT_NE(colour_of_column(picture, place, 1.0, 0, 0), unknown_colour);
}

TEST_F(ProfilePicture, LeavesNoGapsBetweenColumnsOfAnySize) {
    for (const int side : {3, 40, 170, 390, 401, 900}) {
        HeightProfile profile{0.1, {}};
        for (int x = 0; x < side; ++x) {
            for (int y = 0; y < side; ++y) {
                profile.columns.push_back({x, y, 5});
            }
        }
        const Picture picture = plan(profile);
        const ProfileLayout place = layout(profile);
        int looked_at = 0;
        for (double y_px = std::ceil(place.y_px(side * 0.1)) + 1.5; y_px < place.y_px(0.0) - 1.0;
             y_px += 1.0) {
            for (double x_px = std::ceil(place.x_px(0.0)) + 1.5;
                 x_px < place.x_px(side * 0.1) - 1.0; x_px += 1.0) {
                ASSERT_EQ(picture.at(x_px, y_px), height_colour(0.0))
                    << "side " << side << ", pixel " << x_px << ", " << y_px;
                ++looked_at;
            }
        }
        EXPECT_GT(looked_at, 5000) << "side " << side;
    }
}

TEST_F(ProfilePicture, DrawsTheTrajectoryAndPassesOverPointsThatCannotBe) {
    options_.width_px = 1200; // the line is wider than a pixel
    options_.height_px = 900;
    HeightProfile profile{1.0, {}};
    for (int x = 0; x < 20; ++x) {
        for (int y = 0; y < 20; ++y) {
            profile.columns.push_back({x, y, 0});
        }
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<Eigen::Vector3d> clean = {{4.0, 4.0, -3.0}, {4.0, 16.0, -3.0}};
    std::vector<Eigen::Vector3d> dirty = clean;
    dirty.insert(dirty.begin(), {nan, 0.0, 0.0});
    dirty.emplace_back(0.0, infinity, 0.0);
    dirty.emplace_back(0.0, 0.0, 1e30);
    for (const Draw draw : {draw_profile, draw_profile_3d}) {
        draw(profile, {}, options_, folder_ / "without.png");
        draw(profile, clean, options_, folder_ / "clean.png");
        draw(profile, dirty, options_, folder_ / "dirty.png");
        EXPECT_EQ(bytes_of(folder_ / "clean.png"), bytes_of(folder_ / "dirty.png"));
        EXPECT_NE(bytes_of(folder_ / "clean.png"), bytes_of(folder_ / "without.png"));
    }
    const Picture picture = plan(profile, clean);
    const ProfileLayout place = layout(profile);
    EXPECT_EQ(picture.at(place.x_px(10.0), place.y_px(4.0)), path_colour);
    EXPECT_EQ(picture.at(place.x_px(4.0), place.y_px(4.0)), start_colour);
    EXPECT_EQ(picture.at(place.x_px(16.0), place.y_px(4.0)), end_colour);
}

TEST_F(ProfilePicture, IsAnRgbPngOfTheSizeAskedFor) {
    options_.width_px = 517;
    options_.height_px = 333;
    for (const Draw draw : {draw_profile, draw_profile_3d}) {
        draw({0.1, {{0, 0, 0}}}, {}, options_, folder_ / "size.png");
        const Picture picture(folder_ / "size.png");
        EXPECT_EQ(picture.width(), 517);
        EXPECT_EQ(picture.height(), 333);
        const std::string bytes = bytes_of(folder_ / "size.png");
        ASSERT_GT(bytes.size(), 26U);
        EXPECT_EQ(bytes[24], 8); // bits a channel
        EXPECT_EQ(bytes[25], 2); // red, green, blue
    }
}

TEST_F(ProfilePicture, SaysThatAnEmptyProfileHasNoCells) {
    for (const Draw draw : {draw_profile, draw_profile_3d}) {
        draw({}, {}, options_, folder_ / "empty.png");
        const Picture picture(folder_ / "empty.png");
        ASSERT_EQ(picture.width(), 640);
        const PictureFrame frame = picture_frame(640, 480);
        EXPECT_EQ(picture.at(frame.left_px + 2, frame.top_px + 2), unknown_colour);
        int written = 0;
        const int middle_px = frame.top_px + frame.height_px / 2 - 5;
        for (int x = frame.left_px; x < frame.right_px(); ++x) {
            written += picture.at(x, middle_px) == unknown_colour ? 0 : 1;
        }
        EXPECT_GT(written, 20);
    }
}

TEST_F(ProfilePicture, TakesTitlesOfAnyBytes) {
    const HeightProfile profile{1.0, {{0, 0, 0}, {4, 4, -3}}};
    draw_profile(profile, {}, options_, folder_ / "untitled.png");
    options_.title = "caf\xC3\xA9 \xFF\xC3 \xED\xA0\x80 \xF0\x9F";
    options_.subtitle = std::string(5000, 'x') + "\xE2\x82\xAC";
    draw_profile(profile, {}, options_, folder_ / "titled.png");
    // cairo would stop drawing at the first bad byte: the axes below must still be there.
    const Picture untitled(folder_ / "untitled.png");
    const Picture titled(folder_ / "titled.png");
    const PictureFrame frame = picture_frame(640, 480);
    int title_pixels = 0;
    for (int y = 0; y < 480; ++y) {
        for (int x = 0; x < 640; ++x) {
            if (y < frame.top_px - 4) {
                title_pixels += titled.at(x, y) == paper_colour ? 0 : 1;
            } else {
                ASSERT_EQ(titled.at(x, y), untitled.at(x, y)) << x << ", " << y;
            }
        }
    }
    EXPECT_GT(title_pixels, 500);
}

TEST_F(ProfilePicture, NamesTheFileItCannotWriteAndLeavesNothing) {
    const HeightProfile profile{1.0, {{0, 0, 0}}};
    std::ofstream(folder_ / "file") << "in the way";
    std::filesystem::create_directory(folder_ / "folder.png");
    for (const Draw draw : {draw_profile, draw_profile_3d}) {
        for (const auto& file : {folder_ / "missing" / "picture.png", folder_ / "file" / "x.png",
                                 folder_ / "folder.png"}) {
            try {
                draw(profile, {}, options_, file);
                ADD_FAILURE() << file << " was written";
            } catch (const OutputError& error) {
                EXPECT_THAT(error.what(), HasSubstr(file.string()));
                EXPECT_THAT(error.what(), HasSubstr("choose another"));
            }
        }
    }
    EXPECT_EQ(file_count(), 2U); // what stood there before
    EXPECT_EQ(bytes_of(folder_ / "file"), "in the way");
}

TEST_F(ProfilePicture, RefusesSizesThatCannotWork) {
    const HeightProfile profile{1.0, {{0, 0, 0}}};
    for (const Draw draw : {draw_profile, draw_profile_3d}) {
        for (const auto& [width, height] :
             {std::pair{399, 480}, {640, 299}, {8193, 480}, {-1, -1}}) {
            options_.width_px = width;
            options_.height_px = height;
            EXPECT_THROW(draw(profile, {}, options_, folder_ / "x.png"), UsageError);
            EXPECT_THROW(draw({}, {}, options_, folder_ / "x.png"), UsageError);
        }
        options_ = {640, 480, {}, {}};
        EXPECT_THROW(draw({0.0, {{0, 0, 0}}}, {}, options_, folder_ / "x.png"), UsageError);
    }
    EXPECT_EQ(file_count(), 0U);
}

} // namespace
} // namespace zonegrid
