#include "io/frame_statistics.h"

#include "zonegrid/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zonegrid {
namespace {

constexpr std::size_t damaged_listed = 10;

/// The distances of one frame.
struct FrameDistances {
    std::size_t pixels = 0;
    std::size_t infinite = 0;
    std::vector<double> valid_m;

    void add(double distance_m) {
        ++pixels;
        if (std::isinf(distance_m)) {
            ++infinite;
        } else if (distance_m > 0.0) { // false for NaN
            valid_m.push_back(distance_m);
        }
    }
    [[nodiscard]] double share(std::size_t count) const {
        return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(pixels, 1));
    }
};

FrameDistances distances_of(const FrameData& frame) {
    FrameDistances distances;
    for (const float depth : frame.depth_m) {
        distances.add(static_cast<double>(depth));
    }
    for (const Eigen::Vector3f& end : frame.ends_m) {
        // A point that is not finite is missing, not sky.
        distances.add(end.allFinite() ? static_cast<double>(end.norm()) : 0.0);
    }
    return distances;
}

/// Collects frames.
class FrameStatistics {
public:
    void add(const FrameData& frame) {
        FrameDistances distances = distances_of(frame);
        pixels_.push_back(static_cast<double>(distances.pixels));
        valid_.push_back(distances.share(distances.valid_m.size()));
        infinite_.push_back(distances.share(distances.infinite));
        if (!distances.valid_m.empty()) {
            const Spread depth_m = spread_of(std::move(distances.valid_m));
            medians_m_.push_back(depth_m.median);
            least_m_ = std::min(least_m_, depth_m.least);
            greatest_m_ = std::max(greatest_m_, depth_m.greatest);
        }
    }

    void finish(FrameContents& contents) {
        contents.pixels = spread_of(std::move(pixels_));
        contents.valid_share = spread_of(std::move(valid_));
        contents.infinite_share = spread_of(std::move(infinite_));
        const bool any = !medians_m_.empty();
        const double none = std::numeric_limits<double>::quiet_NaN();
        contents.least_depth_m = any ? least_m_ : none;
        contents.greatest_depth_m = any ? greatest_m_ : none;
        contents.median_depth_m = spread_of(std::move(medians_m_)).median;
    }

private:
    std::vector<double> pixels_;
    std::vector<double> valid_;
    std::vector<double> infinite_;
    std::vector<double> medians_m_;
    double least_m_ = std::numeric_limits<double>::infinity();
    double greatest_m_ = 0.0;
};

} // namespace

FrameContents look_at_frames(const Recording& recording, std::size_t frames_most) {
    FrameContents contents;
    FrameStatistics statistics;
    const std::size_t count = recording.frames().size();
    const std::size_t looked_at = std::min(frames_most, count);
    for (std::size_t i = 0; i < looked_at; ++i) {
        try {
            statistics.add(recording.read_frame(i * count / looked_at));
            ++contents.read;
        } catch (const InputError& error) {
            ++contents.damaged;
            if (contents.damaged_first.size() < damaged_listed) {
                contents.damaged_first.emplace_back(error.what());
            }
        }
    }
    statistics.finish(contents);
    return contents;
}

} // namespace zonegrid
