#pragma once

#include "model/border_layer.h"
#include "model/lattice.h"
#include "zonegrid/objects.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace zonegrid {

/// What a device tells of one piece of a zone, world cells. As an object in its own right, but the
/// trees have the zone as root.
using PieceSummary = Object;

/// The pieces of one zone.
struct ZoneSummary {
    std::vector<PieceSummary> pieces;
    std::array<BorderLayer, 3> first_layer; ///< by axis
    std::array<BorderLayer, 3> last_layer;
};

/// From a layer of ops::LabelComponents: piece numbers from 1 on, 0 for cells that are not
/// occupied.
[[nodiscard]] BorderLayer border_layer(std::span<const std::uint16_t> numbers);

/// Objects over all zones with occupied cells, from what a device tells of each zone: joins pieces
/// by union-find, adds up their numbers and unites their trees. Sees no cell.
class PieceTracker {
public:
    explicit PieceTracker(std::int32_t zone_edge) : zone_edge_(zone_edge) {}

    /// Sets the pieces of one zone, in place of what was known of it.
    void set_zone(const ZoneIndex& zone, ZoneSummary summary);

    /// Objects of docs/model.md, section 8, sorted by identifier.
    [[nodiscard]] const std::vector<Object>& objects();

private:
    struct Member {
        ZoneIndex zone;
        const PieceSummary* piece = nullptr;
    };

    [[nodiscard]] std::vector<std::vector<Member>> components() const;
    [[nodiscard]] Object describe(const std::vector<Member>& component) const;

    std::int32_t zone_edge_;
    std::map<ZoneIndex, ZoneSummary> zones_;
    std::vector<Object> objects_;
    bool outdated_ = false;
};

} // namespace zonegrid
