#include "evaluation/cell_set.h"

namespace zonegrid {
namespace {

constexpr int edge_bits = 5;
static_assert(1 << edge_bits == CellSet::zone_edge);

// By shifts, which round towards minus infinity: these run for every cell that a ray passes.
constexpr ZoneIndex zone_with(const CellIndex& cell) {
    return {cell.x >> edge_bits, cell.y >> edge_bits, cell.z >> edge_bits};
}

constexpr std::uint32_t place_of(const CellIndex& cell) {
    constexpr std::int32_t mask = CellSet::zone_edge - 1;
    return static_cast<std::uint32_t>(
        (((cell.z & mask) << edge_bits | (cell.y & mask)) << edge_bits) | (cell.x & mask));
}

} // namespace

bool CellSet::insert(const CellIndex& cell) {
    const ZoneIndex zone = zone_with(cell);
    if (inserted_bits_ == nullptr || zone != inserted_zone_) {
        // References into an unordered_map stay valid as it grows.
        inserted_bits_ = &zones_.try_emplace(zone, zone_edge).first->second;
        inserted_zone_ = zone;
    }
    const std::uint32_t place = place_of(cell);
    if (inserted_bits_->test(place)) {
        return false;
    }
    inserted_bits_->set(place);
    ++size_;
    return true;
}

void CellSet::insert_all(const CellSet& other) {
    other.for_each([this](const CellIndex& cell) { insert(cell); });
}

bool CellSet::contains(const CellIndex& cell) const {
    const ZoneBits* const bits = find(zone_with(cell));
    return bits != nullptr && bits->test(place_of(cell));
}

bool CellSet::contains_within(const CellIndex& cell, std::int32_t reach) const {
    if (contains(cell)) {
        return true;
    }
    bool found = false;
    for_each_within(cell, reach, [&](const CellIndex& near) { found = found || contains(near); });
    return found;
}

const ZoneBits* CellSet::find(const ZoneIndex& zone) const {
    const auto found = zones_.find(zone);
    return found == zones_.end() ? nullptr : &found->second;
}

} // namespace zonegrid
