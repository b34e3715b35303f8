#include "support/labelled_zones.h"

#include "reference/label_components.h"

#include <algorithm>

namespace zonegrid {

namespace {

template <class Test>
ZoneBits cells_where(std::int32_t edge, const Test& test) {
    ZoneBits bits(edge);
    for (std::int32_t z = 0; z < edge; ++z) {
        for (std::int32_t y = 0; y < edge; ++y) {
            for (std::int32_t x = 0; x < edge; ++x) {
                if (test(x, y, z)) {
                    bits.set(static_cast<std::uint32_t>((z * edge + y) * edge + x));
                }
            }
        }
    }
    return bits;
}

/// One wall of a square spiral, one cell wide, in every second layer; the layers between join its
/// ends, so that the whole zone is one long piece.
bool on_spiral(std::int32_t edge, std::int32_t x, std::int32_t y, std::int32_t z) {
    if (z % 2 == 1) {
        return z % 4 == 1 ? x == 0 && y == 0 : x == edge / 2 && y == edge / 2;
    }
    const std::int32_t ring = std::min({x, y, edge - 1 - x, edge - 1 - y});
    return ring % 2 == 0 ? !(x == ring && y == ring + 1) : x == ring && y == ring + 1;
}

} // namespace

std::vector<ZoneBits> nasty_zones(oracle::Random& random, std::int32_t edge) {
    std::vector<ZoneBits> zones;
    for (int count = random.pick(1, 8); count > 0; --count) {
        const double share = random.chance(0.3) ? random.real(0.2, 0.4) : random.real(0.0, 1.0);
        const int axis = random.pick(0, 2);
        const int thickness = random.pick(1, 4);
        switch (random.pick(0, 8)) {
            case 0:
                zones.emplace_back(edge); // empty
                break;
            case 1:
                zones.push_back(cells_where(edge, [](int, int, int) { return true; }));
                break;
            case 2:
                zones.emplace_back(edge);
                zones.back().set(
                    static_cast<std::uint32_t>(random.pick(0, edge * edge * edge - 1)));
                break;
            case 3:
                zones.push_back(
                    cells_where(edge, [](int x, int y, int z) { return (x + y + z) % 2 == 0; }));
                break;
            case 4:
                zones.push_back(cells_where(
                    edge, [&](int x, int y, int z) { return on_spiral(edge, x, y, z); }));
                break;
            case 5: // teeth along one axis that meet in its last layer only
                zones.push_back(cells_where(edge, [&](int x, int y, int z) {
                    const int along = axis == 0 ? x : axis == 1 ? y : z;
                    const int beside = axis == 0 ? y + 2 * z : axis == 1 ? x + 2 * z : x + 2 * y;
                    return along == edge - 1 || beside % 4 == 0;
                }));
                break;
            case 6: // slabs
                zones.push_back(cells_where(edge, [&](int x, int y, int z) {
                    return (axis == 0 ? x : axis == 1 ? y : z) / thickness % 2 == 0;
                }));
                break;
            default:
                zones.push_back(
                    cells_where(edge, [&](int, int, int) { return random.chance(share); }));
        }
    }
    return zones;
}

void label(device::Device& device, const std::vector<ZoneBits>& zones,
           ops::LabelComponents& operation) {
    const std::uint64_t plane_bytes = operation.layout().plane_bytes();
    auto planes = device.make_buffer((zones.size() + 1) * plane_bytes);
    device.fill(planes, 0, planes.bytes(), 0xdeadbeefU);
    std::vector<std::uint32_t> slots;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        slots.push_back(static_cast<std::uint32_t>(zones.size() - i));
        device.upload(planes, slots.back() * plane_bytes, std::as_bytes(zones[i].words()));
    }
    operation.dispatch(planes, slots);
}

std::vector<std::vector<CellIndex>> pieces_of(const std::vector<ZoneBits>& zones,
                                              std::int32_t zone_edge) {
    std::vector<std::vector<CellIndex>> pieces;
    for (const auto& zone : zones) {
        for (const auto& piece : reference::label_zone(zone, zone_edge).pieces) {
            auto& cells = pieces.emplace_back();
            for (const auto index : piece) {
                cells.push_back(cell_at({0, 0, 0}, index, zone_edge));
            }
        }
    }
    return pieces;
}

} // namespace zonegrid
