#include "zonegrid/mapper.h"

#include "model/fusion.h"
#include "model/navigation.h"
#include "model/rays.h"
#include "pipeline/feature_map.h"
#include "pipeline/grid_engine.h"
#include "pipeline/stopwatch.h"
#include "reference/profile_heights.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace zonegrid {

class Mapper::Implementation {
public:
    Implementation(const MapperOptions& options, const std::optional<Camera>& camera,
                   const GridEngineMaker& make_engine)
        : options_(options),
          camera_(camera),
          rule_(options),
          window_(make_window(options, camera)),
          grid_(make_engine(options, camera, window_)),
          features_(options.zone) {
        if (camera_) {
            quantizer_.emplace(*camera_, options_);
        }
    }

    void add_navigation(const NavigationSample& sample) { navigation_.add(sample); }

    ImageResult add_image(const DepthImage& image) {
        check_image(image);
        return guard([&] { return integrate(image); });
    }

    ImageResult add_scan(const Scan& scan) {
        check_scan(scan);
        return guard([&] { return integrate(scan); });
    }

    void observe_zones(ZoneObserver observer) { observer_ = std::move(observer); }

    const std::vector<Object>& objects() {
        require_going_on();
        grid_->track(std::vector(changed_.begin(), changed_.end()));
        changed_.clear();
        return grid_->objects();
    }

    HeightProfile height_profile(std::optional<double> cut_height_m) const {
        require_going_on();
        const std::int32_t z_least = least_z(cut_height_m);
        reference::HeightProfiler remembered(options_.zone, z_least);
        for (const auto& [zone, octree] : features_.zones()) {
            remembered.add_zone(zone, remembered_bits(zone));
        }
        std::vector<ProfileColumn> columns;
        std::ranges::merge(grid_->profile_heights(z_least), remembered.columns(),
                           std::back_inserter(columns));
        // Of a column in both the lesser z stands first.
        const auto doubled = std::ranges::unique(
            columns, [](const auto& a, const auto& b) { return a.x == b.x && a.y == b.y; });
        columns.erase(doubled.begin(), doubled.end());
        return {options_.cell_m, columns};
    }

    int value(const CellIndex& cell) const {
        require_going_on();
        const ZoneIndex zone = zone_of(cell, options_.zone);
        if (!window_.holds(zone)) {
            return 0;
        }
        const auto place = window_.place_of(zone);
        return grid_->holds(place) ? grid_->values(place)[index_in_zone(cell, options_.zone)] : 0;
    }

    void for_each_cell(const std::function<void(const CellIndex&, int)>& visit) const {
        require_going_on();
        // Order by x, then y, then z: one layer of zones at a time, one x at a time through it.
        std::map<std::int32_t, std::map<std::pair<std::int32_t, std::int32_t>, std::uint32_t>>
            layers;
        for (const auto place : grid_->held()) {
            const ZoneIndex zone = window_.zone_at(place);
            layers[zone.x][{zone.y, zone.z}] = place;
        }
        for (const auto& [zone_x, places] : layers) {
            Layer layer;
            for (const auto& [zone, place] : places) {
                const auto values = grid_->values(place);
                layer.emplace(zone, std::vector(values.begin(), values.end()));
            }
            for (std::int32_t x = 0; x < options_.zone; ++x) {
                visit_plane(zone_x, x, layer, visit);
            }
        }
    }

    void for_each_statement(const std::function<void(const CellIndex&, bool)>& visit) const {
        require_going_on();
        grid_->visit_local_map([&](std::uint32_t place, std::span<const std::uint8_t> statements) {
            const ZoneIndex zone = window_.zone_at(place);
            for (std::uint32_t i = 0; i < statements.size(); ++i) {
                if (statements[i] != ZG_STATEMENT_NOTHING) {
                    visit(cell_at(zone, i, options_.zone), statements[i] == ZG_STATEMENT_OCCUPIED);
                }
            }
        });
    }

    MapStatistics statistics() const {
        require_going_on();
        MapStatistics statistics;
        statistics.window_first_cell = window_.first_cell();
        statistics.window_cells = window_.edge_cells();
        statistics.zones_held = grid_->held().size();
        statistics.zones_held_most = zones_held_most_;
        statistics.zones_remembered = features_.zones().size();
        for (const auto place : grid_->held()) {
            for (const int value : grid_->values(place)) {
                statistics.cells_occupied += value >= rule_.threshold ? 1U : 0U;
                statistics.cells_free += value < 0 ? 1U : 0U;
            }
        }
        return statistics;
    }

    const MapperOptions& options() const { return options_; }

private:
    /// Zones with one x, by y and z.
    using Layer = std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int8_t>>;

    /// Does what a call asks for. Memory that a device refuses leaves the map as it is; after any
    /// other error of an engine its cells cannot be trusted, and the map has ended.
    template <class Call>
    ImageResult guard(const Call& call) {
        require_going_on();
        try {
            return call();
        } catch (const DeviceError& error) {
            end_ = error.what();
            throw;
        } catch (const Error&) {
            throw;
        } catch (const std::exception& error) {
            end_ = error.what();
            throw;
        }
    }

