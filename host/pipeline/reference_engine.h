#pragma once

#include "model/local_map.h"
#include "model/zoned_cells.h"
#include "pipeline/grid_engine.h"
#include "pipeline/object_tracker.h"

namespace zonegrid {

/// The scalar reference on the processor.
class ReferenceEngine : public GridEngine {
public:
    ReferenceEngine(const MapperOptions& options, const Window& window);

    void move_to(const Window& window,
                 const std::function<void(const ZoneIndex&, const ZoneBits&)>& leave) override;
    void draw_objects(const ZoneIndex& zone, std::span<const CellIndex> cells) override;
    void integrate_image(const ImageRays& rays) override;
    void integrate_scan(const ScanRays& scan) override;
    FusionResult fuse_local_map() override;
    void visit_local_map(
        const std::function<void(std::uint32_t, std::span<const std::uint8_t>)>& visit) override;
    [[nodiscard]] std::span<const std::uint32_t> held() const override { return grid_.held(); }
    [[nodiscard]] bool holds(std::uint32_t place) const override {
        return !grid_.find(place).empty();
    }
    void track(std::span<const ZoneIndex> changed) override;
    [[nodiscard]] const std::vector<Object>& objects() override { return tracker_.objects(); }
    [[nodiscard]] std::vector<ProfileColumn> profile_heights(std::int32_t z_least) override;
    [[nodiscard]] std::span<const std::int8_t> values(std::uint32_t place) override {
        return grid_.find(place);
    }

private:
    [[nodiscard]] ZoneBits occupied(std::uint32_t place) const;

    FusionRule rule_;
    Grid grid_;
    LocalMap local_map_;
    View view_; ///< of the last image or scan
    ObjectTracker tracker_;
};

} // namespace zonegrid
