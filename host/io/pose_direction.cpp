#include "io/pose_direction.h"

#include "io/pose_conversion.h"
#include "zonegrid/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace zonegrid {
namespace {

using Poses = std::span<const std::optional<Eigen::Isometry3d>>;
using Points = std::vector<Eigen::Vector3d>;

constexpr std::size_t pairs_most = 3;
constexpr double moved_share = 0.05; // of the typical distance
constexpr double least_turn_rad = 0.05;
constexpr double turned_most_rad = 0.6; // beyond, little is seen in both
constexpr std::size_t pixel_step = 4;
constexpr std::size_t scan_points = 400;
constexpr std::size_t other_scan_points = 40000;

double turn_between(const Eigen::Isometry3d& first, const Eigen::Isometry3d& second) {
    return Eigen::AngleAxisd(first.linear().transpose() * second.linear()).angle();
}

/// The first frame after `first` to which the sensor moved, if it still sees the same place.
std::optional<std::size_t> find_partner(Poses poses, std::size_t first, double depth_m) {
    for (std::size_t second = first + 1; second < poses.size(); ++second) {
        if (!poses[second]) {
            continue;
        }
        const double moved_m = (poses[second]->translation() - poses[first]->translation()).norm();
        const double turned_rad = turn_between(*poses[first], *poses[second]);
        if (moved_m >= moved_share * depth_m || turned_rad >= least_turn_rad) {
            return turned_rad <= turned_most_rad ? std::optional(second) : std::nullopt;
        }
    }
    return std::nullopt;
}

std::vector<std::pair<std::size_t, std::size_t>> find_pairs(Poses poses, double depth_m) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < pairs_most; ++i) {
        const std::size_t first = i * poses.size() / pairs_most;
        if (!poses[first]) {
            continue;
        }
        if (const auto second = find_partner(poses, first, depth_m)) {
            pairs.emplace_back(first, *second);
        }
    }
    return pairs;
}

Eigen::Vector2d slope_at(const Camera& camera, std::size_t column, std::size_t row) {
    if (!camera.directions.empty()) {
        return camera.directions[row * static_cast<std::size_t>(camera.width_px) + column]
            .cast<double>();
    }
    return {(static_cast<double>(column) - camera.cx_px) / camera.fx_px,
            (static_cast<double>(row) - camera.cy_px) / camera.fy_px};
}

bool has_distance(float depth) {
    return std::isfinite(depth) && depth > 0.0F;
}

/// Every few pixels a point in the camera frame.
Points points_of_image(const Camera& camera, std::span<const float> depth_m) {
    Points points;
    const auto width = static_cast<std::size_t>(camera.width_px);
    for (std::size_t row = 0; row < static_cast<std::size_t>(camera.height_px); row += pixel_step) {
        for (std::size_t column = 0; column < width; column += pixel_step) {
            const float depth = depth_m[row * width + column];
            if (has_distance(depth)) {
                const Eigen::Vector2d slope = slope_at(camera, column, row);
                points.emplace_back(Eigen::Vector3d(slope.x(), slope.y(), 1.0) *
                                    static_cast<double>(depth));
            }
        }
    }
    return points;
}

/// The depth that an image shows where it sees `point`; nothing outside or where it is missing.
std::optional<double> depth_at(const Camera& camera, std::span<const float> depth_m,
                               const Eigen::Vector3d& point) {
    if (!(point.z() > 0.0)) {
        return std::nullopt;
    }
    const Eigen::Vector2d slope = point.head<2>() / point.z();
    Eigen::Vector2d pixel(slope.x() * camera.fx_px + camera.cx_px,
                          slope.y() * camera.fy_px + camera.cy_px);
    // A pinhole is hit at once; a table of directions is searched from there.
    const int tries = camera.directions.empty() ? 1 : 6;
    for (int attempt = 0; attempt < tries; ++attempt) {
        const double column = std::round(pixel.x());
        const double row = std::round(pixel.y());
        if (!(column >= 0.0 && column < camera.width_px && row >= 0.0 && row < camera.height_px)) {
            return std::nullopt;
        }
        const auto u = static_cast<std::size_t>(column);
        const auto v = static_cast<std::size_t>(row);
        const Eigen::Vector2d miss = slope - slope_at(camera, u, v);
        pixel = Eigen::Vector2d(column + miss.x() * camera.fx_px, row + miss.y() * camera.fy_px);
        if (attempt + 1 == tries) {
            const float depth = depth_m[v * static_cast<std::size_t>(camera.width_px) + u];
            return has_distance(depth) ? std::optional(static_cast<double>(depth)) : std::nullopt;
        }
    }
    return std::nullopt;
}

