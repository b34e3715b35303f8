#include "io/map_comparison.h"

#include "pipeline/reference_engine.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <vector>

// Two maps that differ on purpose: by their options.

namespace zonegrid {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t every = 4;

/// A camera that stands still before a wall, ten images long.
class Wall : public Recording {
public:
    Wall() : Recording(contents()) {}

    [[nodiscard]] FrameData read_frame(std::size_t index) const override {
        require_frame(index);
        return {std::vector<float>(12 * 8, 3.2F), {}};
    }

private:
    static RecordingContents contents() {
        RecordingContents contents;
        contents.layout = "wall";
        Camera camera;
        camera.width_px = 12;
        camera.height_px = 8;
        camera.fx_px = camera.fy_px = 10.0;
        camera.cx_px = 5.5;
        camera.cy_px = 3.5;
        contents.camera = camera;
        for (int i = 1; i <= 10; ++i) {
            NavigationSample sample;
            sample.time_s = 0.1 * i;
            contents.navigation.push_back(sample);
            contents.frames.push_back(
                {sample.time_s, "image" + std::to_string(i) + ".png", "list:" + std::to_string(i)});
        }
        return contents;
    }
};

MapperOptions options_with_limit(int limit) {
    MapperOptions options;
    options.cell_m = 0.5;
    options.range_m = 6.0;
    options.limit = limit;
    return options;
}

std::optional<MapDifference> compare(const MapperOptions& expected, const MapperOptions& actual,
                                     std::size_t digest_every = every) {
    const Wall wall;
    const FrameSpan span{0, wall.frames().size()};
    const auto watch = [](const ReplaySummary&) {};
    return find_difference(wall, span, {expected},
                           take_steps(wall, span, {expected}, digest_every, watch), {actual},
                           digest_every, watch);
}

TEST(MapComparison, FindsNothingBetweenEqualMaps) {
    EXPECT_FALSE(compare(options_with_limit(8), options_with_limit(8)).has_value());
}

TEST(MapComparison, TakesDigestsNowAndThenAndAtTheEnd) {
    const Wall wall;
    const auto steps =
        take_steps(wall, {0, 10}, {options_with_limit(8)}, every, [](const ReplaySummary&) {});
    ASSERT_EQ(steps.size(), 11U);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_EQ(steps[i].digest.empty(), i % every != 0 && i != 10) << i;
    }
}

TEST(MapComparison, FindsTheFirstImageAndCellWhereValuesPart) {
    // Hits add 2: the values are 2, 4, 6, 8 and stay there, or stay at 7 from the fourth image on.
    const auto difference = compare(options_with_limit(8), options_with_limit(7));
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->images, 4U);
    EXPECT_EQ(difference->frame, "image4.png");
    EXPECT_EQ(difference->what, "cells");
    EXPECT_THAT(difference->detail, HasSubstr("value 7, expected value 8"));
    EXPECT_THAT(difference->detail, HasSubstr("in zone (-1, -1, 0)"));
    EXPECT_EQ(difference->operation, "fuse_local_map");
}

/// The reference, but sees nothing from the fifth image on.
class BlindFromTheFifth final : public ReferenceEngine {
public:
    using ReferenceEngine::ReferenceEngine;
    void integrate_image(const ImageRays& rays) override {
        ImageRays seen = rays;
        if (++images_ >= 5) {
            std::ranges::fill(seen.depths, PixelDepth{});
        }
        ReferenceEngine::integrate_image(seen);
    }

private:
    int images_ = 0;
};

TEST(MapComparison, FindsWhatAnImageSaysWhereCellsAreAtTheirLimits) {
    // After the first image all cells are at their limits: only the local maps still tell.
    auto options = options_with_limit(1);
    options.hit = options.threshold = 1;
    const auto blind = [](const MapperOptions& chosen, const std::optional<Camera>&,
                          const Window& window) {
        return std::make_unique<BlindFromTheFifth>(chosen, window);
    };
    const Wall wall;
    const auto watch = [](const ReplaySummary&) {};
    const auto steps = take_steps(wall, {0, 10}, {options}, every, watch);
    const auto difference =
        find_difference(wall, {0, 10}, {options}, steps, {options, blind}, every, watch);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->images, 5U);
    EXPECT_EQ(difference->what, "local map");
    EXPECT_EQ(difference->operation, "integrate_image");
    EXPECT_THAT(difference->detail, HasSubstr("): nothing, expected "));
}

TEST(MapComparison, FindsObjectsThatPartWhereCellsDoNot) {
    auto later = options_with_limit(8);
    later.threshold = 3;
    // Only after the first image, before the cells are at their limit, and between two digests.
    EXPECT_FALSE(compare(options_with_limit(8), later).has_value());
    const auto difference = compare(options_with_limit(8), later, 1);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->images, 1U);
    EXPECT_EQ(difference->what, "objects");
    EXPECT_THAT(difference->detail, HasSubstr("none, expected"));
    EXPECT_THAT(difference->operation, HasSubstr("label_components"));
}

} // namespace
} // namespace zonegrid
