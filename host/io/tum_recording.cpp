#include "io/file_bytes.h"
#include "io/frame_list.h"
#include "io/image_recording.h"
#include "io/pose_conversion.h"
#include "io/recording_layouts.h"
#include "io/text_list.h"
#include "io/tum_association.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace zonegrid {
namespace {

constexpr double default_units_per_m = 5000.0;

/// Depth camera of one of the benchmark's three Kinects: fx fy cx cy in pixels.
struct KnownCamera {
    std::string_view folder_part;
    std::array<double, 4> intrinsics;
};

constexpr std::array<KnownCamera, 4> known_cameras{{
    {"freiburg1", {517.3, 516.5, 318.6, 255.3}},
    {"freiburg2", {520.9, 521.0, 325.1, 249.7}},
    {"freiburg3", {535.4, 539.2, 320.1, 247.6}},
    {"", {525.0, 525.0, 319.5, 239.5}}, // the driver's default, for every other folder
}};

std::optional<std::filesystem::path> find_association(const std::filesystem::path& folder) {
    for (const std::filesystem::path& entry : list_folder(folder)) {
        const std::string name = entry.filename().string();
        if (entry.extension() == ".txt" && name.find("association") != std::string::npos) {
            return entry;
        }
    }
    return std::nullopt;
}

std::array<double, 4> choose_intrinsics(const std::filesystem::path& folder,
                                        const RecordingOptions& options,
                                        std::vector<std::string>& notes) {
    if (options.intrinsics) {
        notes.emplace_back("Intrinsics: as given by the caller.");
        return *options.intrinsics;
    }
    const std::string name = folder.filename().string();
    const KnownCamera& known = *std::ranges::find_if(known_cameras, [&](const KnownCamera& camera) {
        return name.find(camera.folder_part) != std::string::npos;
    });
    const auto& [fx, fy, cx, cy] = known.intrinsics;
    notes.push_back(known.folder_part.empty()
                        ? fmt::format("Intrinsics fx {} fy {} cx {} cy {}: the default of the "
                                      "benchmark, for the folder's name holds no freiburg1 ... 3.",
                                      fx, fy, cx, cy)
                        : fmt::format("Intrinsics fx {} fy {} cx {} cy {}: those of {}, by the "
                                      "folder's name.",
                                      fx, fy, cx, cy, known.folder_part));
    return known.intrinsics;
}

/// depth.txt: "time file" a line.
std::vector<FrameEntry> read_depth_list(const std::filesystem::path& folder,
                                        std::vector<RecordingWarning>& warnings) {
    const std::filesystem::path file = folder / "depth.txt";
    FrameList frames(file);
    for (const ListLine& line : read_text_list(file)) {
        const std::string where = place_of(file, line.number);
        if (line.fields.size() != 2) {
            throw InputError(where, fmt::format("{} fields where 2 belong", line.fields.size()),
                             "a line holds a time and a file");
        }
        frames.add(parse_number(line.fields[0], "the time", where), folder / line.fields[1], where);
    }
    return frames.take(warnings);
}

/// groundtruth.txt: "time tx ty tz qx qy qz qw" a line.
std::vector<TimedPose> read_trajectory(const std::filesystem::path& file) {
    std::vector<TimedPose> poses;
    for (const ListLine& line : read_text_list(file)) {
        const std::string where = place_of(file, line.number);
        if (line.fields.size() != 8) {
            throw InputError(where, fmt::format("{} fields where 8 belong", line.fields.size()),
                             "a line holds a time, tx ty tz and qx qy qz qw");
        }
        const double time_s = parse_number(line.fields[0], "the time", where);
        if (!poses.empty()) {
            require_later(poses.back().time_s, time_s, where);
        }
        poses.push_back({time_s, parse_pose(std::span(line.fields).subspan<1, 7>(), where)});
    }
    return poses;
}

} // namespace

bool is_tum_recording(const std::filesystem::path& folder) {
    std::error_code error;
    return std::filesystem::is_regular_file(folder / "depth.txt", error) ||
           find_association(folder).has_value();
}

std::unique_ptr<Recording> open_tum_recording(const std::filesystem::path& folder,
                                              const RecordingOptions& options) {
    RecordingContents contents;
    contents.layout = "tum";
    contents.path = folder;
    std::vector<TimedPose> poses;
    std::error_code error;
    const bool as_published = std::filesystem::exists(folder / "depth.txt", error) &&
                              std::filesystem::exists(folder / "groundtruth.txt", error);
    const std::optional<std::filesystem::path> association =
        as_published ? std::nullopt : find_association(folder);
    if (association) {
        TumAssociation list = read_tum_association(*association, contents.warnings);
        contents.frames = std::move(list.frames);
        poses = std::move(list.poses);
        contents.notes.push_back(fmt::format(
            "Times: from the names of the depth images and the poses beside them in {}.",
            association->filename().string()));
    } else {
        contents.frames = read_depth_list(folder, contents.warnings);
        poses = read_trajectory(folder / "groundtruth.txt");
    }

    contents.camera = forward_pinhole(size_of_first_image(contents.frames),
                                      choose_intrinsics(folder, options, contents.notes), options);
    const WorldAxes axes =
        options.world_axes == WorldAxes::layout_default ? WorldAxes::z_up : options.world_axes;
    contents.navigation = samples_of_poses(poses, axes, contents.camera->body_from_camera);
    contents.notes.push_back(describe_pose_navigation(axes));
    DepthCoding coding;
    coding.units_per_m = options.depth_units_per_m.value_or(default_units_per_m);
    contents.notes.push_back(
        fmt::format("Depth: {} units per metre, 0 is missing.", coding.units_per_m));
    return std::make_unique<ImageRecording>(std::move(contents), std::move(coding));
}

} // namespace zonegrid
