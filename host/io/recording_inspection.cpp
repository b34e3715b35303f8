#include "io/recording_inspection.h"

#include "io/frame_statistics.h"
#include "model/navigation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace zonegrid {
namespace {

using Poses = std::vector<std::optional<Eigen::Isometry3d>>;

/// Steps above `gap_limit_s` count as gaps; by default those above twice the median step.
template <class Entry>
TimeSeries series_of(const std::vector<Entry>& entries, std::optional<double> gap_limit_s = {}) {
    TimeSeries series;
    series.count = entries.size();
    if (entries.size() < 2) {
        return series;
    }
    series.duration_s = entries.back().time_s - entries.front().time_s;
    std::vector<double> steps_s;
    for (std::size_t i = 1; i < entries.size(); ++i) {
        steps_s.push_back(entries[i].time_s - entries[i - 1].time_s);
    }
    const double usual_s = spread_of(steps_s).median;
    const auto greatest = std::ranges::max_element(steps_s);
    series.rate_hz = 1.0 / usual_s;
    series.greatest_gap_s = *greatest;
    series.greatest_gap_at_s = entries[static_cast<std::size_t>(greatest - steps_s.begin())].time_s;
    series.gap_limit_s = gap_limit_s.value_or(2.0 * usual_s);
    series.gaps_above_limit = static_cast<std::size_t>(std::ranges::count_if(
        steps_s, [&series](double step_s) { return step_s > series.gap_limit_s; }));
    return series;
}

bool is_finite(const NavigationSample& sample) {
    return std::isfinite(sample.time_s) && sample.position_m.allFinite() &&
           sample.velocity_mps.allFinite() && sample.acceleration_mps2.allFinite() &&
           sample.world_from_body.coeffs().allFinite() && sample.body_rate_radps.allFinite();
}

/// The pose of each frame as a replay finds it.
Poses poses_of_frames(const Recording& recording, double max_gap_s) {
    const Eigen::Isometry3d body_from_sensor =
        recording.camera() ? recording.camera()->body_from_camera : recording.body_from_sensor();
    NavigationBuffer navigation;
    auto sample = recording.navigation().begin();
    Poses poses;
    for (const FrameEntry& frame : recording.frames()) {
        for (; sample != recording.navigation().end() && sample->time_s <= frame.time_s + max_gap_s;
             ++sample) {
            if (is_finite(*sample)) {
                navigation.add(*sample);
            }
        }
        poses.push_back(navigation.world_from_body(frame.time_s, max_gap_s));
        if (poses.back()) {
            *poses.back() = *poses.back() * body_from_sensor;
        }
    }
    return poses;
}

/// Grows with points; extents of an empty box are 0.
struct Extent {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;

