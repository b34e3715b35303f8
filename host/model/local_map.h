#pragma once

#include "model/constants.h"
#include "model/window.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace zonegrid {

/// What one image says of each cell of the window: ZG_STATEMENT_* (docs/model.md, section 5).
///
/// Kept in bricks of 64 x 64 x 64 cells from the window's first cell on, whatever the edge of a
/// zone: a ray pays for each border that it crosses. A brick costs memory only once touched.
class LocalMap {
public:
    static constexpr int brick_bits = 6;
    static constexpr std::int32_t brick_edge = 1 << brick_bits;
    static constexpr std::size_t brick_cells = std::size_t{1} << (3 * brick_bits);

    explicit LocalMap(const Window& window);

    [[nodiscard]] const Window& window() const { return window_; }
    [[nodiscard]] std::int32_t bricks_per_axis() const { return bricks_per_axis_; }

    /// First of the `brick_cells` cells of a brick, order [z][y][x]; no statements if it held none
    /// before. `brick`: its place in the window, order [z][y][x].
    std::uint8_t* touch(std::uint32_t brick) {
        if (!table_[brick]) [[unlikely]] {
            hold(brick);
        }
        return table_[brick].get();
    }

    /// Sets the statement of a cell, which is given relative to the window's first cell.
    void set(const CellIndex& cell, std::uint8_t statement) {
        touch(brick_of(cell))[index_in_brick(cell)] = statement;
    }

    /// Drops all statements; keeps the memory for later bricks.
    void clear();

    /// Drops all statements and follows the window.
    void move_to(const Window& window);

    /// Places in the window of the zones with a statement, ascending.
    [[nodiscard]] std::vector<std::uint32_t> zones() const;

    /// Copies the statements of all cells of the zone at `place`, order [z][y][x].
    void copy_zone(std::uint32_t place, std::span<std::uint8_t> statements) const;

    /// Place of the brick of a cell, both relative to the window's first cell.
    [[nodiscard]] std::uint32_t brick_of(const CellIndex& cell) const {
        return static_cast<std::uint32_t>(
            ((cell.z >> brick_bits) * bricks_per_axis_ + (cell.y >> brick_bits)) *
                bricks_per_axis_ +
            (cell.x >> brick_bits));
    }
    [[nodiscard]] static std::size_t index_in_brick(const CellIndex& cell) {
        const auto within = [](std::int32_t c) {
            return static_cast<std::size_t>(c & (brick_edge - 1));
        };
        return (within(cell.z) << brick_bits | within(cell.y)) << brick_bits | within(cell.x);
    }

private:
    /// First of the row of cells that starts at `cell`; null in a brick that is not held.
    [[nodiscard]] const std::uint8_t* row_at(const CellIndex& cell) const {
        const std::uint8_t* const cells = table_[brick_of(cell)].get();
        return cells == nullptr ? nullptr : cells + index_in_brick(cell);
    }
    /// Of a zone in a brick that is held.
    [[nodiscard]] bool has_statement(std::uint32_t place) const;
    void hold(std::uint32_t brick);

    Window window_;
    std::int32_t bricks_per_axis_;
    std::vector<std::unique_ptr<std::uint8_t[]>> table_; ///< order [z][y][x]
    std::vector<std::uint32_t> held_;
    std::vector<std::unique_ptr<std::uint8_t[]>> spare_;
};

} // namespace zonegrid
