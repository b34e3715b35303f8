#include "reference/label_components.h"

#include <algorithm>
#include <bit>

namespace zonegrid::reference {

namespace {

struct PlaceInZone {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t z;
};

/// `edge` is a power of two: shifts, because a division costs more than all else here.
PlaceInZone coordinates_in_zone(std::uint32_t index, std::uint32_t edge) {
    const auto bits = static_cast<std::uint32_t>(std::countr_zero(edge));
    return {index & (edge - 1), index >> bits & (edge - 1), index >> (2 * bits)};
}

/// Calls `visit(index)` for the up to six neighbours of a cell inside its zone.
template <class Visit>
void for_each_neighbour(std::uint32_t index, std::uint32_t edge, Visit&& visit) {
    const auto [x, y, z] = coordinates_in_zone(index, edge);
    const std::uint32_t coordinates[3] = {x, y, z};
    std::uint32_t stride = 1;
    for (const auto coordinate : coordinates) {
        if (coordinate > 0) {
            visit(index - stride);
        }
        if (coordinate + 1 < edge) {
            visit(index + stride);
        }
        stride *= edge;
    }
}

/// Takes everything connected with `seed` out of `left`.
Piece flood(ZoneBits& left, std::uint32_t seed, std::uint32_t edge) {
    Piece piece;
    std::vector<std::uint32_t> open{seed};
    left.reset(seed);
    while (!open.empty()) {
        const auto index = open.back();
        open.pop_back();
        piece.push_back(static_cast<std::uint16_t>(index));
        for_each_neighbour(index, edge, [&](std::uint32_t neighbour) {
            if (left.test(neighbour)) {
                left.reset(neighbour);
                open.push_back(neighbour);
            }
        });
    }
    std::ranges::sort(piece);
    return piece;
}

/// Enters a piece's cells into the layers at the zone's faces.
void enter_layers(const Piece& piece, std::uint16_t label, std::uint32_t edge, ZonePieces& zone) {
    for (const std::uint32_t index : piece) {
        const auto [x, y, z] = coordinates_in_zone(index, edge);
        const std::uint32_t places[3] = {z * edge + y, z * edge + x, y * edge + x};
        const std::uint32_t depth[3] = {x, y, z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto place = static_cast<std::uint16_t>(places[axis]);
            if (depth[axis] == 0) {
                zone.first_layer[axis].push_back({place, label});
            }
            if (depth[axis] == edge - 1) {
                zone.last_layer[axis].push_back({place, label});
            }
        }
    }
}

ZoneIndex next_on_axis(ZoneIndex zone, std::size_t axis) {
    (axis == 0 ? zone.x : axis == 1 ? zone.y : zone.z) += 1;
    return zone;
}

/// All pieces of all zones, numbered from 0, and which of them touch.
class PieceGraph {
public:
    explicit PieceGraph(const std::map<ZoneIndex, ZonePieces>& zones) {
        for (const auto& [zone, pieces] : zones) {
            first_number_.emplace_hint(first_number_.end(), zone, pieces_.size());
            for (std::size_t piece = 0; piece < pieces.pieces.size(); ++piece) {
                pieces_.push_back({zone, static_cast<std::uint16_t>(piece)});
            }
        }
        touching_.resize(pieces_.size());
        for (const auto& [zone, pieces] : zones) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto next = zones.find(next_on_axis(zone, axis));
                if (next != zones.end()) {
                    link(first_number_.at(zone), pieces.last_layer[axis],
                         first_number_.at(next->first), next->second.first_layer[axis]);
                }
            }
        }
    }

    [[nodiscard]] const std::vector<PieceReference>& pieces() const { return pieces_; }
    [[nodiscard]] const std::vector<std::size_t>& touching(std::size_t number) const {
        return touching_[number];
    }

private:
    /// Links the pieces of two zones that share a face: a layer on either side of it.
    void link(std::size_t first, const BorderLayer& layer, std::size_t next_first,
              const BorderLayer& next_layer) {
        std::uint32_t last = 0;
        auto next = next_layer.begin();
        for (const auto& [place, piece] : layer) {
            while (next != next_layer.end() && next->place < place) {
                ++next;
            }
            if (next == next_layer.end()) {
                return;
            }
            const std::uint32_t both = std::uint32_t{piece} << 16U | next->piece;
            if (next->place != place || both == last) {
                continue;
            }
            last = both; // most often the same two pieces touch along the whole face
            const std::size_t a = first + piece - 1;
            const std::size_t b = next_first + next->piece - 1;
            touching_[a].push_back(b);
            touching_[b].push_back(a);
        }
    }

    std::map<ZoneIndex, std::size_t> first_number_;
    std::vector<PieceReference> pieces_;
    std::vector<std::vector<std::size_t>> touching_;
};

} // namespace

ZonePieces label_zone(const ZoneBits& occupied, std::int32_t zone_edge) {
    const auto edge = static_cast<std::uint32_t>(zone_edge);
    ZonePieces zone;
    ZoneBits left = occupied;
    occupied.for_each([&](std::uint32_t index) {
        if (left.test(index)) {
            zone.pieces.push_back(flood(left, index, edge));
            enter_layers(zone.pieces.back(), static_cast<std::uint16_t>(zone.pieces.size()), edge,
                         zone);
        }
    });
    for (auto* layers : {&zone.first_layer, &zone.last_layer}) {
        for (auto& layer : *layers) {
            std::ranges::sort(layer);
            layer.shrink_to_fit();
        }
    }
    return zone;
}

std::vector<std::vector<PieceReference>> join_pieces(const std::map<ZoneIndex, ZonePieces>& zones) {
    const PieceGraph graph(zones);
    std::vector<bool> reached(graph.pieces().size(), false);
    std::vector<std::vector<PieceReference>> components;
    std::vector<std::size_t> open;
    const auto reach = [&](std::size_t number) {
        if (!reached[number]) {
            reached[number] = true;
            open.push_back(number);
        }
    };
    for (std::size_t seed = 0; seed < reached.size(); ++seed) {
        if (reached[seed]) {
            continue;
        }
        reach(seed);
        auto& component = components.emplace_back();
        while (!open.empty()) {
            const std::size_t number = open.back();
            open.pop_back();
            component.push_back(graph.pieces()[number]);
            for (const auto neighbour : graph.touching(number)) {
                reach(neighbour);
            }
        }
    }
    return components;
}

} // namespace zonegrid::reference
