#pragma once

#include "evaluation/evaluation.h"

#include <array>
#include <string>

namespace zonegrid::testing {

/// Adds four corners as two triangles.
void add_rectangle(Surfaces& surfaces, const std::array<Eigen::Vector3f, 4>& corners);

/// Adds the six faces of a box.
void add_box(Surfaces& surfaces, const Eigen::Vector3f& low, const Eigen::Vector3f& high);

/// Ends an obstacle: all triangles since the last one are its own.
void end_obstacle(Surfaces& surfaces, const std::string& name, ObstacleKind kind,
                  bool moving = false);

/// A camera of 128 x 128 pixels and 90 degrees, looking north from `place_m`, level.
Camera north_camera();
TrueImage looking_north(double time_s, const Eigen::Vector3d& place_m);

/// A wall north of the camera and a box half way to it, each of its sides 1.4 m from the optical
/// axis; cells of 1 m. By hand, with cells counted from that of the camera, (0, 0, 0):
///
/// - wall: x = 10, y and z = -5 .. 5: 121 cells.
/// - box: x = 5 .. 8, y and z = -1 .. 1: 36 cells, of which surfaces touch all but its inside,
///   (6, 0, 0) and (7, 0, 0): 34.
/// - the box's front is 5 m away, the wall 10 m: the shadow reaches to 2.8 m from the axis and
/// hides
///   the wall's cells with y and z = -2 .. 2: 25. Seen are 96 cells of the wall and 9 of the box.
Truth wall_and_box();
inline constexpr std::uint64_t wall_and_box_visible = 105;

/// Draws a truth's images by asking every triangle for every pixel.
TrueImageDrawer draw_every_triangle(const Truth& truth);

/// A map of these cells as if a mapper had made it in one image: objects are components, history
/// says that all was occupied at `image`.
JudgedMap map_of(const Truth& truth, const CellSet& occupied, const CellSet& free,
                 std::uint32_t image = 0);

/// All cells of a box, both corners included.
CellSet cells_of_box(const CellIndex& low, const CellIndex& high);
CellSet shifted(const CellSet& cells, const CellIndex& step);
CellSet without(const CellSet& cells, const CellSet& taken);

Evaluation evaluate(const JudgedMap& map, const Truth& truth);

} // namespace zonegrid::testing
