#pragma once

#include "evaluation/cell_set.h"
#include "evaluation/triangle_cells.h"
#include "io/replay.h"
#include "pipeline/map_history.h"
#include "truth/truth_folder.h"
#include "zonegrid/objects.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

/// A cell that is occupied at the end.
struct OccupiedCell {
    CellIndex cell;
    std::uint32_t object = 0;                     ///< index into JudgedMap::objects
    std::uint32_t since_image = CellStamp::never; ///< `never`: there is no history
};

/// A cell that was ever occupied.
struct OnceOccupiedCell {
    CellIndex cell;
    std::uint32_t first_image = 0;
};

/// What a map says, as far as its folder tells.
struct JudgedMap {
    std::string folder;
    std::string recording; ///< path, as the map's report gives it
    /// Of the recording's truth, as the recording states it.
    std::optional<std::string> truth_digest;
    double cell_m = 1.0;
    double range_m = 40.0;
    std::string model;
    std::size_t frames = 0;    ///< in the recording
    FrameSpan span;            ///< of them that were mapped
    double first_time_s = 0.0; ///< of the recording's first frame, as the recording states it
    double last_time_s = 0.0;
    CellBox window; ///< at the end
    bool has_history = false;

    std::vector<Object> objects;
    std::vector<OccupiedCell> occupied_cells; ///< by cell
    CellSet occupied;
    /// Value below 0: everywhere that was ever in the window, or in it at the end without a
    /// history.
    CellSet free;
    CellSet undecided;                           ///< above 0, but below the threshold; as `free`
    std::vector<OnceOccupiedCell> ever_occupied; ///< by cell; empty without a history

    /// Whether a value other than 0 is known.
    [[nodiscard]] bool knows(const CellIndex& cell) const {
        return occupied.contains(cell) || free.contains(cell) || undecided.contains(cell);
    }
    /// Whether the map's folder says what a cell's value is, be it 0.
    [[nodiscard]] bool tells_of(const CellIndex& cell) const {
        return has_history || window.contains(cell);
    }
};

/// Reads a folder that zonegrid map wrote. Throws InputError if it is damaged, or if its files do
/// not belong together.
[[nodiscard]] JudgedMap read_judged_map(const std::filesystem::path& folder);

/// Throws InputError unless the map is of a recording that the truth in `truth_folder` belongs to:
/// as many images, none stated before its true time nor later than time stamps may be, and the
/// digest that the recording states.
void require_same_recording(const JudgedMap& map, const Truth& truth,
                            const std::filesystem::path& truth_folder);

} // namespace zonegrid
