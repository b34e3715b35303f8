#include "io/replay.h"

#include "pipeline/stopwatch.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace zonegrid {
namespace {

constexpr std::size_t skipped_listed = 10;

/// The reason behind a status other than `integrated`.
SkipReason reason_of(ImageStatus status) {
    switch (status) {
        case ImageStatus::no_navigation:
            return SkipReason::no_navigation;
        case ImageStatus::pose_out_of_range:
            return SkipReason::pose_out_of_range;
        default:
            return SkipReason::out_of_order;
    }
}

std::string describe(SkipReason reason, double max_gap_s) {
    switch (reason) {
        case SkipReason::no_navigation:
            return fmt::format("no navigation sample within {} s", max_gap_s);
        case SkipReason::pose_out_of_range:
            return "the sensor is more than 2^30 cells from the origin";
        default:
            return "its time is not after the image before";
    }
}

double least_depth_m(std::span<const float> depth_m) {
    float least = std::numeric_limits<float>::infinity();
    for (const float depth : depth_m) {
        least = depth > 0.0F && depth < least ? depth : least; // false for NaN
    }
    return static_cast<double>(least);
}

double least_range_m(std::span<const Eigen::Vector3f> ends_m) {
    float least = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& end : ends_m) {
        const float range = end.norm();
        least = range > 0.0F && range < least ? range : least;
    }
    return static_cast<double>(least);
}

/// One run over a recording.
class Replay {
public:
    Replay(const Recording& recording, Mapper& mapper) : recording_(recording), mapper_(mapper) {}

    void run(const FrameSpan& span, const ReplayObserver& observer) {
        const std::size_t last = std::min(span.last, recording_.frames().size());
        for (std::size_t index = span.first; index < last; ++index) {
            observer(summary_);
            ++summary_.images;
            hand_over_navigation(recording_.frames()[index].time_s);
            add_frame(index);
        }
        observer(summary_);
    }

    [[nodiscard]] ReplaySummary take() { return std::move(summary_); }

private:
    void hand_over_navigation(double image_time_s) {
        const auto& samples = recording_.navigation();
        const double until_s = image_time_s + mapper_.options().max_gap_s;
        for (; next_sample_ < samples.size() && samples[next_sample_].time_s <= until_s;
             ++next_sample_) {
            mapper_.add_navigation(samples[next_sample_]);
        }
    }

    void add_frame(std::size_t index) {
        Stopwatch stopwatch;
        const FrameEntry& entry = recording_.frames()[index];
        FrameData data;
        try {
            data = recording_.read_frame(index);
        } catch (const InputError& error) {
            skip(entry.file.string(), SkipReason::damaged, error.what());
            return;
        }
        const double read_s = stopwatch.lap_s();
        const ImageResult result = add(entry, data);
        const double map_s = stopwatch.lap_s();
        if (result.status != ImageStatus::integrated) {
            const SkipReason reason = reason_of(result.status);
            skip(entry.file.string(), reason, describe(reason, mapper_.options().max_gap_s));
            return;
        }
        summary_.least_distance_m = std::min(
            {summary_.least_distance_m, least_depth_m(data.depth_m), least_range_m(data.ends_m)});
        keep_times(result, read_s, map_s);
        count(result);
    }

    ImageResult add(const FrameEntry& entry, const FrameData& data) {
        if (recording_.camera()) {
            return mapper_.add_image({entry.time_s, data.depth_m});
        }
        return mapper_.add_scan({entry.time_s, recording_.body_from_sensor(), data.ends_m, {}});
    }

    void skip(const std::string& where, SkipReason reason, const std::string& problem) {
        ++summary_.skipped[static_cast<std::size_t>(reason)];
        if (summary_.skipped_first.size() < skipped_listed) {
            summary_.skipped_first.push_back({where, reason, problem});
        }
    }

    void keep_times(const ImageResult& result, double read_s, double map_s) {
        summary_.read.seconds.push_back(read_s);
        summary_.prepare.seconds.push_back(result.prepare_s);
        summary_.window.seconds.push_back(result.window_s);
        summary_.integrate.seconds.push_back(result.integrate_s);
        summary_.fuse.seconds.push_back(result.fuse_s);
        summary_.map.seconds.push_back(map_s);
        summary_.image.seconds.push_back(read_s + map_s);
    }

    void count(const ImageResult& result) {
        ++summary_.integrated;
        summary_.rays += result.rays;
        summary_.missing += result.missing;
        summary_.dropped += result.dropped;
        summary_.zones_entered += result.zones_entered;
        summary_.zones_left += result.zones_left;
        summary_.cells_changed += result.cells_changed;
        summary_.images_without_change += result.cells_changed == 0 ? 1U : 0U;
        summary_.trajectory_m.emplace_back(result.world_from_sensor.translation());
    }

    const Recording& recording_;
    Mapper& mapper_;
    ReplaySummary summary_;
    std::size_t next_sample_ = 0;
};

} // namespace

std::string name_of(SkipReason reason) {
    constexpr std::array<const char*, skip_reasons> names{"damaged", "no_navigation",
                                                          "pose_out_of_range", "out_of_order"};
    return names[static_cast<std::size_t>(reason)];
}

double StageTimes::total_s() const {
    return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

double StageTimes::percentile_s(double share) const {
    if (seconds.empty()) {
        return 0.0;
    }
    std::vector<double> sorted = seconds;
    const auto rank = std::ceil(share * static_cast<double>(sorted.size()));
    const auto place = static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return sorted[static_cast<std::size_t>(place)];
}

ReplaySummary replay(const Recording& recording, const FrameSpan& span, Mapper& mapper,
                     const ReplayObserver& observer) {
    Replay run(recording, mapper);
    run.run(span, observer);
    return run.take();
}

} // namespace zonegrid
