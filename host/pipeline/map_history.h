#pragma once

#include "model/lattice.h"
#include "zonegrid/options.h"

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace zonegrid {

/// A cell that an image has found occupied. Images are counted as the caller counts them.
struct CellStamp {
    static constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();

    std::uint16_t place = 0;           ///< in its zone, order [z][y][x]
    std::uint32_t first_image = never; ///< after which the cell was occupied for the first time
    /// After which it has been occupied ever since; `never` if it is not occupied now.
    std::uint32_t since_image = never;
    friend bool operator==(const CellStamp&, const CellStamp&) = default;
};

/// What was last known of a zone.
struct ZoneHistory {
    std::vector<std::int8_t> values; ///< order [z][y][x]
    std::vector<CellStamp> stamps;   ///< cells that were ever occupied, by place
    friend bool operator==(const ZoneHistory&, const ZoneHistory&) = default;
};

/// Everything a map ever held: the last values of each zone that was ever in the window, also after
/// it has left, and since when cells are occupied. A zone that leaves keeps both. When it returns
/// with remembered obstacles, it has the values that they are drawn with, and stamps of cells that
/// are still occupied stay; when it returns with none, it keeps all until an image changes it.
///
/// Memory: a byte a cell of every zone ever touched, and twelve a cell ever occupied.
class MapHistory {
public:
    explicit MapHistory(MapperOptions options) : options_(std::move(options)) {}

    /// Says which image is next.
    void begin_image(std::uint32_t image) { image_ = image; }

    /// Takes what `Mapper::observe_zones` tells.
    void take(const CellIndex& first_cell, std::span<const std::int8_t> values);

    [[nodiscard]] const MapperOptions& options() const { return options_; }
    [[nodiscard]] const std::map<ZoneIndex, ZoneHistory>& zones() const { return zones_; }

private:
    MapperOptions options_;
    std::uint32_t image_ = 0;
    std::map<ZoneIndex, ZoneHistory> zones_;
};

} // namespace zonegrid
