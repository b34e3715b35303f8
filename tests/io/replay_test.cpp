#include "io/replay.h"

#include "io/recording_folder.h"

#include <limits>
#include <stdexcept>

namespace zonegrid::testing {
namespace {

/// A recording in memory: navigation at 100 Hz for a second, images of two pixels 2 m away.
class MemoryRecording : public Recording {
public:
    explicit MemoryRecording(const std::vector<double>& image_times_s)
        : Recording(contents(image_times_s)) {}

    [[nodiscard]] FrameData read_frame(std::size_t index) const override {
        require_frame(index);
        if (index == damaged) {
            throw InputError("image", "it is damaged", "copy it again");
        }
        return {{2.0F, std::numeric_limits<float>::quiet_NaN()}, {}};
    }

    std::size_t damaged = std::numeric_limits<std::size_t>::max();

private:
    static RecordingContents contents(const std::vector<double>& image_times_s) {
        RecordingContents contents;
        Camera camera;
        camera.width_px = 2;
        camera.height_px = 1;
        camera.fx_px = camera.fy_px = 10.0;
        camera.body_from_camera.linear() = body_from_forward_camera();
        contents.camera = camera;
        for (int i = 0; i <= 100; ++i) {
            NavigationSample sample;
            sample.time_s = 0.01 * i;
            sample.position_m.x() = 0.01 * i;
            contents.navigation.push_back(sample);
        }
        for (const double time_s : image_times_s) {
            contents.frames.push_back({time_s, "image", "list:1"});
        }
        return contents;
    }
};

MapperOptions options_for_test() {
    MapperOptions options;
    options.cell_m = 0.1;
    options.range_m = 4.0;
    return options;
}

ReplaySummary replay_all(const MemoryRecording& recording, const FrameSpan& span = {}) {
    Mapper mapper(options_for_test(), recording.camera());
    return replay(recording, span, mapper, [](const ReplaySummary&) {});
}

TEST(Replay, HandsOverNavigationUpToTheGapAfterAnImage) {
    // 0.306 s is nearest to the sample at 0.31 s, which comes after it: were it not handed over,
    // the pose would come from 0.30 s, and the x positions, constant between, differ.
    const ReplaySummary summary = replay_all(MemoryRecording({0.306, 0.5, 1.04, 1.06}));
    EXPECT_EQ(summary.images, 4U);
    EXPECT_EQ(summary.integrated, 3U);
    EXPECT_EQ(summary.skipped[static_cast<std::size_t>(SkipReason::no_navigation)], 1U);
    ASSERT_EQ(summary.trajectory_m.size(), 3U);
    EXPECT_EQ(summary.trajectory_m[0].x(), 0.31);
    EXPECT_EQ(summary.trajectory_m[1].x(), 0.5);
    EXPECT_EQ(summary.trajectory_m[2].x(), 1.0);
    EXPECT_EQ(summary.rays, 3U);
    EXPECT_EQ(summary.missing, 3U);
    EXPECT_EQ(summary.least_distance_m, 2.0);
}

TEST(Replay, CountsDamagedImagesAndGoesOn) {
    MemoryRecording recording({0.1, 0.2, 0.3});
    recording.damaged = 1;
    const ReplaySummary summary = replay_all(recording);
    EXPECT_EQ(summary.integrated, 2U);
    EXPECT_EQ(summary.skipped[static_cast<std::size_t>(SkipReason::damaged)], 1U);
    ASSERT_EQ(summary.skipped_first.size(), 1U);
    EXPECT_THAT(summary.skipped_first[0].problem, ::testing::HasSubstr("it is damaged"));
}

TEST(Replay, TakesOnlyTheSpan) {
    const MemoryRecording recording({0.1, 0.2, 0.3, 0.4});
    EXPECT_EQ(replay_all(recording, {1, 3}).images, 2U);
    EXPECT_EQ(replay_all(recording, {1, 3}).trajectory_m[0].x(), 0.2);
    EXPECT_EQ(replay_all(recording, {2, 99}).images, 2U);
}

TEST(Replay, StopsWhereTheObserverThrows) {
    const MemoryRecording recording({0.1, 0.2, 0.3, 0.4});
    Mapper mapper(options_for_test(), recording.camera());
    std::size_t calls = 0;
    const auto observer = [&calls](const ReplaySummary& so_far) {
        EXPECT_EQ(so_far.images, calls);
        if (++calls == 3) {
            throw std::runtime_error("stop");
        }
    };
    EXPECT_THROW(static_cast<void>(replay(recording, {}, mapper, observer)), std::runtime_error);
}

TEST(StageTimes, HaveNearestRankPercentiles) {
    StageTimes times;
    EXPECT_EQ(times.percentile_s(0.5), 0.0);
    for (int i = 20; i >= 1; --i) {
        times.seconds.push_back(i);
    }
    EXPECT_EQ(times.percentile_s(0.5), 10.0);
    EXPECT_EQ(times.percentile_s(0.95), 19.0);
    EXPECT_EQ(times.percentile_s(1.0), 20.0);
    EXPECT_EQ(times.percentile_s(0.0), 1.0);
    EXPECT_EQ(times.total_s(), 210.0);
}

} // namespace
} // namespace zonegrid::testing
