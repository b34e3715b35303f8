#include "octomap_flight.h"

#include "model/lattice.h"
#include "model/navigation.h"
#include "pipeline/object_tracker.h"
#include "pipeline/stopwatch.h"
#include "zonegrid/errors.h"

#include <octomap/OcTree.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace zonegrid {
namespace {

/// Number of the cell at the world's origin on each axis of an octree with 16 levels.
constexpr std::int32_t middle_key = 32768;

/// The cells of an OcTree as zonegrid keeps them: zones of values, told of where they change.
class MirroredTree {
public:
    MirroredTree(const OctoMapOptions& options, MapHistory& history)
        : options_(options), history_(history), tree_(options.cell_m) {
        tree_.enableChangeDetection(true);
    }

    void insert(const octomap::Pointcloud& cloud, const octomap::point3d& origin) {
        tree_.insertPointCloud(cloud, origin, options_.range_m, false, options_.discretize);
    }

    /// Tells the history of the zones with a cell that has changed since the last call.
    void tell(std::uint32_t image) {
        std::set<ZoneIndex> changed;
        for (auto key = tree_.changedKeysBegin(); key != tree_.changedKeysEnd(); ++key) {
            changed.insert(note(key->first));
        }
        tree_.resetChangeDetection();
        history_.begin_image(image);
        for (const auto& zone : changed) {
            history_.take(first_cell_of(zone, zone_edge()), zones_.at(zone));
        }
    }

    [[nodiscard]] std::vector<Object> objects() const {
        ObjectTracker tracker(zone_edge());
        for (const auto& [zone, values] : zones_) {
            tracker.set_zone(zone, occupied_bits(values, 1, zone_edge()));
        }
        return tracker.objects();
    }

private:
    [[nodiscard]] std::int32_t zone_edge() const { return history_.options().zone; }

    ZoneIndex note(const octomap::OcTreeKey& key) {
        const CellIndex cell{key[0] - middle_key, key[1] - middle_key, key[2] - middle_key};
        const ZoneIndex zone = zone_of(cell, zone_edge());
        auto& values = zones_[zone];
        const auto edge = static_cast<std::size_t>(zone_edge());
        values.resize(edge * edge * edge);
        const octomap::OcTreeNode* const node = tree_.search(key);
        values[index_in_zone(cell, zone_edge())] =
            node == nullptr ? std::int8_t{0} : std::int8_t(tree_.isNodeOccupied(node) ? 1 : -1);
        return zone;
    }

    const OctoMapOptions& options_;
    MapHistory& history_;
    octomap::OcTree tree_;
    std::map<ZoneIndex, std::vector<std::int8_t>> zones_;
};

octomap::point3d point_of(const Eigen::Vector3d& point_m) {
    const Eigen::Vector3f rounded = point_m.cast<float>();
    return {rounded.x(), rounded.y(), rounded.z()};
}

/// The ends of all rays of an image, world frame.
octomap::Pointcloud cloud_of(const Camera& camera, std::span<const float> depth_m,
                             const Eigen::Isometry3d& world_from_camera, double range_m) {
    octomap::Pointcloud cloud;
    cloud.reserve(depth_m.size());
    std::size_t pixel = 0;
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u, ++pixel) {
            const float depth = depth_m[pixel];
            if (std::isnan(depth) || depth <= 0.0F) {
                continue;
            }
            const Eigen::Vector3d slope =
                camera.directions.empty() ? Eigen::Vector3d((u - camera.cx_px) / camera.fx_px,
                                                            (v - camera.cy_px) / camera.fy_px, 1.0)
                                          : Eigen::Vector3d(camera.directions[pixel].x(),
                                                            camera.directions[pixel].y(), 1.0);
            const double along = std::isinf(depth) ? 2.0 * range_m : double{depth};
            cloud.push_back(point_of(world_from_camera * (slope * along)));
        }
    }
    return cloud;
}

MapperOptions history_options(const OctoMapOptions& options) {
    MapperOptions chosen;
    chosen.cell_m = options.cell_m;
    chosen.range_m = options.range_m;
    chosen.hit = chosen.miss = chosen.limit = chosen.threshold = 1;
    return chosen;
}

/// Hands over samples as a vehicle would, up to `max_gap_s` after an image.
class Navigator {
public:
    Navigator(const std::vector<NavigationSample>& samples, double max_gap_s)
        : samples_(samples), max_gap_s_(max_gap_s) {}

    std::optional<Eigen::Isometry3d> world_from_body(double time_s) {
        for (; next_ < samples_.size() && samples_[next_].time_s <= time_s + max_gap_s_; ++next_) {
            buffer_.add(samples_[next_]);
        }
        return buffer_.world_from_body(time_s, max_gap_s_);
    }

private:
    const std::vector<NavigationSample>& samples_;
    double max_gap_s_;
    std::size_t next_ = 0;
    NavigationBuffer buffer_;
};

std::optional<FrameData> read_frame(const Recording& recording, std::size_t index) {
    try {
        return recording.read_frame(index);
    } catch (const InputError&) {
        return std::nullopt; // counted, as zonegrid map does
    }
}

} // namespace

OctoMapFlight fly_octomap(const Recording& recording, const OctoMapOptions& options,
                          const std::function<void(std::size_t)>& observer) {
    if (!recording.camera()) {
        throw UsageError("the recording has no depth images: name one with a camera");
    }
    const Camera& camera = *recording.camera();
    OctoMapFlight flight{.history = MapHistory(history_options(options)), .objects = {}};
    MirroredTree tree(options, flight.history);
    Navigator navigator(recording.navigation(), options.max_gap_s);
    StageTimes insert;
    for (std::size_t image = 0; image < recording.frames().size(); ++image) {
        observer(image);
        const auto body = navigator.world_from_body(recording.frames()[image].time_s);
        const auto frame = body ? read_frame(recording, image) : std::nullopt;
        if (!frame) {
            ++flight.skipped;
            continue;
        }
        const auto world_from_camera = mount_sensor(*body, camera.body_from_camera);
        const auto cloud = cloud_of(camera, frame->depth_m, world_from_camera, options.range_m);
        Stopwatch stopwatch;
        tree.insert(cloud, point_of(world_from_camera.translation()));
        insert.seconds.push_back(stopwatch.lap_s());
        tree.tell(static_cast<std::uint32_t>(image));
        ++flight.integrated;
    }
    observer(recording.frames().size());
    flight.insert_ms = 1e3 * insert.percentile_s(0.5);
    flight.objects = tree.objects();
    return flight;
}

} // namespace zonegrid