    void require_going_on() const {
        if (!end_.empty()) {
            throw UsageError(
                fmt::format("this map has ended, make a new Mapper; it ended with: {}", end_));
        }
    }

    ImageResult integrate(const DepthImage& image) {
        Stopwatch stopwatch;
        ImageResult result;
        if (!begin(image.time_s, camera_->body_from_camera, result)) {
            return result;
        }
        result.prepare_s = stopwatch.lap_s();
        follow(result);
        result.window_s = stopwatch.lap_s();
        quantizer_->quantize(image.depth_m, result.world_from_sensor, window_, rays_);
        result.missing = static_cast<std::uint64_t>(
            std::ranges::count_if(rays_.depths, [](const auto& depth) { return depth.near < 0; }));
        result.rays = rays_.depths.size() - result.missing;
        result.prepare_s += stopwatch.lap_s();
        grid_->integrate_image(rays_);
        result.integrate_s = stopwatch.lap_s();
        fuse(result);
        result.fuse_s = stopwatch.lap_s();
        return result;
    }

    ImageResult integrate(const Scan& scan) {
        Stopwatch stopwatch;
        ImageResult result;
        if (!begin(scan.time_s, scan.body_from_sensor, result)) {
            return result;
        }
        result.prepare_s = stopwatch.lap_s();
        follow(result);
        result.window_s = stopwatch.lap_s();
        const ScanRays rays = quantize_scan(scan, result.world_from_sensor, options_, window_);
        result.rays = rays.rays.size();
        result.missing = rays.missing;
        result.dropped = rays.dropped;
        result.prepare_s += stopwatch.lap_s();
        grid_->integrate_scan(rays);
        result.integrate_s = stopwatch.lap_s();
        fuse(result);
        result.fuse_s = stopwatch.lap_s();
        return result;
    }

    void check_image(const DepthImage& image) const {
        if (!camera_) {
            throw UsageError("depth image without a camera: hand the camera to the Mapper");
        }
        const auto pixels = static_cast<std::size_t>(camera_->width_px) *
                            static_cast<std::size_t>(camera_->height_px);
        if (image.depth_m.size() != pixels) {
            throw UsageError(fmt::format(
                "depth image at {:.6f} s has {} pixels, the camera has {} x {}", image.time_s,
                image.depth_m.size(), camera_->width_px, camera_->height_px));
        }
    }

    /// Finds the sensor's pose; false if the image must be skipped.
    bool begin(double time_s, const Eigen::Isometry3d& body_from_sensor, ImageResult& result) {
        if (!(time_s > last_time_s_)) {
            result.status = ImageStatus::out_of_order;
            return false;
        }
        const auto body = navigation_.world_from_body(time_s, options_.max_gap_s);
        if (!body) {
            result.status = ImageStatus::no_navigation;
            return false;
        }
        result.world_from_sensor = mount_sensor(*body, body_from_sensor);
        const auto cell = cell_of(result.world_from_sensor.translation(), options_.cell_m);
        if (!cell) {
            result.status = ImageStatus::pose_out_of_range;
            return false;
        }
        last_time_s_ = time_s;
        sensor_cell_ = *cell;
        return true;
    }

    /// Moves the window after the sensor: zones leave into the feature map, zones come out of it.
    void follow(ImageResult& result) {
        Window window = window_;
        if (window.move_to(sensor_cell_)) {
            track_leaving(window);
            window_ = window;
            grid_->move_to(window_, [&](const ZoneIndex& zone, const ZoneBits& occupied) {
                ++result.zones_left;
                remember(zone, occupied);
            });
            returning_ = features_.zones_in(window_);
        }
        // A zone for which a device has no memory stays remembered; the next image tries again.
        while (!returning_.empty()) {
            grid_->draw_objects(returning_.back(), features_.cells(returning_.back()));
            features_.remember(returning_.back(), {});
            show(returning_.back());
            returning_.pop_back();
            ++result.zones_entered;
        }
        zones_held_most_ = std::max<std::uint64_t>(zones_held_most_, grid_->held().size());
    }

    /// Takes zones that are about to leave into the objects, as long as the grid still holds them.
    void track_leaving(const Window& window) {
        std::vector<ZoneIndex> leaving;
        for (const auto& zone : changed_) {
            if (!window.holds(zone)) {
                leaving.push_back(zone);
            }
        }
        grid_->track(leaving);
        for (const auto& zone : leaving) {
            changed_.erase(zone);
        }
    }

    void remember(const ZoneIndex& zone, const ZoneBits& occupied) {
        std::vector<CellIndex> cells;
        occupied.for_each(
            [&](std::uint32_t index) { cells.push_back(cell_at(zone, index, options_.zone)); });
        features_.remember(zone, cells);
    }

