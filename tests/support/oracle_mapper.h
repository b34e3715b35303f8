#pragma once

#include "support/oracle_local_map.h"
#include "support/oracle_objects.h"
#include "zonegrid/mapper.h"

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

private:
    /// Why an image at this time and pose is skipped, or `integrated`.
    ImageStatus admit(double time_s, const std::optional<Pose>& pose);
    void move_window(const Pose& pose);
    std::uint64_t fuse(const StatementMap& statements);

    MapperOptions options_;
    std::optional<Camera> camera_;
    std::vector<NavigationSample> samples_;
    std::optional<double> last_time_s_;
    std::int64_t reach_cell_ = 0;
    bool placed_ = false; ///< whether an image has set the window
    Window window_;
    std::map<CellIndex, int> values_;
    CellSet remembered_;
};

} // namespace zonegrid::oracle
