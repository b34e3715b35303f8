#pragma once

#include "evaluation/touched_cells.h"
#include "truth/truth_folder.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace zonegrid {

/// Draws the exact depth image of the ideal pinhole `camera` at a true pose, with everything where
/// it is at that time: see RayCaster::draw.
using TrueImageDrawer =
    std::function<void(const Camera& camera, const TrueImage& image, std::span<float> depth_m,
                       std::span<std::uint32_t> obstacles)>;

struct TrueViewOptions {
    double cell_m = 1.0;
    double range_m = 40.0;
    std::size_t first_image = 0; ///< of the truth
    std::size_t last_image = 0;  ///< one past the last
    std::size_t every = 1;       ///< images that are looked at: the first, and each so many later
};

/// The first image in which an obstacle appears within range, and how far its nearest pixel is.
struct FirstSight {
    std::size_t image = 0;
    double distance_m = 0.0; ///< along the ray
};

/// What a perfect sensor with the same camera would state of the cells.
struct TrueView {
    CellSet surface; ///< in which a ray of an image ends, on a surface that does not move
    /// Cells of `surface` whose surface lies on a border, so that the cell beside them would do as
    /// well: by which that is, one less in x (1), in y (2), in z (4), or several of them (sums).
    std::array<CellSet, 8> surface_or;
    CellSet free; ///< that a ray passes and no surface touches that does not move
    std::vector<CellSet> surface_of;                    ///< by obstacle; those that move have none
    std::vector<std::optional<FirstSight>> first_sight; ///< by obstacle
    std::size_t images = 0;                             ///< that were looked at
    std::uint64_t hits = 0;                             ///< rays that ended on a surface
    /// Hits in no cell that their obstacle touches: none, but for rounding.
    std::uint64_t unplaced_hits = 0;
};

/// A visible surface cell and those that would do as well.
[[nodiscard]] std::vector<CellIndex> alternatives(const TrueView& view, const CellIndex& cell);

/// Pixels between neighbouring rays that are followed, so that they are closer than half a cell at
/// the range; at least 1.
[[nodiscard]] int pixel_stride(const Camera& camera, double cell_m, double range_m);

/// How many images apart to look so that it stays a matter of seconds.
[[nodiscard]] std::size_t choose_every(const Camera& camera, const TrueViewOptions& options);

/// Looks at the world from every so many true poses. Obstacles seen first are looked for in all
/// images since the last one looked at, so first sights are exact to the image. `observer` is
/// called with the number of images looked at so far; what it throws ends the work.
[[nodiscard]] TrueView look_around(const Truth& truth, const TouchedCells& touched,
                                   const TrueImageDrawer& draw, const TrueViewOptions& options,
                                   const std::function<void(std::size_t)>& observer);

} // namespace zonegrid
