#pragma once

#include "model/lattice.h"
#include "model/zone_bits.h"
#include "reference/label_components.h"
#include "zonegrid/objects.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace zonegrid {

/// Objects over all zones with occupied cells, in the window and remembered. Keeps the pieces of
/// each zone and the description of each object, so that only zones whose occupancy changed are
/// labelled again, and only objects that such a zone is part of are described again.
class ObjectTracker {
public:
    explicit ObjectTracker(std::int32_t zone_edge) : zone_edge_(zone_edge) {}

    /// Sets the occupied cells of one zone, in place of what was known of it.
    void set_zone(const ZoneIndex& zone, const ZoneBits& occupied);

    /// Objects of docs/model.md, section 8, sorted by identifier.
    [[nodiscard]] const std::vector<Object>& objects();

private:
    using Component = std::vector<reference::PieceReference>;

    [[nodiscard]] bool is_unchanged(const Component& component) const;
    [[nodiscard]] Object describe(const Component& component) const;

    std::int32_t zone_edge_;
    std::map<ZoneIndex, reference::ZonePieces> zones_;
    std::map<Component, Object> described_; ///< by the pieces, as they were at the last call
    std::set<ZoneIndex> changed_;           ///< zones set since the last call
    std::vector<Object> objects_;
};

} // namespace zonegrid
