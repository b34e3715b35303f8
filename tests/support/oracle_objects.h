#pragma once

#include "zonegrid/objects.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace zonegrid::oracle {

using CellSet = std::set<CellIndex>;

/// Objects of a set of occupied cells by union-find over its cells (docs/model.md, section 8).
[[nodiscard]] std::vector<Object> objects_of(const CellSet& occupied, int zone);

/// Octree of one object: for every node, every child's cells are counted (section 8.4).
[[nodiscard]] std::vector<std::uint8_t> octree_of(const CellSet& cells, int zone);

/// Prism of one object: quadtree of its ground plan (section 8.5).
[[nodiscard]] std::vector<std::uint8_t> prism_of(const CellSet& cells, int zone);

/// Height profile (section 9).
[[nodiscard]] std::vector<ProfileColumn> profile_of(const CellSet& occupied, double cell_m,
                                                    std::optional<double> cut_height_m);

/// The bytes under `digest.cells` (section 10), for values in the map's order.
[[nodiscard]] std::string cells_text(const std::map<CellIndex, int>& values);

/// The bytes under `digest.objects` (section 10), in the order given.
[[nodiscard]] std::string objects_text(const std::vector<Object>& objects);

} // namespace zonegrid::oracle
