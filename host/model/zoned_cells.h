#pragma once

#include "model/window.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace zonegrid {

/// Cells of one kind on the zones of a window. A zone costs memory only once touched.
///
/// `Cell` is a one-byte type: the grid's values or the local map's statements. Cells of a zone lie
/// contiguously, order [z][y][x].
template <class Cell>
class ZonedCells {
public:
    explicit ZonedCells(const Window& window)
        : window_(window), table_(window.zone_count()), zone_cells_(cells_per_zone(window)) {}

    [[nodiscard]] const Window& window() const { return window_; }
    [[nodiscard]] std::size_t zone_cells() const { return zone_cells_; }

    /// Places of the zones that hold cells, in no particular order.
    [[nodiscard]] std::span<const std::uint32_t> held() const { return held_; }

    /// Cells of the zone at `place`, empty if it holds none.
    [[nodiscard]] std::span<const Cell> find(std::uint32_t place) const {
        const Cell* cells = table_[place].get();
        return {cells, cells == nullptr ? 0 : zone_cells_};
    }

    /// Cells of the zone at `place`; all 0 if it held none before.
    std::span<Cell> touch(std::uint32_t place) {
        if (!table_[place]) [[unlikely]] {
            hold(place);
        }
        return {table_[place].get(), zone_cells_};
    }

    /// Drops all cells; keeps the memory for later zones.
    void clear() {
        for (const auto place : held_) {
            spare_.push_back(std::move(table_[place]));
        }
        held_.clear();
    }

    /// Follows the window. Zones that both windows hold keep their cells; for each that leaves,
    /// `leave(zone, cells)` is called before they are dropped.
    template <class Leave>
    void move_to(const Window& window, Leave&& leave) {
        std::vector<std::pair<ZoneIndex, std::unique_ptr<Cell[]>>> zones;
        zones.reserve(held_.size());
        for (const auto place : held_) {
            zones.emplace_back(window_.zone_at(place), std::move(table_[place]));
        }
        held_.clear();
        window_ = window;
        for (auto& [zone, cells] : zones) {
            if (window_.holds(zone)) {
                const auto place = window_.place_of(zone);
                table_[place] = std::move(cells);
                held_.push_back(place);
            } else {
                leave(zone, std::span<const Cell>(cells.get(), zone_cells_));
                spare_.push_back(std::move(cells));
            }
        }
    }

private:
    static std::size_t cells_per_zone(const Window& window) {
        const auto edge = static_cast<std::size_t>(window.zone_edge());
        return edge * edge * edge;
    }

    [[gnu::noinline]] void hold(std::uint32_t place) {
        if (spare_.empty()) {
            table_[place] = std::make_unique<Cell[]>(zone_cells_);
        } else {
            table_[place] = std::move(spare_.back());
            spare_.pop_back();
            std::fill_n(table_[place].get(), zone_cells_, Cell{});
        }
        held_.push_back(place);
    }

    Window window_;
    std::vector<std::unique_ptr<Cell[]>> table_; ///< over the window, order [z][y][x]
    std::vector<std::uint32_t> held_;
    std::vector<std::unique_ptr<Cell[]>> spare_;
    std::size_t zone_cells_;
};

/// Fused values.
using Grid = ZonedCells<std::int8_t>;

} // namespace zonegrid
