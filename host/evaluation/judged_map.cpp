#include "evaluation/judged_map.h"

#include "io/cells_file.h"
#include "io/file_bytes.h"
#include "io/history_file.h"
#include "io/map_folder.h"
#include "io/objects_file.h"
#include "io/sha256.h"
#include "model/tree_root.h"
#include "reference/encode_octree.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace zonegrid {
namespace {

namespace fs = std::filesystem;

constexpr double same_time_s = 1e-6;

constexpr const char* remedy = "map the recording again or copy the folder again";

[[noreturn]] void refuse(const fs::path& file, const std::string& problem) {
    throw InputError(file.string(), problem, remedy);
}

/// Fills in what the report says; returns the digest of the cells.
std::string read_report(const fs::path& file, JudgedMap& map) {
    const auto bytes = read_file_bytes(file);
    try {
        const auto report = nlohmann::json::parse(bytes);
        const auto& recording = report.at("recording");
        recording.at("path").get_to(map.recording);
        recording.at("frames").get_to(map.frames);
        recording.at("first_frame_s").get_to(map.first_time_s);
        recording.at("last_frame_s").get_to(map.last_time_s);
        const auto truth = recording.find("truth_digest");
        if (truth != recording.end() && !truth->is_null()) {
            map.truth_digest = truth->get<std::string>();
        }
        const auto& parameters = report.at("parameters");
        parameters.at("cell_m").get_to(map.cell_m);
        parameters.at("range_m").get_to(map.range_m);
        parameters.at("model").get_to(map.model);
        const auto span = parameters.at("frames").get<std::array<std::size_t, 2>>();
        map.span = {span[0], span[1]};
        const auto low =
            report.at("map").at("window_first_cell").get<std::array<std::int32_t, 3>>();
        const auto edge = report.at("map").at("window_cells").get<std::int32_t>();
        map.window = {{low[0], low[1], low[2]},
                      {low[0] + edge - 1, low[1] + edge - 1, low[2] + edge - 1}};
        if (map.span.first >= map.span.last || map.span.last > map.frames) {
            refuse(file, "parameters.frames names frames that the recording does not have");
        }
        return report.at("digest").at("cells").get<std::string>();
    } catch (const nlohmann::json::exception& error) {
        refuse(file, fmt::format("the report is damaged ({})", error.what()));
    }
}

void require_digest(const fs::path& folder, const std::string& stated) {
    Sha256 digest;
    list_cells(folder, [&](std::string_view lines) { digest.add(lines); });
    if (digest.finish_hex() != stated) {
        refuse(folder / cells_name, fmt::format("its cells are not those of {}", report_name));
    }
    list_objects(folder, [](std::string_view) {}); // checks them against the report's digest
}

void read_objects(const fs::path& file, int zone, JudgedMap& map) {
    map.objects = read_objects_file(file);
    for (std::uint32_t i = 0; i < map.objects.size(); ++i) {
        const Object& object = map.objects[i];
        const auto root = octree_root(object.box_min, object.box_max, zone);
        for (const auto& cell : reference::decode_octree(object.octree, root)) {
            map.occupied_cells.push_back({cell, i});
            if (!map.occupied.insert(cell)) {
                refuse(file,
                       fmt::format("two objects have the cell {} {} {}", cell.x, cell.y, cell.z));
            }
        }
    }
    std::ranges::sort(map.occupied_cells, {}, &OccupiedCell::cell);
}

/// Notes a value other than 0.
void take_value(const CellIndex& cell, int value, int threshold, JudgedMap& map) {
    if (value < 0) {
        map.free.insert(cell);
    } else if (value > 0 && value < threshold) {
        map.undecided.insert(cell);
    }
}

void require_same_header(const fs::path& file, const StoredHistory& history,
                         const StoredCells& cells) {
    const MapperOptions& options = history.options;
    if (options.cell_m != cells.cell_m) {
        refuse(file, fmt::format("its cells are {:g} m wide, those of {} {:g} m", options.cell_m,
                                 cells_name, cells.cell_m));
    }
    if (options.zone != cells.zone || options.limit != cells.limit ||
        options.threshold != cells.threshold) {
        refuse(file, fmt::format("its zones, limit or threshold are not those of {}", cells_name));
    }
}

int value_in(const StoredHistory& history, const CellIndex& cell) {
    const auto zone = history.zones.find(zone_of(cell, history.options.zone));
    return zone == history.zones.end()
               ? 0
               : zone->second.values[index_in_zone(cell, history.options.zone)];
}

void take_stamp(const fs::path& file, const CellIndex& cell, const CellStamp& stamp,
                JudgedMap& map) {
    map.ever_occupied.push_back({cell, stamp.first_image});
    if (stamp.since_image == CellStamp::never) {
        return;
    }
    const auto known = std::ranges::lower_bound(map.occupied_cells, cell, {}, &OccupiedCell::cell);
    if (known == map.occupied_cells.end() || known->cell != cell) {
        refuse(file, fmt::format("its cell {} {} {} is occupied, but belongs to no object", cell.x,
                                 cell.y, cell.z));
    }
    known->since_image = stamp.since_image;
}

void read_history(const fs::path& file, const StoredCells& cells, JudgedMap& map) {
    const StoredHistory history = read_history_file(file);
    require_same_header(file, history, cells);
    if (history.frames != map.frames) {
        refuse(file, fmt::format("it is of a recording with {} frames, the map of one with {}",
                                 history.frames, map.frames));
    }
    cells.for_each_cell([&](const CellIndex& cell, int value) {
        const int known = value_in(history, cell);
        if (known != value) {
            refuse(file, fmt::format("its cell {} {} {} has the value {}, that of {} {}", cell.x,
                                     cell.y, cell.z, known, cells_name, value));
        }
    });
    for (const auto& [zone, known] : history.zones) {
        for (std::uint32_t place = 0; place < known.values.size(); ++place) {
            take_value(cell_at(zone, place, history.options.zone), known.values[place],
                       history.options.threshold, map);
        }
        for (const auto& stamp : known.stamps) {
            take_stamp(file, cell_at(zone, stamp.place, history.options.zone), stamp, map);
        }
    }
    std::ranges::sort(map.ever_occupied, {}, &OnceOccupiedCell::cell);
    const auto lost =
        std::ranges::find(map.occupied_cells, CellStamp::never, &OccupiedCell::since_image);
    if (lost != map.occupied_cells.end()) {
        refuse(file, fmt::format("it does not know the cell {} {} {} of {}", lost->cell.x,
                                 lost->cell.y, lost->cell.z, objects_name));
    }
    map.has_history = true;
}

/// Times and numbers of images are alike where a scene is flown again: the digest is not.
void require_digest_of_truth(const JudgedMap& map, const fs::path& truth_folder) {
    constexpr std::size_t shown = 12;
    const std::string report = (fs::path(map.folder) / report_name).string();
    if (!map.truth_digest) {
        throw InputError(report,
                         "recording.truth_digest is missing: nothing says which truth is that of "
                         "the map's recording",
                         fmt::format("map {} again; simulate it again before if its "
                                     "description.toml has no truth.digest",
                                     map.recording));
    }
    const std::string digest = digest_of_truth(truth_folder);
    if (digest != *map.truth_digest) {
        throw InputError(
            truth_folder.string(),
            fmt::format("its files' digest is {}..., but recording.truth_digest in {} is {}...: "
                        "this is the truth of another flight, or was changed",
                        digest.substr(0, shown), report, map.truth_digest->substr(0, shown)),
            fmt::format("name the truth of {}, which was mapped, or map it again if it was "
                        "simulated again since",
                        map.recording));
    }
}

} // namespace

