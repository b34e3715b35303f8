#include "model/local_map.h"

#include <algorithm>
#include <utility>

namespace zonegrid {

namespace {

std::int32_t bricks_for(const Window& window) {
    return (window.edge_cells() + LocalMap::brick_edge - 1) / LocalMap::brick_edge;
}

} // namespace

LocalMap::LocalMap(const Window& window) : window_(window), bricks_per_axis_(bricks_for(window)) {
    const auto axis = static_cast<std::size_t>(bricks_per_axis_);
    table_.resize(axis * axis * axis);
}

void LocalMap::clear() {
    for (const auto brick : held_) {
        spare_.push_back(std::move(table_[brick]));
    }
    held_.clear();
}

void LocalMap::move_to(const Window& window) {
    clear();
    window_ = window;
}

std::vector<std::uint32_t> LocalMap::zones() const {
    const std::int32_t per_axis = window_.zones_per_axis();
    const std::int32_t per_brick = brick_edge / window_.zone_edge();
    std::vector<std::uint32_t> places;
    for (const auto brick : held_) {
        const auto b = static_cast<std::int32_t>(brick);
        const std::int32_t first_x = b % bricks_per_axis_ * per_brick;
        const std::int32_t first_y = b / bricks_per_axis_ % bricks_per_axis_ * per_brick;
        const std::int32_t first_z = b / (bricks_per_axis_ * bricks_per_axis_) * per_brick;
        const std::int32_t end_x = std::min(first_x + per_brick, per_axis);
        const std::int32_t end_y = std::min(first_y + per_brick, per_axis);
        const std::int32_t end_z = std::min(first_z + per_brick, per_axis);
        for (std::int32_t z = first_z; z < end_z; ++z) {
            for (std::int32_t y = first_y; y < end_y; ++y) {
                for (std::int32_t x = first_x; x < end_x; ++x) {
                    const auto place = (z * per_axis + y) * per_axis + x;
                    places.push_back(static_cast<std::uint32_t>(place));
                }
            }
        }
    }
    std::erase_if(places, [this](std::uint32_t place) { return !has_statement(place); });
    std::ranges::sort(places);
    return places;
}

void LocalMap::copy_zone(std::uint32_t place, std::span<std::uint8_t> statements) const {
    const std::int32_t edge = window_.zone_edge();
    const CellIndex first = window_.first_cell_at(place);
    std::uint8_t* to = statements.data();
    for (std::int32_t z = 0; z < edge; ++z) {
        for (std::int32_t y = 0; y < edge; ++y, to += edge) {
            const std::uint8_t* const from = row_at({first.x, first.y + y, first.z + z});
            if (from == nullptr) {
                std::fill_n(to, edge, std::uint8_t{ZG_STATEMENT_NOTHING});
            } else {
                std::copy_n(from, edge, to);
            }
        }
    }
}

bool LocalMap::has_statement(std::uint32_t place) const {
    const std::int32_t edge = window_.zone_edge();
    const CellIndex first = window_.first_cell_at(place);
    for (std::int32_t z = 0; z < edge; ++z) {
        for (std::int32_t y = 0; y < edge; ++y) {
            const std::uint8_t* const row = row_at({first.x, first.y + y, first.z + z});
            if (std::any_of(row, row + edge,
                            [](std::uint8_t s) { return s != ZG_STATEMENT_NOTHING; })) {
                return true;
            }
        }
    }
    return false;
}

void LocalMap::hold(std::uint32_t brick) {
    if (spare_.empty()) {
        table_[brick] = std::make_unique<std::uint8_t[]>(brick_cells);
    } else {
        table_[brick] = std::move(spare_.back());
        spare_.pop_back();
        std::fill_n(table_[brick].get(), brick_cells, std::uint8_t{ZG_STATEMENT_NOTHING});
    }
    held_.push_back(brick);
}

} // namespace zonegrid