    void add(const Eigen::Vector3d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    [[nodiscard]] Eigen::Vector3d size() const { return (high - low).cwiseMax(0.0); }
};

void add_step(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double step_s,
              SensorPath& path) {
    const double step_m = (to.translation() - from.translation()).norm();
    const double turn_rad = Eigen::AngleAxisd(from.linear().transpose() * to.linear()).angle();
    path.length_m += step_m;
    path.greatest_step_m = std::max(path.greatest_step_m, step_m);
    path.greatest_turn_rad = std::max(path.greatest_turn_rad, turn_rad);
    path.greatest_speed_mps = std::max(path.greatest_speed_mps, step_m / step_s);
}

SensorPath path_of(const Recording& recording, const Poses& poses) {
    const double steep = std::cos(std::numbers::pi / 6.0);
    SensorPath path;
    Extent extent;
    std::size_t steep_frames = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (!poses[i]) {
            ++path.frames_without_navigation;
            continue;
        }
        ++path.frames_with_pose;
        extent.add(poses[i]->translation());
        steep_frames += std::abs(poses[i]->linear()(2, 2)) > steep ? 1U : 0U;
        if (i > 0 && poses[i - 1]) {
            add_step(*poses[i - 1], *poses[i],
                     recording.frames()[i].time_s - recording.frames()[i - 1].time_s, path);
        }
    }
    const Eigen::Vector3d size_m = extent.size();
    path.horizontal_extent_m = size_m.head<2>().norm();
    path.vertical_extent_m = size_m.z();
    if (recording.camera() && path.frames_with_pose > 0) {
        path.share_looking_steeply =
            static_cast<double>(steep_frames) / static_cast<double>(path.frames_with_pose);
    }
    return path;
}

void add_time_warnings(const RecordingInspection& found, double max_gap_s,
                       std::vector<std::string>& warnings) {
    if (found.navigation_not_finite > 0) {
        warnings.push_back(
            fmt::format("{} navigation samples are not finite; mapping stops at them",
                        found.navigation_not_finite));
    }
    if (found.path.frames_without_navigation > 0) {
        warnings.push_back(fmt::format(
            "{} of {} images have no navigation within {} s and will be skipped; usually the "
            "clocks differ or navigation has gaps (a larger --max-gap)",
            found.path.frames_without_navigation, found.frames.count, max_gap_s));
    }
}

void add_depth_warnings(const RecordingInspection& found, std::vector<std::string>& warnings) {
    constexpr double least_plausible_m = 0.05;
    constexpr double greatest_plausible_m = 200.0;
    const FrameContents& contents = found.contents;
    if (contents.damaged > 0) {
        warnings.push_back(fmt::format("{} of {} images looked at cannot be read; the first: {}",
                                       contents.damaged, contents.damaged + contents.read,
                                       contents.damaged_first.front()));
    }
    if (contents.read > 0 && !(contents.valid_share.greatest > 0.0)) {
        warnings.emplace_back(
            "no pixel has a distance; usually the files hold no depth, or the value that means "
            "missing is wrong");
    }
    if (contents.median_depth_m < least_plausible_m ||
        contents.median_depth_m > greatest_plausible_m) {
        warnings.push_back(fmt::format(
            "the median distance is {:.4g} m: the depth scale is likely off by 1000 or 5000 "
            "(--depth-scale)",
            contents.median_depth_m));
    }
}

void add_pose_warnings(const RecordingInspection& found, std::vector<std::string>& warnings) {
    constexpr double mostly = 0.8;
    constexpr double vertical_path_m = 1.0;
    const SensorPath& path = found.path;
    if (path.share_looking_steeply > mostly) {
        warnings.push_back(fmt::format(
            "the camera looks straight up or down in {:.0f} % of the images: right for a camera "
            "that does, else the world's axes are wrong (--world-axes)",
            100.0 * path.share_looking_steeply));
    }
    if (path.vertical_extent_m > vertical_path_m &&
        path.vertical_extent_m > 2.0 * path.horizontal_extent_m) {
        warnings.push_back(fmt::format(
            "the path spans {:.3g} m in height and {:.3g} m on the ground: right for a lift, else "
            "the world's axes are wrong (--world-axes)",
            path.vertical_extent_m, path.horizontal_extent_m));
    }
    if (found.pose_direction && found.pose_direction->inside_out()) {
        warnings.push_back(fmt::format(
            "images agree better with inverted poses ({:.3g} m) than as stated ({:.3g} m): the "
            "recording likely gives camera-from-world; invert its poses",
            found.pose_direction->inverse_m, found.pose_direction->stated_m));
    }
}

} // namespace

Spread spread_of(std::vector<double> values) {
    if (values.empty()) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none, none};
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    const auto [least, greatest] = std::ranges::minmax_element(values);
    return {*least, values[values.size() / 2], *greatest};
}

RecordingInspection inspect_recording(const Recording& recording, double max_gap_s,
                                      std::size_t frames_most) {
    RecordingInspection found;
    found.frames = series_of(recording.frames());
    found.navigation = series_of(recording.navigation(), max_gap_s);
    found.navigation_not_finite = static_cast<std::size_t>(
        std::ranges::count_if(recording.navigation(), std::not_fn(is_finite)));
    const Poses poses = poses_of_frames(recording, max_gap_s);
    found.path = path_of(recording, poses);
    found.contents = look_at_frames(recording, frames_most);
    if (std::isfinite(found.contents.median_depth_m)) {
        found.pose_direction =
            check_pose_direction(recording, poses, found.contents.median_depth_m);
    }
    add_time_warnings(found, max_gap_s, found.warnings);
    add_depth_warnings(found, found.warnings);
    add_pose_warnings(found, found.warnings);
    return found;
}

} // namespace zonegrid
