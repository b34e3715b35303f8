#include "io/cells_file.h"
#include "io/cells_file_layout.h"
#include "io/little_endian.h"

namespace zonegrid {

CellsFileWriter::CellsFileWriter(const std::filesystem::path& file, const MapperOptions& options)
    : stream_(file, cells_file::cells_kind, cells_file::header_of(options)), zone_(options.zone) {}

void CellsFileWriter::add(const CellIndex& cell, int value) {
    const ZoneIndex zone = zone_of(cell, zone_);
    if (last_values_ == nullptr || zone != last_zone_) {
        if (zone.x != layer_x_) {
            flush_layer();
            layer_x_ = zone.x;
        }
        last_values_ = &values_of(zone);
        last_zone_ = zone;
    }
    const CellIndex first = first_cell_of(zone, zone_);
    const std::int32_t place =
        ((cell.x - first.x) * zone_ + (cell.y - first.y)) * zone_ + (cell.z - first.z);
    (*last_values_)[static_cast<std::size_t>(place)] = static_cast<std::int8_t>(value);
}

void CellsFileWriter::close() {
    flush_layer();
    stream_.close();
}

void CellsFileWriter::flush_layer() {
    std::vector<std::uint8_t> bytes;
    for (const auto& [place, values] : layer_) {
        bytes.clear();
        append_little_endian(bytes, layer_x_);
        append_little_endian(bytes, place.first);
        append_little_endian(bytes, place.second);
        bytes.insert(bytes.end(), values.begin(), values.end());
        stream_.add_zone(bytes);
    }
    layer_.clear();
    last_values_ = nullptr;
}

std::vector<std::int8_t>& CellsFileWriter::values_of(const ZoneIndex& zone) {
    std::vector<std::int8_t>& values = layer_[{zone.y, zone.z}];
    const auto edge = static_cast<std::size_t>(zone_);
    values.resize(edge * edge * edge);
    return values;
}

} // namespace zonegrid
