#pragma once

#include "model/border_layer.h"
#include "model/lattice.h"
#include "model/zone_bits.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace zonegrid::reference {

/// A zone's part of an object: occupied cells connected within the zone, ascending by their place
/// in the zone.
using Piece = std::vector<std::uint16_t>;

/// The pieces of one zone.
struct ZonePieces {
    std::vector<Piece> pieces;
    std::array<BorderLayer, 3> first_layer; ///< by axis
    std::array<BorderLayer, 3> last_layer;
};

/// Which piece of which zone.
struct PieceReference {
    ZoneIndex zone;
    std::uint16_t piece = 0;
    friend auto operator<=>(const PieceReference&, const PieceReference&) = default;
};

/// Components of one zone by flood fill through faces (docs/model.md, section 8.2).
[[nodiscard]] ZonePieces label_zone(const ZoneBits& occupied, std::int32_t zone_edge);

/// Components across zones by flood fill over pieces that share a face of two cells. Each
/// component is a list of its pieces; every piece is in exactly one.
[[nodiscard]] std::vector<std::vector<PieceReference>> join_pieces(
    const std::map<ZoneIndex, ZonePieces>& zones);

} // namespace zonegrid::reference
