#pragma once

#include "model/zone_bits.h"
#include "zonegrid/mapper.h"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace zonegrid::scenes {

/// An ideal pinhole that looks forward from the body's origin, principal point in the middle.
[[nodiscard]] Camera forward_camera(int width_px, int height_px, double focal_px);

/// A body at rest and level.
[[nodiscard]] NavigationSample resting_at(double time_s, const Eigen::Vector3d& position_m,
                                          double yaw_rad = 0.0);

/// An image in which every pixel has the same depth: a wall across the optical axis.
[[nodiscard]] std::vector<float> flat_image(const Camera& camera, float depth_m);

/// An image in which every pixel is missing.
[[nodiscard]] std::vector<float> blind_image(const Camera& camera);

/// Hands over a resting sample and an image, both at `time_s`.
ImageResult show(Mapper& mapper, double time_s, const Eigen::Vector3d& position_m,
                 std::span<const float> depth_m, double yaw_rad = 0.0);

/// All cells of a box, both corners inclusive, by x, then y, then z.
[[nodiscard]] std::vector<CellIndex> box_of_cells(const CellIndex& low, const CellIndex& high);

/// The cells of a box for which `wanted` holds.
[[nodiscard]] std::vector<CellIndex> cells_where(
    const CellIndex& low, const CellIndex& high,
    const std::function<bool(const CellIndex&)>& wanted);

/// Cells gathered by zone; zones without any are left out.
[[nodiscard]] std::map<ZoneIndex, ZoneBits> zones_of(std::span<const CellIndex> cells,
                                                     int zone_edge);

/// All cells of the window with a value other than 0.
[[nodiscard]] std::map<CellIndex, int> values_of(const Mapper& mapper);

/// Empty if both lists are equal; else the first place where they part, and both lengths.
[[nodiscard]] std::string difference(std::span<const CellIndex> expected,
                                     std::span<const CellIndex> actual);

/// Empty if both lists are equal; else the first object that differs and in which number.
[[nodiscard]] std::string difference(std::span<const Object> expected,
                                     std::span<const Object> actual);

} // namespace zonegrid::scenes
