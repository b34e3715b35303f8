#include "pipeline/map_history.h"

#include <utility>

namespace zonegrid {

void MapHistory::take(const CellIndex& first_cell, std::span<const std::int8_t> values) {
    ZoneHistory& zone = zones_[zone_of(first_cell, options_.zone)];
    std::vector<CellStamp> stamps;
    stamps.reserve(zone.stamps.size());
    auto known = zone.stamps.begin();
    for (std::size_t place = 0; place < values.size(); ++place) {
        const bool occupied = values[place] >= options_.threshold;
        const bool was = known != zone.stamps.end() && known->place == place;
        if (!occupied && !was) {
            continue;
        }
        CellStamp stamp =
            was ? *known++ : CellStamp{static_cast<std::uint16_t>(place), image_, image_};
        if (!occupied) {
            stamp.since_image = CellStamp::never;
        } else if (stamp.since_image == CellStamp::never) {
            stamp.since_image = image_;
        }
        stamps.push_back(stamp);
    }
    zone.values.assign(values.begin(), values.end());
    zone.stamps = std::move(stamps);
}

} // namespace zonegrid
