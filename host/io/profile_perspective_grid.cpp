#include "io/profile_perspective_grid.h"

#include <algorithm>
#include <cstdint>

namespace zonegrid {
namespace {

std::int64_t floor_divide(std::int64_t value, std::int64_t divisor) {
    const std::int64_t quotient = value / divisor;
    return value % divisor < 0 ? quotient - 1 : quotient;
}

} // namespace

TileGrid::TileGrid(const HeightProfile& profile, const HeightRange& drawn, int most_tiles) {
    std::int64_t x_min = profile.columns.front().x;
    std::int64_t x_max = x_min;
    std::int64_t y_min = profile.columns.front().y;
    std::int64_t y_max = y_min;
    for (const ProfileColumn& column : profile.columns) {
        x_min = std::min<std::int64_t>(x_min, column.x);
        x_max = std::max<std::int64_t>(x_max, column.x);
        y_min = std::min<std::int64_t>(y_min, column.y);
        y_max = std::max<std::int64_t>(y_max, column.y);
    }
    const std::int64_t side = std::max(x_max - x_min, y_max - y_min) + 1;
    const std::int64_t cells = (side + most_tiles - 1) / most_tiles;
    // Tiles begin at multiples of their size, so that one cell a tile keeps the cells' borders.
    const std::int64_t x_first = floor_divide(x_min, cells);
    const std::int64_t y_first = floor_divide(y_min, cells);
    tile_m_ = static_cast<double>(cells) * profile.cell_m;
    north_min_m_ = static_cast<double>(x_first) * tile_m_;
    east_min_m_ = static_cast<double>(y_first) * tile_m_;
    north_count_ = static_cast<int>(floor_divide(x_max, cells) - x_first + 1);
    east_count_ = static_cast<int>(floor_divide(y_max, cells) - y_first + 1);
    tops_m_.assign(index(north_count_, 0), static_cast<float>(unknown));
    for (const ProfileColumn& column : profile.columns) {
        float& top = tops_m_[index(static_cast<int>(floor_divide(column.x, cells) - x_first),
                                   static_cast<int>(floor_divide(column.y, cells) - y_first))];
        const auto own = static_cast<float>(
            std::clamp(zonegrid::top_m(column, profile.cell_m), drawn.low_m, drawn.high_m));
        top = std::isnan(top) ? own : std::max(top, own);
    }
    find_grounds();
}

double TileGrid::top_at_m(double north_m, double east_m) const {
    const double i = std::floor((north_m - north_min_m_) / tile_m_);
    const double j = std::floor((east_m - east_min_m_) / tile_m_);
    const bool inside = i >= 0.0 && i < north_count_ && j >= 0.0 && j < east_count_;
    return inside ? top_m(static_cast<int>(i), static_cast<int>(j)) : unknown;
}

void TileGrid::find_grounds() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    patch_tiles_ = std::max(8, std::max(north_count_, east_count_) / 25);
    patch_rows_ = (north_count_ + patch_tiles_ - 1) / patch_tiles_;
    patch_columns_ = (east_count_ + patch_tiles_ - 1) / patch_tiles_;
    std::vector<double> least_m(patch_index(patch_rows_, 0), infinity);
    for (int i = 0; i < north_count_; ++i) {
        for (int j = 0; j < east_count_; ++j) {
            // fmin passes over NaN.
            double& least = least_m[patch_index(i / patch_tiles_, j / patch_tiles_)];
            least = std::fmin(least, top_m(i, j));
        }
    }
    grounds_m_.assign(least_m.size(), infinity);
    for (int row = 0; row < patch_rows_; ++row) {
        for (int column = 0; column < patch_columns_; ++column) {
            double& ground = grounds_m_[patch_index(row, column)];
            for (int r = std::max(row - 1, 0); r <= std::min(row + 1, patch_rows_ - 1); ++r) {
                for (int c = std::max(column - 1, 0); c <= std::min(column + 1, patch_columns_ - 1);
                     ++c) {
                    ground = std::min(ground, least_m[patch_index(r, c)]);
                }
            }
        }
    }
}

double TileGrid::ground_m(int i, int j) const {
    // Between the middles of the four nearest patches. A known tile's own patch counts in all four,
    // so none of them is infinite.
    const double row = std::clamp((i + 0.5) / patch_tiles_ - 0.5, 0.0, patch_rows_ - 1.0);
    const double column = std::clamp((j + 0.5) / patch_tiles_ - 0.5, 0.0, patch_columns_ - 1.0);
    const int r = static_cast<int>(row);
    const int c = static_cast<int>(column);
    const int r_next = std::min(r + 1, patch_rows_ - 1);
    const int c_next = std::min(c + 1, patch_columns_ - 1);
    const auto across = [&](int in_row) {
        return std::lerp(grounds_m_[patch_index(in_row, c)],
                         grounds_m_[patch_index(in_row, c_next)], column - c);
    };
    return std::lerp(across(r), across(r_next), row - r);
}

} // namespace zonegrid
