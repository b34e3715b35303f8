#include "io/history_file.h"

#include "io/cells_file_layout.h"
#include "io/little_endian.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace zonegrid {
namespace {

/// Place in order [x][y][z] of a place in order [z][y][x], and the other way round.
std::size_t turned(std::size_t place, std::size_t edge) {
    return (place % edge * edge + place / edge % edge) * edge + place / (edge * edge);
}

bool is_empty(const ZoneHistory& zone) {
    return zone.stamps.empty() &&
           std::ranges::all_of(zone.values, [](const auto value) { return value == 0; });
}

std::vector<std::uint8_t> bytes_of(const ZoneIndex& index, const ZoneHistory& zone,
                                   std::size_t edge) {
    std::vector<std::uint8_t> bytes;
    append_little_endian(bytes, index.x);
    append_little_endian(bytes, index.y);
    append_little_endian(bytes, index.z);
    for (std::size_t place = 0; place < zone.values.size(); ++place) {
        bytes.push_back(static_cast<std::uint8_t>(zone.values[turned(place, edge)]));
    }
    std::vector<CellStamp> stamps = zone.stamps;
    for (auto& stamp : stamps) {
        stamp.place = static_cast<std::uint16_t>(turned(stamp.place, edge));
    }
    std::ranges::sort(stamps, {}, &CellStamp::place);
    append_little_endian(bytes, static_cast<std::uint32_t>(stamps.size()));
    for (const auto& stamp : stamps) {
        append_little_endian(bytes, stamp.place);
        append_little_endian(bytes, stamp.first_image);
        append_little_endian(bytes, stamp.since_image);
    }
    return bytes;
}

/// Whether a stamp can be what a map wrote.
bool is_sound(const CellStamp& stamp, std::size_t zone_cells, std::uint32_t frames) {
    return stamp.place < zone_cells && stamp.first_image < frames &&
           (stamp.since_image == CellStamp::never ||
            (stamp.since_image >= stamp.first_image && stamp.since_image < frames));
}

std::vector<CellStamp> read_stamps(ZoneStreamReader& stream, std::size_t edge,
                                   std::uint32_t frames) {
    std::vector<std::uint8_t> bytes(4);
    stream.read(bytes);
    const auto count = from_little_endian<std::uint32_t>(bytes);
    const std::size_t zone_cells = edge * edge * edge;
    if (count > zone_cells) {
        stream.refuse(" has more stamps than cells");
    }
    bytes.resize(count * cells_file::stamp_bytes);
    stream.read(bytes);
    std::vector<CellStamp> stamps(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto stamp = std::span(bytes).subspan(i * cells_file::stamp_bytes);
        stamps[i] = {from_little_endian<std::uint16_t>(stamp),
                     from_little_endian<std::uint32_t>(stamp.subspan(2)),
                     from_little_endian<std::uint32_t>(stamp.subspan(6))};
        if (!is_sound(stamps[i], zone_cells, frames) ||
            (i > 0 && stamps[i].place <= stamps[i - 1].place)) {
            stream.refuse("'s stamps are damaged");
        }
    }
    for (auto& stamp : stamps) {
        stamp.place = static_cast<std::uint16_t>(turned(stamp.place, edge));
    }
    std::ranges::sort(stamps, {}, &CellStamp::place);
    return stamps;
}

ZoneHistory read_zone(ZoneStreamReader& stream, std::span<const std::uint8_t> values,
                      std::size_t edge, std::uint32_t frames) {
    ZoneHistory zone;
    zone.values.resize(values.size());
    for (std::size_t place = 0; place < values.size(); ++place) {
        zone.values[turned(place, edge)] = static_cast<std::int8_t>(values[place]);
    }
    zone.stamps = read_stamps(stream, edge, frames);
    return zone;
}

} // namespace

void write_history_file(const std::filesystem::path& file, const MapHistory& history,
                        std::uint32_t frames) {
    std::vector<std::uint8_t> header = cells_file::header_of(history.options());
    append_little_endian(header, frames);
    ZoneStreamWriter stream(file, cells_file::history_kind, header);
    const auto edge = static_cast<std::size_t>(history.options().zone);
    for (const auto& [index, zone] : history.zones()) {
        if (!is_empty(zone)) {
            stream.add_zone(bytes_of(index, zone, edge));
        }
    }
    stream.close();
}

StoredHistory read_history_file(const std::filesystem::path& file) {
    ZoneStreamReader stream(file, cells_file::history_kind);
    StoredHistory history;
    history.options = cells_file::options_of(stream);
    history.frames =
        from_little_endian<std::uint32_t>(stream.header().subspan(cells_file::frames_place));
    const auto edge = static_cast<std::size_t>(history.options.zone);
    std::vector<std::uint8_t> bytes(cells_file::zone_index_bytes + edge * edge * edge);
    for (std::uint64_t i = 0; i < stream.zones(); ++i) {
        stream.read(bytes);
        const ZoneIndex index = cells_file::zone_index_of(bytes);
        if (!history.zones.empty() && !(history.zones.rbegin()->first < index)) {
            stream.refuse("'s zones are not in order");
        }
        history.zones.emplace_hint(
            history.zones.end(), index,
            read_zone(stream, std::span(bytes).subspan(cells_file::zone_index_bytes), edge,
                      history.frames));
    }
    stream.require_end();
    return history;
}

} // namespace zonegrid
