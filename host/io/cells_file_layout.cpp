#include "io/cells_file_layout.h"

#include "io/little_endian.h"

#include <bit>
#include <cmath>

namespace zonegrid::cells_file {

std::vector<std::uint8_t> header_of(const MapperOptions& options) {
    std::vector<std::uint8_t> header;
    append_little_endian(header, static_cast<std::uint32_t>(options.zone));
    append_little_endian(header, options.cell_m);
    append_little_endian(header, static_cast<std::int32_t>(options.limit));
    append_little_endian(header, static_cast<std::int32_t>(options.threshold));
    return header;
}

MapperOptions options_of(const ZoneStreamReader& reader) {
    const auto header = reader.header();
    MapperOptions options;
    options.zone = from_little_endian<std::int32_t>(header.subspan(zone_place));
    options.cell_m =
        std::bit_cast<double>(from_little_endian<std::uint64_t>(header.subspan(cell_place)));
    options.limit = from_little_endian<std::int32_t>(header.subspan(limit_place));
    options.threshold = from_little_endian<std::int32_t>(header.subspan(threshold_place));
    if ((options.zone != 8 && options.zone != 16 && options.zone != 32) ||
        !std::isfinite(options.cell_m) || options.cell_m <= 0.0) {
        reader.refuse("'s header is damaged");
    }
    return options;
}

ZoneIndex zone_index_of(std::span<const std::uint8_t> bytes) {
    return {from_little_endian<std::int32_t>(bytes),
            from_little_endian<std::int32_t>(bytes.subspan(4)),
            from_little_endian<std::int32_t>(bytes.subspan(8))};
}

} // namespace zonegrid::cells_file
