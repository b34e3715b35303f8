#include "model/rays.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <cmath>

namespace zonegrid {

namespace {

constexpr double farthest_cells = 1 << 30;

/// `world_from_sensor` applied to a point, summed in the order docs/model.md gives.
Eigen::Vector3d transform(const Eigen::Isometry3d& world_from_sensor,
                          const Eigen::Vector3f& point) {
    const auto& matrix = world_from_sensor.matrix();
    Eigen::Vector3d result;
    for (int i = 0; i < 3; ++i) {
        result[i] = ((matrix(i, 0) * double{point.x()} + matrix(i, 1) * double{point.y()}) +
                     matrix(i, 2) * double{point.z()}) +
                    matrix(i, 3);
    }
    return result;
}

} // namespace

std::optional<CellIndex> cell_of(const Eigen::Vector3d& position_m, double cell_m) {
    const Eigen::Vector3d cell = (position_m / cell_m).array().floor();
    if (!(cell.array().abs() <= farthest_cells).all()) { // NaN too
        return std::nullopt;
    }
    return CellIndex{static_cast<std::int32_t>(cell.x()), static_cast<std::int32_t>(cell.y()),
                     static_cast<std::int32_t>(cell.z())};
}

std::optional<SubPoint> window_relative(const Eigen::Vector3d& position_m, double cell_m,
                                        const Window& window) {
    const CellIndex first = window.first_cell();
    const Eigen::Vector3d first_sub =
        Eigen::Vector3d(first.x, first.y, first.z) * double{ZG_SUB_PER_CELL};
    // Whole numbers below 2^53: the difference is exact, and far outside stays far outside.
    const Eigen::Vector3d sub =
        (position_m / cell_m * double{ZG_SUB_PER_CELL}).array().floor().matrix() - first_sub;
    const double edge_sub = double{ZG_SUB_PER_CELL} * window.edge_cells();
    if (!(sub.array() >= 0.0 && sub.array() < edge_sub).all()) { // NaN too
        return std::nullopt;
    }
    return SubPoint{static_cast<std::int32_t>(sub.x()), static_cast<std::int32_t>(sub.y()),
                    static_cast<std::int32_t>(sub.z())};
}

void check_scan(const Scan& scan) {
    if (!scan.starts_m.empty() && scan.starts_m.size() != scan.ends_m.size()) {
        throw UsageError(
            fmt::format("scan at {:.6f} s: {} starts for {} ends; give one each or none",
                        scan.time_s, scan.starts_m.size(), scan.ends_m.size()));
    }
}

ScanRays quantize_scan(const Scan& scan, const Eigen::Isometry3d& world_from_sensor,
                       const MapperOptions& options, const Window& window) {
    check_scan(scan);
    ScanRays result;
    result.rays.reserve(scan.ends_m.size());
    for (std::size_t i = 0; i < scan.ends_m.size(); ++i) {
        const Eigen::Vector3d start = scan.starts_m.empty()
                                          ? Eigen::Vector3d(world_from_sensor.translation())
                                          : transform(world_from_sensor, scan.starts_m[i]);
        Eigen::Vector3d end = transform(world_from_sensor, scan.ends_m[i]);
        const Eigen::Vector3d d = end - start;
        const double distance_m = std::sqrt((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z());
        if (!std::isfinite(distance_m) || distance_m == 0.0) {
            ++result.missing;
            continue;
        }
        const bool hit = distance_m <= options.range_m;
        if (!hit) {
            end = start + d * (options.range_m / distance_m);
        }
        const auto start_sub = window_relative(start, options.cell_m, window);
        const auto end_sub = window_relative(end, options.cell_m, window);
        if (start_sub && end_sub) {
            result.rays.push_back({*start_sub, *end_sub, hit});
        } else {
            ++result.dropped;
        }
    }
    return result;
}

} // namespace zonegrid
