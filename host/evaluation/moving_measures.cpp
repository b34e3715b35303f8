#include "evaluation/moving_measures.h"

#include <algorithm>
#include <limits>
#include <map>

namespace zonegrid {
namespace {

/// Cells of one moving obstacle at the images' times.
class Passage {
public:
    Passage(const Truth& truth, const ObstacleMotion& motion, double cell_m, const CellBox& region)
        : truth_(truth), motion_(motion), cell_m_(cell_m), region_(region) {}

    [[nodiscard]] CellSet at(std::size_t image) const {
        return touch_cells(truth_.surfaces, motion_.obstacle,
                           motion_.at(truth_.images[image].time_s), cell_m_, region_);
    }

    /// All cells touched from image `first` to before `last`; images between which the obstacle
    /// moves by less than half a cell are taken together.
    [[nodiscard]] CellSet swept(std::size_t first, std::size_t last) const {
        CellSet cells;
        Eigen::Vector3d place_m = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
        for (std::size_t image = first; image < last; ++image) {
            const Eigen::Vector3d now_m = motion_.at(truth_.images[image].time_s).translation();
            if ((now_m - place_m).cwiseAbs().maxCoeff() >= 0.5 * cell_m_) {
                cells.insert_all(at(image));
                place_m = now_m;
            }
        }
        return cells;
    }

private:
    const Truth& truth_;
    const ObstacleMotion& motion_;
    double cell_m_;
    CellBox region_;
};

/// The first image after which a cell beside the obstacle, as it stood then, was occupied for the
/// first time.
std::optional<Moment> detect(const JudgedMap& map, const Truth& truth, const TouchedCells& touched,
                             const Passage& passage, const CellSet& swept) {
    std::map<std::uint32_t, std::vector<CellIndex>> by_image;
    for (const auto& once : map.ever_occupied) {
        if (swept.contains_within(once.cell, 1) && !touched.all().contains_within(once.cell, 1)) {
            by_image[once.first_image].push_back(once.cell);
        }
    }
    for (const auto& [image, cells] : by_image) {
        const CellSet then = passage.at(image);
        if (std::ranges::any_of(
                cells, [&then](const CellIndex& cell) { return then.contains_within(cell, 1); })) {
            const Eigen::Vector3d camera_m = truth.images[image].world_from_camera.translation();
            double distance_m = std::numeric_limits<double>::infinity();
            then.for_each([&](const CellIndex& cell) {
                const Eigen::Vector3d middle_m =
                    Eigen::Vector3d(cell.x + 0.5, cell.y + 0.5, cell.z + 0.5) * map.cell_m;
                distance_m = std::min(distance_m, (middle_m - camera_m).norm());
            });
            return Moment{image, truth.images[image].time_s, distance_m};
        }
    }
    return std::nullopt;
}

} // namespace

CellSet moving_cells(const Truth& truth, std::size_t image, double cell_m, const CellBox& region) {
    CellSet cells;
    for (const auto& motion : truth.motions) {
        cells.insert_all(Passage(truth, motion, cell_m, region).at(image));
    }
    return cells;
}

std::vector<MovingMeasures> measure_moving(const JudgedMap& map, const Truth& truth,
                                           const TouchedCells& touched, const CellSet& passing,
                                           const TrueView& view, const CellBox& region) {
    std::vector<MovingMeasures> all;
    for (const auto& motion : truth.motions) {
        MovingMeasures measures;
        measures.name = truth.surfaces.obstacles[motion.obstacle].name;
        if (const auto& sight = view.first_sight[motion.obstacle]) {
            measures.first_sight =
                Moment{sight->image, truth.images[sight->image].time_s, sight->distance_m};
        }
        const Passage passage(truth, motion, map.cell_m, region);
        const CellSet swept = passage.swept(map.span.first, map.span.last);
        for (const auto& occupied : map.occupied_cells) {
            measures.trail_cells += swept.contains_within(occupied.cell, 1) &&
                                            !touched.all().contains_within(occupied.cell, 1) &&
                                            !passing.contains_within(occupied.cell, 1)
                                        ? 1U
                                        : 0U;
        }
        measures.detection = detect(map, truth, touched, passage, swept);
        all.push_back(std::move(measures));
    }
    return all;
}

} // namespace zonegrid
