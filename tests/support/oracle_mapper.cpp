#include "support/oracle_mapper.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zonegrid::oracle {

namespace {

/// Greatest multiple of `zone` that is not above `cell`.
std::int64_t zone_start(std::int64_t cell, std::int64_t zone) {
    const std::int64_t rest = ((cell % zone) + zone) % zone;
    return cell - rest;
}

Eigen::Isometry3d transform_of(const Pose& pose) {
    Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
    for (std::size_t row = 0; row < 3; ++row) {
        const auto r = static_cast<Eigen::Index>(row);
        transform(r, 3) = pose.position_m[row];
        for (std::size_t column = 0; column < 3; ++column) {
            transform(r, static_cast<Eigen::Index>(column)) = pose.rotation[row][column];
        }
    }
    return transform;
}

} // namespace

OracleMapper::OracleMapper(const MapperOptions& options, const std::optional<Camera>& camera)
    : options_(options), camera_(camera) {
    const double stretch = camera ? 1.0 + 0.5 / camera->fx_px + 0.5 / camera->fy_px : 1.0;
    reach_cell_ =
        static_cast<std::int64_t>(std::floor(options.range_m * stretch / options.cell_m)) + 2;
    const std::int64_t zones = (2 * reach_cell_ + options.zone - 1) / options.zone + 2;
    window_.edge = zones * options.zone;
}

void OracleMapper::add_navigation(const NavigationSample& sample) {
    samples_.push_back(sample);
}

ImageStatus OracleMapper::admit(double time_s, const std::optional<Pose>& pose) {
    if (last_time_s_ && time_s <= *last_time_s_) {
        return ImageStatus::out_of_order;
    }
    if (!pose) {
        return ImageStatus::no_navigation;
    }
    for (const double position_m : pose->position_m) {
        if (!(std::abs(std::floor(position_m / options_.cell_m)) <= 1073741824.0)) {
            return ImageStatus::pose_out_of_range;
        }
    }
    last_time_s_ = time_s; // skipped images do not count
    return ImageStatus::integrated;
}

ImageResult OracleMapper::add_image(const DepthImage& image) {
    ImageResult result;
    const auto pose =
        sensor_pose(samples_, image.time_s, options_.max_gap_s, camera_->body_from_camera);
    result.status = admit(image.time_s, pose);
    if (result.status != ImageStatus::integrated) {
        return result;
    }
    result.world_from_sensor = transform_of(*pose);
    move_window(*pose);
    const LocalMap map = image_local_map(*camera_, options_, *pose, image.depth_m);
    result.missing = map.missing;
    result.cells_changed = fuse(map.cells, View(*camera_, options_, *pose, image.depth_m));
    return result;
}

ImageResult OracleMapper::add_scan(const Scan& scan) {
    ImageResult result;
    const auto pose = sensor_pose(samples_, scan.time_s, options_.max_gap_s, scan.body_from_sensor);
    result.status = admit(scan.time_s, pose);
    if (result.status != ImageStatus::integrated) {
        return result;
    }
    result.world_from_sensor = transform_of(*pose);
    move_window(*pose);
    const LocalMap map = scan_local_map(scan, options_, *pose, window_);
    result.missing = map.missing;
    result.dropped = map.dropped;
    result.cells_changed = fuse(map.cells, {});
    return result;
}

void OracleMapper::move_window(const Pose& pose) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto centre = static_cast<std::int64_t>(
            std::floor(std::floor((pose.position_m[i] / options_.cell_m) * 256.0) / 256.0));
        const std::int64_t low = zone_start(centre - reach_cell_, options_.zone);
        const std::int64_t end = zone_start(centre + reach_cell_, options_.zone) + options_.zone;
        std::int64_t& first = window_.first[i];
        if (!placed_ || low < first) {
            first = low;
        } else if (end > first + window_.edge) {
            first = end - window_.edge;
        }
    }
    placed_ = true;
    // What leaves is remembered if occupied, and forgotten otherwise.
    for (auto at = values_.begin(); at != values_.end();) {
        if (window_.holds(at->first)) {
            ++at;
            continue;
        }
        if (at->second >= options_.threshold) {
            remembered_.insert(at->first);
        }
        at = values_.erase(at);
    }
    // What enters is drawn with a value between threshold and limit.
    for (auto at = remembered_.begin(); at != remembered_.end();) {
        if (!window_.holds(*at)) {
            ++at;
            continue;
        }
        values_[*at] = (options_.threshold + options_.limit + 1) / 2;
        at = remembered_.erase(at);
    }
}

bool OracleMapper::spared(const CellIndex& cell, int value, const View& view) {
    if (value < options_.threshold) {
        return false;
    }
    const bool whole = view.holds_whole(cell);
    ++(whole ? wholly_seen_ : partly_seen_);
    return !whole;
}

std::uint64_t OracleMapper::fuse(const StatementMap& statements, const std::optional<View>& view) {
    std::uint64_t changed = 0;
    for (const auto& [cell, statement] : statements) {
        int& value = values_[cell];
        if (statement == Statement::free && view && spared(cell, value, *view)) {
            continue;
        }
        const int delta = statement == Statement::occupied ? options_.hit : -options_.miss;
        const int fused = std::clamp(value + delta, -options_.limit, options_.limit);
        changed += fused != value ? 1 : 0;
        value = fused;
    }
    return changed;
}

const std::map<CellIndex, int>& OracleMapper::values() const {
    return values_;
}

const CellSet& OracleMapper::remembered() const {
    return remembered_;
}

std::uint64_t OracleMapper::partly_seen() const {
    return partly_seen_;
}

std::uint64_t OracleMapper::wholly_seen() const {
    return wholly_seen_;
}

const Window& OracleMapper::window() const {
    return window_;
}

CellSet OracleMapper::occupied() const {
    CellSet cells = remembered_;
    for (const auto& [cell, value] : values_) {
        if (value >= options_.threshold) {
            cells.insert(cell);
        }
    }
    return cells;
}

std::vector<Object> OracleMapper::objects() const {
    return objects_of(occupied(), options_.zone);
}

std::vector<ProfileColumn> OracleMapper::height_profile(std::optional<double> cut_height_m) const {
    return profile_of(occupied(), options_.cell_m, cut_height_m);
}

} // namespace zonegrid::oracle
