#include "reference/measure_objects.h"

#include <algorithm>
#include <cassert>

namespace zonegrid::reference {

Object measure_object(std::span<const CellIndex> cells) {
    assert(!cells.empty());
    Object object;
    object.id = cells.front();
    object.box_min = cells.front();
    object.box_max = cells.front();
    object.cell_count = cells.size();
    for (const auto& cell : cells) {
        object.id = std::min(object.id, cell);
        object.box_min = {std::min(object.box_min.x, cell.x), std::min(object.box_min.y, cell.y),
                          std::min(object.box_min.z, cell.z)};
        object.box_max = {std::max(object.box_max.x, cell.x), std::max(object.box_max.y, cell.y),
                          std::max(object.box_max.z, cell.z)};
        object.cell_sum[0] += cell.x;
        object.cell_sum[1] += cell.y;
        object.cell_sum[2] += cell.z;
    }
    return object;
}

} // namespace zonegrid::reference
