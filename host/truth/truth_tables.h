#pragma once

#include "truth/truth_folder.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace zonegrid {

// The tables of a truth folder (docs/formats.md, "Truth"): what is written is read back bit for
// bit. Writers throw OutputError, readers InputError naming file and line.

void write_true_navigation(const std::filesystem::path& file,
                           std::span<const NavigationSample> samples);
[[nodiscard]] std::vector<NavigationSample> read_true_navigation(const std::filesystem::path& file);

void write_true_images(const std::filesystem::path& file, std::span<const TrueImage> images);
[[nodiscard]] std::vector<TrueImage> read_true_images(const std::filesystem::path& file);

void write_motions(const std::filesystem::path& file, std::span<const ObstacleMotion> motions);
/// Refuses a motion of anything but one of the `obstacles` that are moving, each once.
[[nodiscard]] std::vector<ObstacleMotion> read_motions(const std::filesystem::path& file,
                                                       std::span<const TrueObstacle> obstacles);

/// True if the matrix is a rotation, but for rounding.
[[nodiscard]] bool is_rotation(const Eigen::Matrix3d& matrix);

} // namespace zonegrid
