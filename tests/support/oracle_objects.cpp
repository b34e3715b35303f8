#include "support/oracle_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <utility>

namespace zonegrid::oracle {

namespace {

using Corner = std::array<std::int64_t, 3>;

/// Disjoint sets of cells; every set is known by its least cell.
class CellForest {
public:
    explicit CellForest(const CellSet& cells) {
        for (const CellIndex& cell : cells) {
            parent_.emplace(cell, cell);
        }
    }

    CellIndex root(const CellIndex& cell) {
        CellIndex top = cell;
        while (parent_.at(top) != top) {
            top = parent_.at(top);
        }
        for (CellIndex below = cell; below != top;) {
            below = std::exchange(parent_.at(below), top);
        }
        return top;
    }

    void unite_if_present(const CellIndex& cell, const CellIndex& neighbour) {
        if (!parent_.contains(neighbour)) {
            return;
        }
        const CellIndex a = root(cell);
        const CellIndex b = root(neighbour);
        parent_.at(std::max(a, b)) = std::min(a, b);
    }

private:
    std::map<CellIndex, CellIndex> parent_;
};

std::int64_t first_of_zone(std::int64_t cell, std::int64_t zone) {
    const std::int64_t rest = ((cell % zone) + zone) % zone;
    return cell - rest;
}

/// The cells of `cells` in the box of `edge` cells from `corner`; `axes` 2 leaves z out.
std::vector<Corner> cells_within(const std::vector<Corner>& cells, const Corner& corner,
                                 std::int64_t edge, std::size_t axes) {
    std::vector<Corner> result;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(result), [&](const Corner& cell) {
        for (std::size_t i = 0; i < axes; ++i) {
            if (cell[i] < corner[i] || cell[i] >= corner[i] + edge) {
                return false;
            }
        }
        return true;
    });
    return result;
}

/// Writes a node over `cells`, all of which lie in it, and the children it needs. Serves both
/// trees: `axes` is 3 for the octree, 2 for the quadtree.
void write_node(const std::vector<Corner>& cells, const Corner& corner, std::int64_t edge,
                std::size_t axes, std::vector<std::uint8_t>& bytes) {
    const std::int64_t half = edge / 2;
    const std::size_t children = std::size_t{1} << axes;
    const std::size_t whole =
        static_cast<std::size_t>(axes == 3 ? half * half * half : half * half);
    unsigned word = 0;
    std::vector<std::pair<Corner, std::vector<Corner>>> mixed;
    for (std::size_t child = 0; child < children; ++child) {
        Corner at = corner;
        for (std::size_t i = 0; i < axes; ++i) {
            at[i] += ((child >> i) & 1U) != 0 ? half : 0;
        }
        std::vector<Corner> inside = cells_within(cells, at, half, axes);
        if (inside.size() == whole) {
            word |= 1U << (2 * child);
        } else if (!inside.empty()) {
            word |= 2U << (2 * child);
            mixed.emplace_back(at, std::move(inside));
        }
    }
    bytes.push_back(static_cast<std::uint8_t>(word & 0xFFU));
    if (axes == 3) {
        bytes.push_back(static_cast<std::uint8_t>(word >> 8U));
    }
    for (const auto& [at, inside] : mixed) {
        write_node(inside, at, half, axes, bytes);
    }
}

/// Tree over distinct `cells`: root at the zone's corner, edge doubled until the box is inside.
std::vector<std::uint8_t> tree_of(const std::vector<Corner>& cells, int zone, std::size_t axes) {
    Corner low = cells.front();
    Corner high = cells.front();
    for (const Corner& cell : cells) {
        for (std::size_t i = 0; i < axes; ++i) {
            low[i] = std::min(low[i], cell[i]);
            high[i] = std::max(high[i], cell[i]);
        }
    }
    Corner corner{};
    std::int64_t edge = zone;
    for (std::size_t i = 0; i < axes; ++i) {
        corner[i] = first_of_zone(low[i], zone);
        while (corner[i] + edge <= high[i]) {
            edge *= 2;
        }
    }
    std::vector<std::uint8_t> bytes;
    write_node(cells, corner, edge, axes, bytes);
    return bytes;
}

Object measure(const CellSet& cells, int zone) {
    Object object;
    object.id = *cells.begin();
    object.box_min = *cells.begin();
    object.box_max = *cells.begin();
    for (const CellIndex& cell : cells) {
        ++object.cell_count;
        object.box_min = {std::min(object.box_min.x, cell.x), std::min(object.box_min.y, cell.y),
                          std::min(object.box_min.z, cell.z)};
        object.box_max = {std::max(object.box_max.x, cell.x), std::max(object.box_max.y, cell.y),
                          std::max(object.box_max.z, cell.z)};
        object.cell_sum[0] += cell.x;
        object.cell_sum[1] += cell.y;
        object.cell_sum[2] += cell.z;
    }
    object.octree = octree_of(cells, zone);
    object.prism = prism_of(cells, zone);
    return object;
}

std::string hexadecimal(const std::vector<std::uint8_t>& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

} // namespace

std::vector<Object> objects_of(const CellSet& occupied, int zone) {
    CellForest forest(occupied);
    for (const CellIndex& cell : occupied) {
        forest.unite_if_present(cell, {cell.x + 1, cell.y, cell.z});
        forest.unite_if_present(cell, {cell.x, cell.y + 1, cell.z});
        forest.unite_if_present(cell, {cell.x, cell.y, cell.z + 1});
    }
    std::map<CellIndex, CellSet> members;
    for (const CellIndex& cell : occupied) {
        members[forest.root(cell)].insert(cell);
    }
    std::vector<Object> result;
    for (const auto& [id, cells] : members) {
        result.push_back(measure(cells, zone));
    }
    return result;
}

std::vector<std::uint8_t> octree_of(const CellSet& cells, int zone) {
    std::vector<Corner> list;
    for (const CellIndex& cell : cells) {
        list.push_back({cell.x, cell.y, cell.z});
    }
    return tree_of(list, zone, 3);
}

std::vector<std::uint8_t> prism_of(const CellSet& cells, int zone) {
    std::set<Corner> columns;
    for (const CellIndex& cell : cells) {
        columns.insert({cell.x, cell.y, 0});
    }
    return tree_of({columns.begin(), columns.end()}, zone, 2);
}

std::vector<ProfileColumn> profile_of(const CellSet& occupied, double cell_m,
                                      std::optional<double> cut_height_m) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> least;
    for (const CellIndex& cell : occupied) {
        if (cut_height_m && static_cast<double>(cell.z) < std::ceil(-*cut_height_m / cell_m)) {
            continue;
        }
        const auto [at, added] = least.try_emplace({cell.x, cell.y}, cell.z);
        at->second = std::min(at->second, cell.z);
    }
    std::vector<ProfileColumn> result;
    for (const auto& [column, z] : least) {
        result.push_back({column.first, column.second, z});
    }
    return result;
}

std::string cells_text(const std::map<CellIndex, int>& values) {
    std::ostringstream text;
    for (const auto& [cell, value] : values) {
        if (value != 0) {
            text << cell.x << ' ' << cell.y << ' ' << cell.z << ' ' << value << '\n';
        }
    }
    return text.str();
}

std::string objects_text(const std::vector<Object>& objects) {
    std::ostringstream text;
    for (const Object& object : objects) {
        text << object.id.x << ' ' << object.id.y << ' ' << object.id.z << ' ' << object.cell_count
             << ' ' << object.box_min.x << ' ' << object.box_min.y << ' ' << object.box_min.z << ' '
             << object.box_max.x << ' ' << object.box_max.y << ' ' << object.box_max.z << ' '
             << object.cell_sum[0] << ' ' << object.cell_sum[1] << ' ' << object.cell_sum[2] << ' '
             << hexadecimal(object.octree) << ' ' << hexadecimal(object.prism) << '\n';
    }
    return text.str();
}

} // namespace zonegrid::oracle
