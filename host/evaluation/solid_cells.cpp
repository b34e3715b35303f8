#include "evaluation/solid_cells.h"

#include <algorithm>

namespace zonegrid {
namespace {

constexpr std::int32_t edge = CellSet::zone_edge;
constexpr std::size_t rows = edge; ///< words of a layer: a word holds a row along x

constexpr std::size_t word_of(std::size_t z, std::size_t y) {
    return z * rows + y;
}

/// Spreads set bits to their neighbours as far as `open` lets them.
std::uint32_t spread_row(std::uint32_t row, std::uint32_t open) {
    for (std::uint32_t before = 0; before != row;) {
        before = row;
        row |= (row << 1U | row >> 1U) & open;
    }
    return row;
}

/// One row with what its neighbours bring in.
std::uint32_t fill_row(std::span<const std::uint32_t> bits, std::uint32_t open, std::size_t z,
                       std::size_t y) {
    std::uint32_t beside = 0;
    beside |= y > 0 ? bits[word_of(z, y - 1)] : 0U;
    beside |= y + 1 < rows ? bits[word_of(z, y + 1)] : 0U;
    beside |= z > 0 ? bits[word_of(z - 1, y)] : 0U;
    beside |= z + 1 < rows ? bits[word_of(z + 1, y)] : 0U;
    return spread_row((bits[word_of(z, y)] | beside) & open, open);
}

/// Fills a zone from the bits that are set, all of which are open.
void fill(ZoneBits& reached, const ZoneBits& open) {
    const auto bits = reached.words();
    for (bool changed = true; changed;) {
        changed = false;
        const auto visit = [&](std::size_t word) {
            const std::uint32_t row = fill_row(bits, open.words()[word], word / rows, word % rows);
            changed = changed || row != bits[word];
            bits[word] = row;
        };
        // Forwards and back again, so that one pass goes all the way in either direction.
        for (std::size_t word = 0; word < bits.size(); ++word) {
            visit(word);
        }
        for (std::size_t word = bits.size(); word-- > 0;) {
            visit(word);
        }
    }
}

ZoneBits all_bits() {
    ZoneBits bits(edge);
    std::ranges::fill(bits.words(), 0xFFFFFFFFU);
    return bits;
}

/// What a zone's cells bring to its neighbour on an axis, `step` -1 or 1.
ZoneBits across(const ZoneBits& bits, int axis, int step) {
    ZoneBits brought(edge);
    const std::size_t last = rows - 1;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < rows; ++k) {
            if (axis == 0) {
                const std::uint32_t row = bits.words()[word_of(i, k)];
                brought.words()[word_of(i, k)] = step > 0 ? row >> 31U : row << 31U;
            } else if (axis == 1 && k == (step > 0 ? 0 : last)) {
                brought.words()[word_of(i, k)] = bits.words()[word_of(i, last - k)];
            } else if (axis == 2 && i == (step > 0 ? 0 : last)) {
                brought.words()[word_of(i, k)] = bits.words()[word_of(last - i, k)];
            }
        }
    }
    return brought;
}

} // namespace

SolidCells::SolidCells(const CellSet& touched, const CellBox& region,
                       std::span<const CellIndex> open)
    : touched_(touched), region_(region) {
    seed_top();
    for (const auto& cell : open) {
        if (region_.contains(cell)) {
            ZoneBits bits(edge);
            bits.set(index_in_zone(cell, edge));
            reach(zone_of(cell, edge), bits);
        }
    }
    while (!waiting_.empty()) {
        const ZoneIndex zone = waiting_.back();
        waiting_.pop_back();
        spread(zone);
    }
}

bool SolidCells::contains(const CellIndex& cell) const {
    if (!region_.contains(cell) || touched_.contains(cell)) {
        return false;
    }
    const auto found = reached_.find(zone_of(cell, edge));
    return found == reached_.end() ||
           (found->second && !found->second->test(index_in_zone(cell, edge)));
}

void SolidCells::seed_top() {
    const ZoneIndex low = zone_of(region_.low, edge);
    const ZoneIndex high = zone_of(region_.high, edge);
    const auto layer = static_cast<std::size_t>(region_.low.z - low.z * edge);
    ZoneBits bits(edge);
    for (std::size_t y = 0; y < rows; ++y) {
        bits.words()[word_of(layer, y)] = 0xFFFFFFFFU;
    }
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            reach({x, y, low.z}, bits);
        }
    }
}

void SolidCells::reach(const ZoneIndex& zone, const ZoneBits& from) {
    if (!meets_region(zone)) {
        return;
    }
    const auto known = reached_.find(zone);
    if (known != reached_.end() && !known->second) {
        return; // all of it
    }
    if (is_inside(zone) && !touched_.zones().contains(zone)) {
        if (from.any()) {
            reached_.emplace(zone, std::nullopt);
            waiting_.push_back(zone);
        }
        return;
    }
    const ZoneBits open = open_cells(zone);
    ZoneBits bits = known == reached_.end() ? ZoneBits(edge) : *known->second;
    bool more = false;
    for (std::size_t word = 0; word < bits.words().size(); ++word) {
        const std::uint32_t entering = from.words()[word] & open.words()[word];
        more = more || (entering & ~bits.words()[word]) != 0;
        bits.words()[word] |= entering;
    }
    if (more) {
        fill(bits, open);
        reached_.insert_or_assign(zone, std::move(bits));
        waiting_.push_back(zone);
    }
}

void SolidCells::spread(const ZoneIndex& zone) {
    const Reached& reached = reached_.at(zone);
    const ZoneBits bits = reached ? *reached : all_bits();
    for (const int step : {-1, 1}) {
        reach({zone.x + step, zone.y, zone.z}, across(bits, 0, step));
        reach({zone.x, zone.y + step, zone.z}, across(bits, 1, step));
        reach({zone.x, zone.y, zone.z + step}, across(bits, 2, step));
    }
}

ZoneBits SolidCells::open_cells(const ZoneIndex& zone) const {
    ZoneBits open = all_bits();
    const auto found = touched_.zones().find(zone);
    if (found != touched_.zones().end()) {
        for (std::size_t word = 0; word < open.words().size(); ++word) {
            open.words()[word] = ~found->second.words()[word];
        }
    }
    if (!is_inside(zone)) {
        for (std::uint32_t index = 0; index < open.words().size() * 32; ++index) {
            if (!region_.contains(cell_at(zone, index, edge))) {
                open.reset(index);
            }
        }
    }
    return open;
}

bool SolidCells::is_inside(const ZoneIndex& zone) const {
    const CellIndex low = first_cell_of(zone, edge);
    return region_.contains(low) &&
           region_.contains({low.x + edge - 1, low.y + edge - 1, low.z + edge - 1});
}

bool SolidCells::meets_region(const ZoneIndex& zone) const {
    const ZoneIndex low = zone_of(region_.low, edge);
    const ZoneIndex high = zone_of(region_.high, edge);
    return zone.x >= low.x && zone.y >= low.y && zone.z >= low.z && zone.x <= high.x &&
           zone.y <= high.y && zone.z <= high.z;
}

} // namespace zonegrid
