#pragma once

#include "model/lattice.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zonegrid {

/// A tree of docs/model.md, section 8.4 (axes = 3) or 8.5 (axes = 2), over one zone.
template <std::size_t axes>
struct ZoneTree {
    std::array<std::int32_t, axes> zone{}; ///< x, y (, z)
    std::span<const std::uint8_t> bytes;
};

/// The tree of the union of `trees`, several of which may stand in one zone. Its root is
/// `edge_zones` zones wide and begins with zone `origin`; all trees lie in it. At least one tree.
template <std::size_t axes>
[[nodiscard]] std::vector<std::uint8_t> unite_zone_trees(
    std::vector<ZoneTree<axes>> trees, const std::array<std::int32_t, axes>& origin,
    std::int32_t edge_zones);

extern template std::vector<std::uint8_t> unite_zone_trees<2>(std::vector<ZoneTree<2>>,
                                                              const std::array<std::int32_t, 2>&,
                                                              std::int32_t);
extern template std::vector<std::uint8_t> unite_zone_trees<3>(std::vector<ZoneTree<3>>,
                                                              const std::array<std::int32_t, 3>&,
                                                              std::int32_t);

} // namespace zonegrid