    void fuse(ImageResult& result) {
        const auto fused = grid_->fuse_local_map();
        result.cells_changed = fused.cells_changed;
        for (const auto place : fused.occupancy_changed) {
            changed_.insert(window_.zone_at(place));
        }
        for (const auto place : fused.values_changed) {
            show(window_.zone_at(place));
        }
        zones_held_most_ = std::max<std::uint64_t>(zones_held_most_, grid_->held().size());
    }

    /// Hands a zone of the window that holds cells to the observer, if there is one.
    void show(const ZoneIndex& zone) {
        if (observer_) {
            observer_(first_cell_of(zone, options_.zone), grid_->values(window_.place_of(zone)));
        }
    }

    ZoneBits remembered_bits(const ZoneIndex& zone) const {
        ZoneBits bits(options_.zone);
        for (const auto& cell : features_.cells(zone)) {
            bits.set(index_in_zone(cell, options_.zone));
        }
        return bits;
    }

    /// Least z of the cells that stay below the cut.
    std::int32_t least_z(std::optional<double> cut_height_m) const {
        constexpr double lowest = std::numeric_limits<std::int32_t>::min();
        constexpr double highest = std::numeric_limits<std::int32_t>::max();
        if (!cut_height_m) {
            return std::numeric_limits<std::int32_t>::min();
        }
        if (std::isnan(*cut_height_m)) {
            throw UsageError("cut height is not a number: give a height in metres");
        }
        return static_cast<std::int32_t>(
            std::clamp(std::ceil(-*cut_height_m / options_.cell_m), lowest, highest));
    }

    /// Visits the cells with one x in a layer of zones, by y, then z.
    void visit_plane(std::int32_t zone_x, std::int32_t x, const Layer& layer,
                     const std::function<void(const CellIndex&, int)>& visit) const {
        const std::int32_t edge = options_.zone;
        for (auto row = layer.begin(); row != layer.end();) {
            const std::int32_t zone_y = row->first.first;
            const auto row_end = layer.lower_bound({zone_y + 1, std::numeric_limits<int>::min()});
            for (std::int32_t y = 0; y < edge; ++y) {
                for (auto zone = row; zone != row_end; ++zone) {
                    for (std::int32_t z = 0; z < edge; ++z) {
                        const std::int32_t index = (z * edge + y) * edge + x;
                        const int cell_value = zone->second[static_cast<std::size_t>(index)];
                        if (cell_value != 0) {
                            visit({zone_x * edge + x, zone_y * edge + y,
                                   zone->first.second * edge + z},
                                  cell_value);
                        }
                    }
                }
            }
            row = row_end;
        }
    }

    MapperOptions options_;
    std::optional<Camera> camera_;
    FusionRule rule_;
    Window window_;
    std::unique_ptr<GridEngine> grid_;
    FeatureMap features_;
    NavigationBuffer navigation_;
    std::optional<ImageQuantizer> quantizer_;
    ImageRays rays_;
    CellIndex sensor_cell_;
    double last_time_s_ = -std::numeric_limits<double>::infinity();
    std::set<ZoneIndex> changed_; ///< zones in the window whose occupancy the objects have not
    std::uint64_t zones_held_most_ = 0;
    std::vector<ZoneIndex> returning_; ///< remembered zones in the window, still to be drawn
    ZoneObserver observer_;            ///< may be empty
    std::string end_;                  ///< the error after which the map cannot go on; empty: none
};

Mapper::Mapper(const MapperOptions& options, const std::optional<Camera>& camera)
    : Mapper(options, camera, &make_grid_engine) {}

Mapper::Mapper(const MapperOptions& options, const std::optional<Camera>& camera,
               const GridEngineMaker& make_engine) {
    check_options(options);
    if (camera) {
        check_camera(*camera);
    }
    implementation_ = std::make_unique<Implementation>(options, camera, make_engine);
}

Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

void Mapper::add_navigation(const NavigationSample& sample) {
    implementation_->add_navigation(sample);
}

ImageResult Mapper::add_image(const DepthImage& image) {
    return implementation_->add_image(image);
}

ImageResult Mapper::add_scan(const Scan& scan) {
    return implementation_->add_scan(scan);
}

void Mapper::observe_zones(ZoneObserver observer) {
    implementation_->observe_zones(std::move(observer));
}

std::vector<Object> Mapper::objects() {
    return implementation_->objects();
}

HeightProfile Mapper::height_profile(std::optional<double> cut_height_m) const {
    return implementation_->height_profile(cut_height_m);
}

int Mapper::value(const CellIndex& cell) const {
    return implementation_->value(cell);
}

void Mapper::for_each_cell(const std::function<void(const CellIndex&, int)>& visit) const {
    implementation_->for_each_cell(visit);
}

void Mapper::for_each_statement(const std::function<void(const CellIndex&, bool)>& visit) const {
    implementation_->for_each_statement(visit);
}

MapStatistics Mapper::statistics() const {
    return implementation_->statistics();
}

const MapperOptions& Mapper::options() const {
    return implementation_->options();
}

} // namespace zonegrid
