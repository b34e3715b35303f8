#pragma once

#include "zonegrid/objects.h"
#include "zonegrid/options.h"
#include "zonegrid/sensors.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace zonegrid {

/// What became of an image or scan.
enum class ImageStatus {
    integrated,
    no_navigation,     ///< no navigation sample within max_gap_s: skipped
    pose_out_of_range, ///< the sensor is more than 2^30 cells from the origin: skipped
    out_of_order       ///< its time is not after the previous image's: skipped
};

/// What one image or scan did to the map. Times are wall clock.
struct ImageResult {
    ImageStatus status = ImageStatus::integrated;
    Eigen::Isometry3d world_from_sensor = Eigen::Isometry3d::Identity();
    std::uint64_t rays = 0;          ///< pixels or points that made a statement
    std::uint64_t missing = 0;       ///< pixels or points that made none
    std::uint64_t dropped = 0;       ///< scan rays that start or end outside the window
    std::uint64_t zones_entered = 0; ///< zones drawn back from the feature map
    std::uint64_t zones_left = 0;    ///< zones with cells that left the window
    std::uint64_t cells_changed = 0; ///< cells whose value is another than before
    double prepare_s = 0.0;          ///< pose, rays, depth to integers
    double window_s = 0.0;           ///< zones that enter and leave
    double integrate_s = 0.0;        ///< local map
    double fuse_s = 0.0;             ///< local map into the grid
};

/// What the map holds now.
struct MapStatistics {
    CellIndex window_first_cell;        ///< first cell of the window
    int window_cells = 0;               ///< edge of the window, cells
    std::uint64_t zones_held = 0;       ///< zones that cost cell memory
    std::uint64_t zones_held_most = 0;  ///< high-water mark of zones_held
    std::uint64_t zones_remembered = 0; ///< zones outside the window with occupied cells
    std::uint64_t cells_occupied = 0;   ///< in the window
    std::uint64_t cells_free = 0;       ///< in the window: value below 0
};

class GridEngine;
class Window;

/// Makes the part of a Mapper that computes (host/pipeline/grid_engine.h).
using GridEngineMaker = std::function<std::unique_ptr<GridEngine>(
    const MapperOptions&, const std::optional<Camera>&, const Window&)>;

/// Gets the values of one zone: its first cell, then all of its cells, order [z][y][x]. The values
/// are valid during the call.
using ZoneObserver =
    std::function<void(const CellIndex& first_cell, std::span<const std::int8_t> values)>;

/// The obstacle mapper: navigation in, image in, map out. Needs no file.
///
/// Not safe for concurrent calls on one Mapper; two Mappers are independent.
class Mapper {
public:
    /// `camera` is needed for `add_image`. Throws UsageError if an option or the camera cannot
    /// work, CapacityError if cell and range do not fit a window of 2048 cells an axis.
    explicit Mapper(const MapperOptions& options, const std::optional<Camera>& camera = {});
    /// The same on an engine of the caller's, whatever backend `options` names.
    Mapper(const MapperOptions& options, const std::optional<Camera>& camera,
           const GridEngineMaker& make_engine);
    ~Mapper();
    Mapper(const Mapper&) = delete;
    Mapper& operator=(const Mapper&) = delete;
    Mapper(Mapper&&) noexcept;
    Mapper& operator=(Mapper&&) noexcept;

    /// Samples come in strictly increasing order of time; the last 10 s are kept.
    /// Throws InputError if the sample is not finite, not a rotation, or not after the last one.
    void add_navigation(const NavigationSample& sample);

    /// Integrates and fuses one depth image of the camera's size.
    /// Throws UsageError if there is no camera or the size differs. On a device also CapacityError
    /// if it has no memory for the image, which is dropped: cells stay as they were, and the next
    /// image may fit; and DeviceError if the device fails: then the map has ended, and calls throw
    /// UsageError.
    ImageResult add_image(const DepthImage& image);

    /// Integrates and fuses one scan (always with the `line` model).
    ImageResult add_scan(const Scan& scan);

    /// From now on `observer` gets, during `add_image` and `add_scan`, each zone in which a cell
    /// has another value than before, and each that is drawn back from the feature map. Who keeps
    /// the last values of each zone so knows also what was in zones that left the window. An empty
    /// observer ends it. Costs a copy of these zones from the device, and nothing without one.
    /// What it throws comes out of the call that it watches, and ends the map unless it is an
    /// Error.
    void observe_zones(ZoneObserver observer);

    /// All objects, in the window and remembered, sorted by identifier. Zones whose occupancy did
    /// not change since the last call are not labelled again.
    [[nodiscard]] std::vector<Object> objects();

    /// Highest occupied cells, in the window and remembered. Cells higher than `cut_height_m`
    /// metres above the world's origin are left out. Throws UsageError if that is NaN.
    [[nodiscard]] HeightProfile height_profile(std::optional<double> cut_height_m = {}) const;

    /// Value of a cell; 0 outside the window.
    [[nodiscard]] int value(const CellIndex& cell) const;

    /// Calls `visit` for every cell in the window with a value other than 0, by x, then y, then z.
    void for_each_cell(const std::function<void(const CellIndex&, int)>& visit) const;

    /// Calls `visit` for every cell of which the last image or scan that was integrated says
    /// something, before it was added to the cells (the local map, docs/model.md, section 5). The
    /// order is the same on every backend. For none if the device's memory did not suffice for it.
    void for_each_statement(
        const std::function<void(const CellIndex& cell, bool occupied)>& visit) const;

    [[nodiscard]] MapStatistics statistics() const;
    [[nodiscard]] const MapperOptions& options() const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace zonegrid
