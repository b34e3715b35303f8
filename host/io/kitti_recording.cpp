#include "io/frame_list.h"
#include "io/oxts.h"
#include "io/pose_conversion.h"
#include "io/recording_layouts.h"
#include "io/scan_recording.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace zonegrid {
namespace {

constexpr std::string_view calibration_name = "calib_imu_to_velo.txt";

/// The numbers after "key:" in a calibration file.
Eigen::VectorXd calibration_values(std::span<const ListLine> lines, std::string_view key,
                                   std::size_t count, const std::filesystem::path& file) {
    for (const ListLine& line : lines) {
        if (line.fields.front() != key) {
            continue;
        }
        const std::string where = place_of(file, line.number);
        if (line.fields.size() != count + 1) {
            throw InputError(
                where, fmt::format("{} numbers where {} belong", line.fields.size() - 1, count),
                "copy the calibration again from its source");
        }
        Eigen::VectorXd values(static_cast<Eigen::Index>(count));
        for (std::size_t index = 0; index < count; ++index) {
            values(static_cast<Eigen::Index>(index)) =
                parse_number(line.fields[index + 1], "the calibration value", where);
        }
        return values;
    }
    throw InputError(file.string(), fmt::format("there is no line '{}'", key),
                     "copy the calibration again from its source");
}

/// The calibration lies in the drive's folder or, as published, in the folder of the day above.
std::filesystem::path find_calibration(const std::filesystem::path& folder) {
    std::error_code error;
    const std::filesystem::path inside = folder / calibration_name;
    const std::filesystem::path above = folder.parent_path() / calibration_name;
    return !std::filesystem::exists(inside, error) && std::filesystem::exists(above, error)
               ? above
               : inside;
}

Eigen::Isometry3d read_velodyne_from_imu(const std::filesystem::path& file) {
    const std::vector<ListLine> lines = read_text_list(file);
    const Eigen::VectorXd rotation = calibration_values(lines, "R:", 9, file);
    Eigen::Matrix3d matrix;
    matrix << rotation(0), rotation(1), rotation(2), rotation(3), rotation(4), rotation(5),
        rotation(6), rotation(7), rotation(8);
    Eigen::Isometry3d velodyne_from_imu = Eigen::Isometry3d::Identity();
    velodyne_from_imu.linear() = checked_rotation(matrix, file.string());
    velodyne_from_imu.translation() = calibration_values(lines, "T:", 3, file);
    return velodyne_from_imu;
}

std::vector<FrameEntry> read_sweeps(const std::filesystem::path& folder,
                                    std::vector<RecordingWarning>& warnings) {
    const std::filesystem::path list = folder / "velodyne_points" / "timestamps.txt";
    const std::filesystem::path data = folder / "velodyne_points" / "data";
    FrameList sweeps(list);
    std::size_t index = 0;
    for (const auto& [time_s, where] : read_kitti_times(list)) {
        std::error_code error;
        std::filesystem::path file = data / fmt::format("{:010}.bin", index);
        const std::filesystem::path text = data / fmt::format("{:010}.txt", index);
        if (!std::filesystem::exists(file, error) && std::filesystem::exists(text, error)) {
            file = text;
        }
        sweeps.add(time_s, file, where);
        ++index;
    }
    return sweeps.take(warnings);
}

} // namespace

bool is_kitti_recording(const std::filesystem::path& folder) {
    std::error_code error;
    return std::filesystem::is_directory(folder / "velodyne_points", error) &&
           std::filesystem::is_directory(folder / "oxts", error);
}

std::unique_ptr<Recording> open_kitti_recording(const std::filesystem::path& folder,
                                                const RecordingOptions& options) {
    require_no_camera_options(options, "kitti");
    if (options.world_axes != WorldAxes::layout_default) {
        throw UsageError("layout kitti is georeferenced and needs no world axes; leave them out");
    }
    RecordingContents contents;
    contents.layout = "kitti";
    contents.path = folder;
    const std::filesystem::path calibration = find_calibration(folder);
    contents.body_from_sensor = Eigen::Isometry3d(body_from_forward_left_up()) *
                                read_velodyne_from_imu(calibration).inverse();
    OxtsLog log = read_oxts(folder, contents.warnings);
    contents.navigation = std::move(log.samples);
    contents.origin = log.origin;
    contents.frames = read_sweeps(folder, contents.warnings);
    contents.notes.push_back(
        fmt::format("Mounting of the scanner: from {}.", calibration.string()));
    contents.notes.emplace_back(
        "Body: the IMU. World: north-east-down at the first oxts row. Points are not corrected for "
        "the motion during a sweep.");
    return std::make_unique<ScanRecording>(std::move(contents), PointFields::xyz_reflectance);
}

} // namespace zonegrid
