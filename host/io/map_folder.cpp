#include "io/map_folder.h"

#include "io/cell_listing.h"
#include "io/cells_file.h"
#include "io/file_bytes.h"
#include "io/object_listing.h"
#include "io/objects_file.h"
#include "io/sha256.h"
#include "pipeline/stopwatch.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <system_error>

namespace zonegrid {
namespace {

void write_cells(const std::filesystem::path& file, const Mapper& mapper,
                 MapFolderContents& contents) {
    Sha256 digest;
    CellListing listing([&digest](std::string_view lines) { digest.add(lines); });
    CellsFileWriter writer(file, mapper.options());
    mapper.for_each_cell([&](const CellIndex& cell, int value) {
        listing.add(cell, value);
        writer.add(cell, value);
        ++contents.cells_known;
    });
    listing.finish();
    writer.close();
    contents.cells_digest = digest.finish_hex();
}

std::string digest_of(std::span<const Object> objects) {
    Sha256 digest;
    for (const Object& object : objects) {
        digest.add(object_line(object));
    }
    return digest.finish_hex();
}

std::string stated_objects_digest(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / report_name;
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    try {
        return nlohmann::json::parse(bytes).at("digest").at("objects").get<std::string>();
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file.string(), fmt::format("the report is damaged ({})", error.what()),
                         "map the recording again");
    }
}

} // namespace

void require_map(const std::filesystem::path& folder) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error)) {
        throw InputError(folder.string(), "there is no such folder",
                         "name a folder that zonegrid map wrote");
    }
    for (const std::string_view name : {report_name, cells_name, objects_name}) {
        if (!std::filesystem::is_regular_file(folder / name, error)) {
            throw InputError(folder.string(), fmt::format("the folder holds no {}", name),
                             "name a folder that zonegrid map wrote");
        }
    }
}

MapFolderContents write_map_files(const std::filesystem::path& folder, Mapper& mapper,
                                  std::optional<double> cut_height_m,
                                  std::span<const Eigen::Vector3d> trajectory_m,
                                  const ProfilePictureOptions& pictures) {
    MapFolderContents contents;
    Stopwatch stopwatch;
    contents.objects = mapper.objects();
    contents.objects_s = stopwatch.lap_s();
    contents.objects_digest = digest_of(contents.objects);
    write_objects_file(folder / objects_name, contents.objects, mapper.options().cell_m);
    stopwatch.lap_s();
    write_cells(folder / cells_name, mapper, contents);
    contents.cells_s = stopwatch.lap_s();
    const HeightProfile profile = mapper.height_profile(cut_height_m);
    contents.profile_columns = profile.columns.size();
    draw_profile(profile, trajectory_m, pictures, folder / profile_name);
    draw_profile_3d(profile, trajectory_m, pictures, folder / profile3d_name);
    contents.pictures_s = stopwatch.lap_s();
    return contents;
}

void list_cells(const std::filesystem::path& folder,
                const std::function<void(std::string_view)>& take) {
    require_map(folder);
    const StoredCells cells = read_cells_file(folder / cells_name);
    CellListing listing(take);
    cells.for_each_cell([&](const CellIndex& cell, int value) { listing.add(cell, value); });
    listing.finish();
}

void list_objects(const std::filesystem::path& folder,
                  const std::function<void(std::string_view)>& take) {
    require_map(folder);
    const std::vector<Object> objects = read_objects_file(folder / objects_name);
    if (digest_of(objects) != stated_objects_digest(folder)) {
        throw InputError((folder / objects_name).string(),
                         fmt::format("its objects are not those of {}", report_name),
                         "map the recording again or copy the folder again");
    }
    for (const Object& object : objects) {
        take(object_line(object));
    }
}

} // namespace zonegrid
