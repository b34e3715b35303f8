#include "reference/label_components.h"

#include <algorithm>
#include <utility>

namespace zonegrid::reference {

namespace {

/// Calls `visit(index)` for the up to six neighbours of a cell inside its zone.
template <class Visit>
void for_each_neighbour(std::uint32_t index, std::uint32_t edge, Visit&& visit) {
    const std::uint32_t coordinates[3] = {index % edge, index / edge % edge, index / edge / edge};
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
        const std::uint32_t x = index % edge;
        const std::uint32_t y = index / edge % edge;
        const std::uint32_t z = index / edge / edge;
        const std::uint32_t place[3] = {z * edge + y, z * edge + x, y * edge + x};
        const std::uint32_t depth[3] = {x, y, z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (depth[axis] == 0) {
                zone.first_layer[axis][place[axis]] = label;
            }
            if (depth[axis] == edge - 1) {
                zone.last_layer[axis][place[axis]] = label;
            }
        }
    }
}

ZoneIndex next_on_axis(ZoneIndex zone, std::size_t axis) {
    (axis == 0 ? zone.x : axis == 1 ? zone.y : zone.z) += 1;
    return zone;
}

using Neighbours = std::map<PieceReference, std::vector<PieceReference>>;

/// Which pieces touch across the face between a zone and the next one on `axis`.
void link_across(const ZoneIndex& zone, const ZonePieces& pieces, const ZoneIndex& next_zone,
                 const ZonePieces& next_pieces, std::size_t axis, Neighbours& neighbours) {
    const auto& here = pieces.last_layer[axis];
    const auto& there = next_pieces.first_layer[axis];
    std::vector<std::pair<std::uint16_t, std::uint16_t>> links;
    for (std::size_t i = 0; i < here.size(); ++i) {
        const std::pair link{here[i], there[i]};
        if (here[i] != 0 && there[i] != 0 && (links.empty() || links.back() != link)) {
            links.push_back(link);
        }
    }
    for (const auto& [a, b] : links) {
        const PieceReference first{zone, static_cast<std::uint16_t>(a - 1)};
        const PieceReference second{next_zone, static_cast<std::uint16_t>(b - 1)};
        neighbours[first].push_back(second);
        neighbours[second].push_back(first);
    }
}

Neighbours link_pieces(const std::map<ZoneIndex, ZonePieces>& zones) {
    Neighbours neighbours;
    for (const auto& [zone, pieces] : zones) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto next = zones.find(next_on_axis(zone, axis));
            if (next != zones.end()) {
                link_across(zone, pieces, next->first, next->second, axis, neighbours);
            }
        }
    }
    return neighbours;
}

} // namespace

ZonePieces label_zone(const ZoneBits& occupied, std::int32_t zone_edge) {
    const auto edge = static_cast<std::uint32_t>(zone_edge);
    ZonePieces zone;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        zone.first_layer[axis].assign(std::size_t{edge} * edge, 0);
        zone.last_layer[axis].assign(std::size_t{edge} * edge, 0);
    }
    ZoneBits left = occupied;
    occupied.for_each([&](std::uint32_t index) {
        if (left.test(index)) {
            zone.pieces.push_back(flood(left, index, edge));
            enter_layers(zone.pieces.back(), static_cast<std::uint16_t>(zone.pieces.size()), edge,
                         zone);
        }
    });
    return zone;
}

std::vector<std::vector<PieceReference>> join_pieces(const std::map<ZoneIndex, ZonePieces>& zones) {
    const Neighbours neighbours = link_pieces(zones);
    std::map<ZoneIndex, std::vector<bool>> reached;
    for (const auto& [zone, pieces] : zones) {
        reached.emplace(zone, std::vector<bool>(pieces.pieces.size(), false));
    }
    std::vector<std::vector<PieceReference>> components;
    const auto flood_from = [&](const PieceReference& seed) {
        std::vector<PieceReference> component{seed};
        reached[seed.zone][seed.piece] = true;
        for (std::size_t next = 0; next < component.size(); ++next) {
            const auto linked = neighbours.find(component[next]);
            if (linked == neighbours.end()) {
                continue;
            }
            for (const auto& neighbour : linked->second) {
                if (!reached[neighbour.zone][neighbour.piece]) {
                    reached[neighbour.zone][neighbour.piece] = true;
                    component.push_back(neighbour);
                }
            }
        }
        components.push_back(std::move(component));
    };
    for (const auto& [zone, pieces] : zones) {
        for (std::size_t piece = 0; piece < pieces.pieces.size(); ++piece) {
            const PieceReference seed{zone, static_cast<std::uint16_t>(piece)};
            if (!reached[zone][piece]) {
                flood_from(seed);
            }
        }
    }
    return components;
}

} // namespace zonegrid::reference
