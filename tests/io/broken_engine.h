#pragma once

#include "model/fusion.h"
#include "pipeline/object_tracker.h"
#include "pipeline/reference_engine.h"

#include <cstdint>
#include <memory>
#include <set>
#include <vector>

namespace zonegrid::testing {

/// What a broken engine does wrong.
enum class Fault {
    none,
    image_loses_a_pixel,  ///< the first pixel of each image that says something says nothing
    scan_loses_a_ray,     ///< the first ray of each scan
    fusion_forgets_limit, ///< cells grow beyond the limit by one
    drawing_loses_cells,  ///< zones come back empty
    drawing_adds_one,     ///< cells come back with one more
    planes_lose_a_cell,   ///< the first occupied cell of each zone is not told of
    counts_one_too_many   ///< cells changed
};

/// The reference with a fault, in place of a device whose driver has one.
class BrokenEngine final : public GridEngine {
public:
    BrokenEngine(const MapperOptions& options, const Window& window, Fault fault)
        : fault_(fault),
          rule_(options),
          window_(window),
          engine_(options, window),
          tracker_(options.zone) {}

    void move_to(const Window& window,
                 const std::function<void(const ZoneIndex&, const ZoneBits&)>& leave) override {
        window_ = window;
        engine_.move_to(window, leave);
    }
    void draw_objects(const ZoneIndex& zone, std::span<const CellIndex> cells) override {
        drawn_.insert(zone);
        engine_.draw_objects(
            zone, fault_ == Fault::drawing_loses_cells ? std::span<const CellIndex>() : cells);
    }
    void integrate_image(const ImageRays& rays) override {
        ImageRays drawn = rays;
        if (fault_ == Fault::image_loses_a_pixel) {
            for (PixelDepth& depth : drawn.depths) {
                if (depth.near >= 0) {
                    depth = {};
                    break;
                }
            }
        }
        engine_.integrate_image(drawn);
    }
    void integrate_scan(const ScanRays& scan) override {
        ScanRays drawn = scan;
        if (fault_ == Fault::scan_loses_a_ray && !drawn.rays.empty()) {
            drawn.rays.erase(drawn.rays.begin());
        }
        engine_.integrate_scan(drawn);
    }
    FusionResult fuse_local_map() override {
        FusionResult result = engine_.fuse_local_map();
        result.cells_changed += fault_ == Fault::counts_one_too_many ? 1U : 0U;
        return result;
    }
    void visit_local_map(
        const std::function<void(std::uint32_t, std::span<const std::uint8_t>)>& visit) override {
        engine_.visit_local_map(visit);
    }
    [[nodiscard]] std::span<const std::uint32_t> held() const override { return engine_.held(); }
    [[nodiscard]] bool holds(std::uint32_t place) const override { return engine_.holds(place); }
    void track(std::span<const ZoneIndex> changed) override {
        for (const ZoneIndex& zone : changed) {
            ZoneBits bits = occupied_bits(engine_.values(window_.place_of(zone)), rule_.threshold,
                                          window_.zone_edge());
            if (fault_ == Fault::planes_lose_a_cell) {
                for (std::uint32_t& word : bits.words()) {
                    if (word != 0) {
                        word &= word - 1;
                        break;
                    }
                }
            }
            tracker_.set_zone(zone, bits);
        }
    }
    [[nodiscard]] const std::vector<Object>& objects() override { return tracker_.objects(); }
    [[nodiscard]] std::vector<ProfileColumn> profile_heights(std::int32_t z_least) override {
        return engine_.profile_heights(z_least);
    }
    [[nodiscard]] std::span<const std::int8_t> values(std::uint32_t place) override {
        const bool drawn = drawn_.contains(window_.zone_at(place));
        const auto values = engine_.values(place);
        values_.assign(values.begin(), values.end());
        for (std::int8_t& value : values_) {
            if ((fault_ == Fault::fusion_forgets_limit && value == rule_.limit) ||
                (fault_ == Fault::drawing_adds_one && drawn && value == rule_.drawn())) {
                value = static_cast<std::int8_t>(value + 1);
            }
        }
        return values_;
    }

private:
    Fault fault_;
    FusionRule rule_;
    Window window_;
    std::set<ZoneIndex> drawn_; ///< zones that came back
    ReferenceEngine engine_;
    ObjectTracker tracker_;
    std::vector<std::int8_t> values_;
};

} // namespace zonegrid::testing
