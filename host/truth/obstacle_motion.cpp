#include "truth/truth_folder.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace zonegrid {

Eigen::Isometry3d ObstacleMotion::at(double time_s) const {
    if (poses.empty()) {
        throw UsageError(fmt::format("the motion of obstacle {} has no pose", obstacle));
    }
    const auto later = std::ranges::lower_bound(poses, time_s, {}, &MovingPose::time_s);
    if (later == poses.end()) {
        return poses.back().world_from_obstacle;
    }
    if (later == poses.begin() || later->time_s == time_s) {
        return later->world_from_obstacle; // an entry itself, without rounding
    }
    const MovingPose& from = *(later - 1);
    const double share = (time_s - from.time_s) / (later->time_s - from.time_s);
    const Eigen::Quaterniond start(from.world_from_obstacle.linear());
    const Eigen::Quaterniond end(later->world_from_obstacle.linear());
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = start.slerp(share, end).toRotationMatrix();
    pose.translation() = (1.0 - share) * from.world_from_obstacle.translation() +
                         share * later->world_from_obstacle.translation();
    return pose;
}

} // namespace zonegrid
