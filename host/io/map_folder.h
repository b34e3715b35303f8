#pragma once

#include "io/profile_picture.h"
#include "zonegrid/mapper.h"

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

// The files of a map (docs/formats.md).
inline constexpr std::string_view report_name = "report.json";
inline constexpr std::string_view cells_name = "cells.zgrid";
inline constexpr std::string_view objects_name = "objects.json";
inline constexpr std::string_view profile_name = "profile.png";
inline constexpr std::string_view profile3d_name = "profile_3d.png";

inline constexpr std::string_view history_name = "history.zgrid"; ///< only where asked for

inline constexpr std::array<std::string_view, 6> map_folder_names{
    report_name, cells_name, objects_name, profile_name, profile3d_name, history_name};

/// What the files of a map, all but the report, say, and what it took to write them.
struct MapFolderContents {
    std::string cells_digest;      ///< docs/model.md, section 10
    std::string objects_digest;    ///< docs/model.md, section 10
    std::uint64_t cells_known = 0; ///< in the window, with a value other than 0
    std::vector<Object> objects;
    std::size_t profile_columns = 0;
    double objects_s = 0.0;  ///< labelling, measuring and encoding
    double cells_s = 0.0;    ///< cells.zgrid and digest.cells
    double pictures_s = 0.0; ///< profile and both pictures
};

/// Writes cells.zgrid, objects.json and the two pictures of the mapper's map into `folder`.
/// Throws OutputError if a file cannot be written.
[[nodiscard]] MapFolderContents write_map_files(const std::filesystem::path& folder, Mapper& mapper,
                                                std::optional<double> cut_height_m,
                                                std::span<const Eigen::Vector3d> trajectory_m,
                                                const ProfilePictureOptions& pictures);

/// Throws InputError unless `folder` holds report, cells and objects.
void require_map(const std::filesystem::path& folder);

/// Hands the listing of the cells of the map in `folder` to `take`, piece by piece.
/// Throws InputError if `folder` is no map or is damaged, before the first piece.
void list_cells(const std::filesystem::path& folder,
                const std::function<void(std::string_view)>& take);

/// The same for its objects. Their listing is checked against the digest in the report.
void list_objects(const std::filesystem::path& folder,
                  const std::function<void(std::string_view)>& take);

} // namespace zonegrid