JudgedMap read_judged_map(const fs::path& folder) {
    require_map(folder);
    JudgedMap map;
    map.folder = folder.string();
    const std::string digest = read_report(folder / report_name, map);
    require_digest(folder, digest);
    const StoredCells cells = read_cells_file(folder / cells_name);
    if (cells.cell_m != map.cell_m) {
        refuse(folder / cells_name, fmt::format("its cells are {:g} m wide, those of {} {:g} m",
                                                cells.cell_m, report_name, map.cell_m));
    }
    read_objects(folder / objects_name, cells.zone, map);
    std::error_code error;
    if (fs::exists(folder / history_name, error)) {
        read_history(folder / history_name, cells, map);
    } else {
        cells.for_each_cell([&](const CellIndex& cell, int value) {
            take_value(cell, value, cells.threshold, map);
        });
    }
    return map;
}

void require_same_recording(const JudgedMap& map, const Truth& truth,
                            const fs::path& truth_folder) {
    const auto fail = [&](const std::string& problem) {
        throw InputError(truth_folder.string(), problem,
                         fmt::format("name the truth of {}, which was mapped", map.recording));
    };
    if (truth.images.size() != map.frames) {
        fail(fmt::format("it has {} images, the map's recording has {}", truth.images.size(),
                         map.frames));
    }
    const double first_s = truth.images.front().time_s;
    const double last_s = truth.images.back().time_s;
    const auto fits = [](double true_s, double stated_s) {
        return stated_s >= true_s - same_time_s && stated_s <= true_s + most_lateness_s;
    };
    if (!fits(first_s, map.first_time_s) || !fits(last_s, map.last_time_s)) {
        fail(
            fmt::format("its images are from {:.3f} to {:.3f} s, those of the map's recording "
                        "from {:.3f} to {:.3f} s",
                        first_s, last_s, map.first_time_s, map.last_time_s));
    }
    require_digest_of_truth(map, truth_folder);
}

} // namespace zonegrid
