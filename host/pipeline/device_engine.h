#pragma once

#include "ops/device_grid.h"
#include "ops/device_local_map.h"
#include "ops/draw_objects.h"
#include "ops/encode_octree.h"
#include "ops/encode_prism.h"
#include "ops/fuse_local_map.h"
#include "ops/integrate_image.h"
#include "ops/integrate_scan.h"
#include "ops/label_components.h"
#include "ops/measure_objects.h"
#include "ops/profile_heights.h"
#include "pipeline/grid_engine.h"
#include "pipeline/piece_tracker.h"

#include <map>
#include <optional>
#include <string>

namespace zonegrid {

/// The kernels on one OpenCL or Vulkan device. The grid stays in its memory.
class DeviceEngine : public GridEngine {
public:
    /// Throws DeviceError if the device that `options.backend` names is missing or refused.
    DeviceEngine(const MapperOptions& options, const std::optional<Camera>& camera,
                 const Window& window);

    void move_to(const Window& window,
                 const std::function<void(const ZoneIndex&, const ZoneBits&)>& leave) override;
    void draw_objects(const ZoneIndex& zone, std::span<const CellIndex> cells) override;
    void integrate_image(const ImageRays& rays) override;
    void integrate_scan(const ScanRays& scan) override;
    FusionResult fuse_local_map() override;
    void visit_local_map(
        const std::function<void(std::uint32_t, std::span<const std::uint8_t>)>& visit) override;
    [[nodiscard]] std::span<const std::uint32_t> held() const override { return held_; }
    [[nodiscard]] bool holds(std::uint32_t place) const override { return slots_.contains(place); }
    void track(std::span<const ZoneIndex> changed) override;
    [[nodiscard]] const std::vector<Object>& objects() override { return tracker_.objects(); }
    [[nodiscard]] std::vector<ProfileColumn> profile_heights(std::int32_t z_least) override;
    [[nodiscard]] std::span<const std::int8_t> values(std::uint32_t place) override;

private:
    using Slot = ops::DeviceGrid::Slot;
    /// Least z of each column, by x, then y.
    using Columns = std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t>;

    [[nodiscard]] ZoneBits occupied_in(const Slot& slot);
    void reserve(std::vector<std::uint32_t> places);
    /// Takes slots in the grid for the reserved zones.
    void take_slots();
    /// Adds the reserved zones with these indices, whose slots lie in one chunk, to the grid.
    void fuse_chunk(std::uint32_t chunk, std::span<const std::size_t> reserved,
                    FusionResult& result);
    /// Takes zones, by their first cells, whose slots lie in one chunk into the profile.
    void profile_in(ops::DeviceGrid::Chunk& chunk,
                    std::span<const std::pair<CellIndex, ops::ProfiledZone>> zones,
                    Columns& columns);
    /// How many zones there is memory to label or profile at once, at least one.
    [[nodiscard]] std::size_t zones_at_once() const;
    /// Takes zones whose slots lie in one chunk into the objects.
    void track_in(ops::DeviceGrid::Chunk& chunk, std::span<const ZoneIndex> zones);
    void note_held();
    /// Does a step that takes memory. Where that is refused, the error says what would fit.
    template <class Step>
    auto take_memory(const Step& step) const;

    MapperOptions options_;
    std::optional<Camera> camera_;
    Window window_;
    std::unique_ptr<device::Device> device_;
    ops::DeviceGrid grid_;
    ops::DeviceLocalMap local_map_;
    ops::IntegrateImage integrate_image_;
    ops::IntegrateScan integrate_scan_;
    ops::FuseLocalMap fuse_local_map_;
    ops::DrawObjects draw_objects_;
    ops::LabelComponents label_components_;
    ops::MeasureObjects measure_objects_;
    ops::EncodeOctree encode_octree_;
    ops::EncodePrism encode_prism_;
    ops::ProfileHeights profile_heights_;
    PieceTracker tracker_;
    std::map<std::uint32_t, Slot> slots_; ///< of the zones that hold cells, by place
    std::vector<std::uint32_t> held_;     ///< their places
    std::vector<std::uint32_t> reserved_; ///< places of the local map's zones
    View view_;                           ///< of the last image or scan
    bool drawn_ = false;                  ///< whether the local map is that of the last image
    std::vector<std::int8_t> values_;     ///< of the zone asked for last
};

} // namespace zonegrid
