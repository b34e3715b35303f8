#pragma once

#include "io/profile_picture_range.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace zonegrid {

/// Heights of the tops on a dense grid of square tiles, `[north][east]`; a tile is one cell, or
/// several where the profile has more columns a side than a picture could show.
class TileGrid {
public:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    /// Tiles take the highest of their columns, clamped to `drawn`. At most `most_tiles` a side.
    TileGrid(const HeightProfile& profile, const HeightRange& drawn, int most_tiles);

    [[nodiscard]] int north_count() const { return north_count_; }
    [[nodiscard]] int east_count() const { return east_count_; }
    [[nodiscard]] double tile_m() const { return tile_m_; }
    /// South edge of the tiles of row `i`; north edge of those of row `i - 1`.
    [[nodiscard]] double north_m(int i) const { return north_min_m_ + i * tile_m_; }
    /// West edge of the tiles of column `j`.
    [[nodiscard]] double east_m(int j) const { return east_min_m_ + j * tile_m_; }

    /// Height of a tile in metres, NaN where nothing is known or outside the grid.
    [[nodiscard]] double top_m(int i, int j) const {
        const bool inside = i >= 0 && i < north_count_ && j >= 0 && j < east_count_;
        return inside ? static_cast<double>(tops_m_[index(i, j)]) : unknown;
    }
    [[nodiscard]] double top_at_m(double north_m, double east_m) const;

    /// About the least known height around a known tile, within a tenth of the grid: what stands
    /// for the ground where a block's neighbour is unknown. Changes gently from tile to tile.
    [[nodiscard]] double ground_m(int i, int j) const;

private:
    [[nodiscard]] std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(east_count_) +
               static_cast<std::size_t>(j);
    }
    [[nodiscard]] std::size_t patch_index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(patch_columns_) +
               static_cast<std::size_t>(column);
    }
    void find_grounds();

    double tile_m_ = 1.0;
    double north_min_m_ = 0.0;
    double east_min_m_ = 0.0;
    int north_count_ = 0;
    int east_count_ = 0;
    int patch_tiles_ = 1; ///< tiles a side of a patch
    int patch_rows_ = 0;
    int patch_columns_ = 0;
    std::vector<float> tops_m_;
    std::vector<double> grounds_m_; ///< per patch, the least height in it and the patches around
};

} // namespace zonegrid
