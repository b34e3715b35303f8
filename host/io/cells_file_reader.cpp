#include "io/cells_file.h"
#include "io/cells_file_layout.h"
#include "io/little_endian.h"

#include <algorithm>
#include <span>

namespace zonegrid {

StoredCells read_cells_file(const std::filesystem::path& file) {
    ZoneStreamReader stream(file, cells_file::cells_kind);
    const MapperOptions options = cells_file::options_of(stream);
    StoredCells cells{options.cell_m, options.zone, options.limit, options.threshold, {}};
    const auto edge = static_cast<std::size_t>(cells.zone);
    std::vector<std::uint8_t> bytes(cells_file::zone_index_bytes + edge * edge * edge);
    for (std::uint64_t i = 0; i < stream.zones(); ++i) {
        stream.read(bytes);
        StoredZone zone{cells_file::zone_index_of(bytes), {}};
        zone.values.assign(bytes.begin() + cells_file::zone_index_bytes, bytes.end());
        cells.zones.push_back(std::move(zone));
        if (i > 0 && !(cells.zones[i - 1].zone < cells.zones[i].zone)) {
            stream.refuse("'s zones are not in order");
        }
    }
    stream.require_end();
    return cells;
}

void StoredCells::for_each_cell(const std::function<void(const CellIndex&, int)>& visit) const {
    const auto edge = static_cast<std::size_t>(zone);
    const auto visit_column = [&](const StoredZone& stored, std::size_t x, std::size_t y) {
        CellIndex cell = first_cell_of(stored.zone, zone);
        cell.x += static_cast<std::int32_t>(x);
        cell.y += static_cast<std::int32_t>(y);
        const auto column = std::span(stored.values).subspan((x * edge + y) * edge, edge);
        for (const int value : column) {
            if (value != 0) {
                visit(cell, value);
            }
            ++cell.z;
        }
    };
    // A layer shares its zone x, a row also its zone y: the cells' order crosses zones in both.
    for (auto layer = zones.begin(); layer != zones.end();) {
        const auto layer_end = std::find_if(
            layer, zones.end(), [&](const auto& stored) { return stored.zone.x != layer->zone.x; });
        for (std::size_t x = 0; x < edge; ++x) {
            for (auto row = layer; row != layer_end;) {
                const auto row_end = std::find_if(row, layer_end, [&](const auto& stored) {
                    return stored.zone.y != row->zone.y;
                });
                for (std::size_t y = 0; y < edge; ++y) {
                    std::for_each(row, row_end,
                                  [&](const auto& stored) { visit_column(stored, x, y); });
                }
                row = row_end;
            }
        }
        layer = layer_end;
    }
}

} // namespace zonegrid
