#pragma once

#include "support/oracle_local_map.h"
#include "support/oracle_objects.h"
#include "support/oracle_view.h"
#include "zonegrid/mapper.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace zonegrid::oracle {

/// The whole model in sets and maps of world cells: slow, obvious, and written from docs/model.md
/// alone. Takes the calls that `Mapper` takes, so a flight can be compared cell by cell.
class OracleMapper {
public:
    explicit OracleMapper(const MapperOptions& options, const std::optional<Camera>& camera = {});

    void add_navigation(const NavigationSample& sample);
    /// Fills status, world_from_sensor, missing, dropped and cells_changed of the result.
    ImageResult add_image(const DepthImage& image);
    ImageResult add_scan(const Scan& scan);

    /// Values of the cells in the window; cells that are absent have 0.
    [[nodiscard]] const std::map<CellIndex, int>& values() const;
    /// Cells outside the window that are remembered as occupied.
    [[nodiscard]] const CellSet& remembered() const;
    [[nodiscard]] const Window& window() const;
    /// Occupied cells in the window and remembered ones.
    [[nodiscard]] CellSet occupied() const;
    [[nodiscard]] std::vector<Object> objects() const;
    [[nodiscard]] std::vector<ProfileColumn> height_profile(
        std::optional<double> cut_height_m = {}) const;

    /// How often an image said free of an occupied cell that it saw only part of, so that the cell
    /// kept its value, and how often of one that it saw whole; scans do not count.
    [[nodiscard]] std::uint64_t partly_seen() const;
    [[nodiscard]] std::uint64_t wholly_seen() const;

private:
    /// Why an image at this time and pose is skipped, or `integrated`.
    ImageStatus admit(double time_s, const std::optional<Pose>& pose);
    void move_window(const Pose& pose);
    /// The local map of an image with its view, of a scan without: a scan sees all of any cell.
    std::uint64_t fuse(const StatementMap& statements, const std::optional<View>& view);
    /// Whether what is free in an image must leave the cell's value as it is; counts either way.
    bool spared(const CellIndex& cell, int value, const View& view);

    MapperOptions options_;
    std::optional<Camera> camera_;
    std::vector<NavigationSample> samples_;
    std::optional<double> last_time_s_;
    std::int64_t reach_cell_ = 0;
    bool placed_ = false; ///< whether an image has set the window
    Window window_;
    std::map<CellIndex, int> values_;
    CellSet remembered_;
    std::uint64_t partly_seen_ = 0;
    std::uint64_t wholly_seen_ = 0;
};

} // namespace zonegrid::oracle
