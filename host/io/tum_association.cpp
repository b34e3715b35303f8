#include "io/tum_association.h"

#include "io/frame_list.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <cstddef>
#include <set>
#include <span>
#include <string>

namespace zonegrid {
namespace {

constexpr std::size_t pose_fields = 7;

/// The depth image among the fields before the pose: the file whose name says so, else the last.
std::size_t find_depth_field(std::span<const std::string> fields, const std::string& where) {
    std::size_t last = fields.size();
    for (std::size_t index = 0; index < fields.size(); ++index) {
        if (is_number(fields[index])) {
            continue;
        }
        last = index;
        if (fields[index].find("depth") != std::string::npos) {
            break;
        }
    }
    if (last == fields.size()) {
        throw InputError(where, "the line names no depth image",
                         "a line holds 'rgb depth tx ty tz qx qy qz qw', times before the files as "
                         "you like");
    }
    return last;
}

double time_of(std::span<const std::string> fields, std::size_t depth_field,
               const std::string& where) {
    if (depth_field > 0 && is_number(fields[depth_field - 1])) {
        return parse_number(fields[depth_field - 1], "the time", where);
    }
    const std::string stem = std::filesystem::path(fields[depth_field]).stem().string();
    return parse_number(stem, "the time in the depth image's name", where);
}

} // namespace

TumAssociation read_tum_association(const std::filesystem::path& file,
                                    std::vector<RecordingWarning>& warnings) {
    TumAssociation list;
    FrameList frames(file);
    std::set<std::string> seen;
    std::size_t doubled = 0;
    for (const ListLine& line : read_text_list(file)) {
        const std::string where = place_of(file, line.number);
        if (line.fields.size() <= pose_fields) {
            throw InputError(where, fmt::format("{} fields are too few", line.fields.size()),
                             "a line ends in the camera's pose: 'rgb depth tx ty tz qx qy qz qw'");
        }
        const auto fields = std::span(line.fields);
        const auto names = fields.first(fields.size() - pose_fields);
        const std::size_t depth_field = find_depth_field(names, where);
        const double time_s = time_of(names, depth_field, where);
        const Eigen::Isometry3d pose = parse_pose(fields.last<pose_fields>(), where);
        if (!seen.insert(names[depth_field]).second) {
            ++doubled;
            continue;
        }
        frames.add(time_s, file.parent_path() / names[depth_field], where);
        list.poses.push_back({time_s, pose});
    }
    if (doubled > 0) {
        warnings.push_back(
            {file.string(), fmt::format("{} lines name a depth image again and are left out; the "
                                        "first line with an image counts",
                                        doubled)});
    }
    list.frames = frames.take(warnings);
    return list;
}

} // namespace zonegrid
