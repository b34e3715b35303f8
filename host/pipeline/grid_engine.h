#pragma once

#include "model/fusion.h"
#include "model/rays.h"
#include "model/window.h"
#include "model/zone_bits.h"
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

/// The zoned grid and what is done to it, on one backend. Zones are named by their places in the
/// window that the engine stands on.
///
/// Where memory is refused, calls throw CapacityError and the cells stay as they were; after any
/// other error they cannot be trusted.
class GridEngine {
public:
    GridEngine() = default;
    GridEngine(const GridEngine&) = delete;
    GridEngine& operator=(const GridEngine&) = delete;
    virtual ~GridEngine() = default;

    /// Follows the window. Zones that both windows hold keep their cells; `leave` is called for
    /// each of the others, which are dropped.
    virtual void move_to(
        const Window& window,
        const std::function<void(const ZoneIndex&, const ZoneBits& occupied)>& leave) = 0;

    /// Draws remembered cells into a zone in the window that holds none.
    virtual void draw_objects(const ZoneIndex& zone, std::span<const CellIndex> cells) = 0;

    /// Draws an image or a scan into an empty local map, then adds that to the grid.
    virtual void integrate_image(const ImageRays& rays) = 0;
    virtual void integrate_scan(const ScanRays& scan) = 0;
    virtual FusionResult fuse_local_map() = 0;

    /// Calls `visit` for each zone of which the last image or scan says something, by its place:
    /// ZG_STATEMENT_* of all its cells, order [z][y][x]. For none if that could not be drawn, or if
    /// the window has moved since.
    virtual void visit_local_map(
        const std::function<void(std::uint32_t place, std::span<const std::uint8_t> statements)>&
            visit) = 0;

    /// Places of the zones that hold cells, in no particular order.
    [[nodiscard]] virtual std::span<const std::uint32_t> held() const = 0;
    [[nodiscard]] virtual bool holds(std::uint32_t place) const = 0;

    /// Takes zones of the window whose occupancy has changed into the objects. A zone that leaves
    /// the window stays part of them as it was taken in last.
    virtual void track(std::span<const ZoneIndex> changed) = 0;

    /// Objects of docs/model.md, section 8, over all zones taken in, sorted by identifier.
    [[nodiscard]] virtual const std::vector<Object>& objects() = 0;

    /// Height profile of the zones that hold cells (docs/model.md, section 9), without cells above
    /// `z_least`.
    [[nodiscard]] virtual std::vector<ProfileColumn> profile_heights(std::int32_t z_least) = 0;

    /// The cells of a zone that holds some, order [z][y][x]; valid until the next call.
    [[nodiscard]] virtual std::span<const std::int8_t> values(std::uint32_t place) = 0;
};

/// The engine that `options.backend` names. Throws DeviceError if its device is missing or refused.
[[nodiscard]] std::unique_ptr<GridEngine> make_grid_engine(const MapperOptions& options,
                                                           const std::optional<Camera>& camera,
                                                           const Window& window);

} // namespace zonegrid