/// At most `most` of the finite points, evenly spread.
Points points_of_scan(std::span<const Eigen::Vector3f> ends_m, std::size_t most) {
    Points points;
    const std::size_t step = std::max<std::size_t>(1, ends_m.size() / most);
    for (std::size_t i = 0; i < ends_m.size(); i += step) {
        if (ends_m[i].allFinite() && ends_m[i].norm() > 0.0F) {
            points.emplace_back(ends_m[i].cast<double>());
        }
    }
    return points;
}

/// Differences of one pair; each call adds those for one way to carry points over.
class FramePair {
public:
    FramePair(const Recording& recording, std::size_t first, std::size_t second)
        : camera_(recording.camera()) {
        const FrameData first_frame = recording.read_frame(first);
        second_ = recording.read_frame(second);
        points_ = camera_ ? points_of_image(*camera_, first_frame.depth_m)
                          : points_of_scan(first_frame.ends_m, scan_points);
        others_ = points_of_scan(second_.ends_m, other_scan_points);
    }

    void add_differences(const Eigen::Isometry3d& second_from_first,
                         std::vector<double>& differences_m) const {
        for (const Eigen::Vector3d& point : points_) {
            const Eigen::Vector3d carried = second_from_first * point;
            if (!camera_) {
                differences_m.push_back(nearest_m(carried));
            } else if (const auto depth = depth_at(*camera_, second_.depth_m, carried)) {
                differences_m.push_back(std::abs(*depth - carried.z()));
            }
        }
    }

private:
    [[nodiscard]] double nearest_m(const Eigen::Vector3d& point) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& other : others_) {
            least = std::min(least, (other - point).squaredNorm());
        }
        return std::sqrt(least);
    }

    const std::optional<Camera>& camera_;
    FrameData second_;
    Points points_;
    Points others_;
};

double median_of(std::vector<double>& values) {
    if (values.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

} // namespace

std::optional<PoseDirection> check_pose_direction(const Recording& recording, Poses poses,
                                                  double depth_m) {
    // The inverse of a stated pose is meant in the recording's own world, of which only the result
    // in north-east-down is known: each way to get there is tried, and the best counts.
    constexpr std::array<WorldAxes, 4> worlds{WorldAxes::north_east_down, WorldAxes::east_north_up,
                                              WorldAxes::z_up, WorldAxes::y_down};
    PoseDirection result;
    std::vector<double> stated_m;
    std::array<std::vector<double>, worlds.size()> inverse_m;
    for (const auto& [first, second] : find_pairs(poses, depth_m)) {
        try {
            const FramePair pair(recording, first, second);
            pair.add_differences(poses[second]->inverse() * *poses[first], stated_m);
            for (std::size_t i = 0; i < worlds.size(); ++i) {
                const Eigen::Isometry3d to_world(
                    Eigen::Quaterniond(north_east_down_from(worlds[i])));
                pair.add_differences(
                    to_world.inverse() * *poses[second] * poses[first]->inverse() * to_world,
                    inverse_m[i]);
            }
            ++result.pairs;
        } catch (const InputError&) {
            continue; // a damaged frame is counted elsewhere
        }
    }
    if (stated_m.empty()) {
        return std::nullopt;
    }
    result.points = stated_m.size();
    result.stated_m = median_of(stated_m);
    result.inverse_m = std::numeric_limits<double>::infinity();
    for (std::vector<double>& differences_m : inverse_m) {
        // Few points in view agree by chance.
        if (4 * differences_m.size() >= result.points) {
            result.inverse_m = std::min(result.inverse_m, median_of(differences_m));
        }
    }
    return result;
}

} // namespace zonegrid
