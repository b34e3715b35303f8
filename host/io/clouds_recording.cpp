#include "io/frame_list.h"
#include "io/pose_conversion.h"
#include "io/recording_layouts.h"
#include "io/scan_recording.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <utility>

namespace zonegrid {
namespace {

constexpr double period_s = 0.1;

/// The number at the end of a cloud's identifier: 12 in "v12".
std::uint32_t cloud_number(std::string_view identifier, const std::string& where) {
    const std::size_t last = identifier.find_last_not_of("0123456789");
    const std::string_view digits =
        last == std::string_view::npos ? identifier : identifier.substr(last + 1);
    std::uint32_t number = 0;
    const auto [stop, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (digits.empty() || error != std::errc{}) {
        throw InputError(where, fmt::format("'{}' does not end in a cloud's number", identifier),
                         "a line holds 'vN x y z qx qy qz qw' for the cloud 00000N/points.bin");
    }
    return number;
}

} // namespace

bool is_clouds_recording(const std::filesystem::path& folder) {
    std::error_code error;
    return std::filesystem::is_regular_file(folder / "graph.txt", error);
}

std::unique_ptr<Recording> open_clouds_recording(const std::filesystem::path& folder,
                                                 const RecordingOptions& options) {
    require_no_camera_options(options, "clouds");
    RecordingContents contents;
    contents.layout = "clouds";
    contents.path = folder;
    contents.body_from_sensor.linear() = body_from_forward_left_up();

    const std::filesystem::path list = folder / "graph.txt";
    FrameList frames(list);
    std::vector<TimedPose> poses;
    for (const ListLine& line : read_text_list(list)) {
        const std::string where = place_of(list, line.number);
        if (line.fields.size() != 8) {
            throw InputError(where, fmt::format("{} fields where 8 belong", line.fields.size()),
                             "a line holds an identifier, x y z and qx qy qz qw");
        }
        const std::uint32_t number = cloud_number(line.fields[0], where);
        const double time_s = period_s * number;
        frames.add(time_s, folder / fmt::format("{:06}", number) / "points.bin", where);
        poses.push_back({time_s, parse_pose(std::span(line.fields).subspan<1, 7>(), where)});
    }
    contents.frames = frames.take(contents.warnings);

    const WorldAxes axes =
        options.world_axes == WorldAxes::layout_default ? WorldAxes::z_up : options.world_axes;
    contents.navigation = samples_of_poses(poses, axes, contents.body_from_sensor);
    contents.notes.push_back(describe_pose_navigation(axes));
    contents.notes.push_back(fmt::format(
        "Times: cloud number * {} s, for the layout has none; velocities are nominal.", period_s));
    return std::make_unique<ScanRecording>(std::move(contents), PointFields::xyz);
}

} // namespace zonegrid
