#pragma once

#include "evaluation/judged_map.h"
#include "evaluation/true_view.h"
#include "truth/truth_folder.h"
#include "zonegrid/objects.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// How good a map is against known truth: every measure is defined in docs/evaluation.md.
namespace zonegrid {

/// So many of so many.
struct Share {
    std::uint64_t count = 0;
    std::uint64_t of = 0;
    /// Nothing if `of` is 0.
    [[nodiscard]] std::optional<double> value() const {
        return of == 0 ? std::nullopt
                       : std::optional(static_cast<double>(count) / static_cast<double>(of));
    }
};

/// Distances in cells (Chebyshev) at which cells are compared: 0, 1 and 2.
inline constexpr std::size_t reaches = 3;

struct CellMeasures {
    std::array<Share, reaches> precision; ///< of the map's occupied cells
    std::array<Share, reaches> recall;    ///< of the visible surface cells
    Share wrong_free_surface; ///< of the visible surface cells told of: those that the map has free
    Share wrong_free_solid;   ///< of the map's free cells: those inside of things
    Share wrong_occupied_free; ///< of the visible free cells: those that the map has occupied
    Share unknown_free;        ///< of the visible free cells told of
    Share unknown_surface;     ///< of the visible surface cells told of
};

/// An image, when it was taken, and how far an obstacle was then.
struct Moment {
    std::size_t image = 0;
    double time_s = 0.0;
    double distance_m = 0.0;
};

struct ObstacleMeasures {
    std::string name;
    ObstacleKind kind = ObstacleKind::other;
    std::uint64_t visible_cells = 0;
    /// The ground touches every one of its visible cells: they do not tell it from the ground.
    bool judged_with_ground = false;
    Share found_cells;           ///< of its judged cells
    bool found = false;          ///< never, if it is judged with the ground
    Share erased_cells;          ///< of its judged cells that were ever occupied: not at the end
    std::uint64_t map_cells = 0; ///< that are its own
    std::size_t objects = 0;     ///< that its own cells belong to
    double largest_share = 0.0;  ///< of its own cells in one object
    std::vector<std::string> merged_with;
    std::vector<std::string> touching; ///< of `merged_with`: those it touches in truth
    bool joined_with_ground = false;

    // Absent without own cells, and for the ground.
    std::optional<Eigen::Vector3d> centre_m;
    std::optional<Eigen::Vector3d> true_centre_m;
    std::optional<double> horizontal_error_m;
    std::optional<double> vertical_error_m; ///< positive: the map has it too high
    std::optional<Eigen::Vector3d> size_m;
    std::optional<Eigen::Vector3d> true_size_m;
    std::optional<double> size_error_m;

    std::optional<Moment> first_sight;
    std::optional<Moment> detection; ///< absent also without a history

    [[nodiscard]] bool split() const { return objects > 1; }
    /// With an obstacle that it does not touch in truth.
    [[nodiscard]] bool merged() const { return merged_with.size() > touching.size(); }
};

struct MovingMeasures {
    std::string name;
    std::optional<Moment> first_sight;
    std::optional<Moment> detection; ///< absent also without a history
    std::uint64_t trail_cells = 0;
};

/// What a map says between two neighbours of a row.
struct GapMeasures {
    std::string before; ///< names of the two
    std::string after;
    double true_m = 0.0;  ///< between their facing ends
    double clear_m = 0.0; ///< of it: the longest stretch without an occupied cell
    Share free;           ///< of the places looked at
    Share occupied;
};

/// Obstacles of one kind against the line that fits them best, seen from above.
struct LineMeasures {
    ObstacleKind kind = ObstacleKind::other;
    std::size_t members = 0; ///< found ones
    double line_error_m = 0.0;
    double true_line_error_m = 0.0;
    std::vector<GapMeasures> gaps; ///< where they stand in a row
};

struct Evaluation {
    std::string map;
    std::string recording;
    std::string scene;
    std::uint64_t seed = 0;
    double cell_m = 0.0;
    double range_m = 0.0;
    std::string model;
    std::size_t every = 1;
    std::size_t images = 0; ///< of the truth that were looked at
    bool has_history = false;
    std::uint64_t hits = 0;
    std::uint64_t unplaced_hits = 0;

    CellMeasures cells;
    std::vector<ObstacleMeasures> obstacles; ///< that do not move and are visible
    std::size_t obstacles_never_visible = 0;
    std::vector<MovingMeasures> moving;
    std::vector<LineMeasures> lines;

    HeightProfile map_profile;
    HeightProfile true_profile; ///< of the visible surface cells
    std::vector<Eigen::Vector3d> trajectory_m;
};

/// Least share of an obstacle's judged cells that must be found for it to be found.
inline constexpr double found_share = 0.5;

struct EvaluationOptions {
    std::optional<std::size_t> every{}; ///< images apart; without it `choose_every`
};

/// Judges a map. `draw` draws the truth's images; `observer` is called with the number of images
/// looked at so far and of all.
[[nodiscard]] Evaluation evaluate(const JudgedMap& map, const Truth& truth,
                                  const TrueImageDrawer& draw, const EvaluationOptions& options,
                                  const std::function<void(std::size_t, std::size_t)>& observer);

} // namespace zonegrid
