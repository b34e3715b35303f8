#include "io/file_bytes.h"
#include "io/frame_list.h"
#include "io/image_recording.h"
#include "io/pose_conversion.h"
#include "io/recording_layouts.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace zonegrid {
namespace {

constexpr double default_units_per_m = 1000.0;
constexpr double frames_per_second = 30.0;
constexpr std::string_view image_ending = ".depth.png";
constexpr std::string_view first_name = "frame-";

/// The number in "frame-NNNNNN.depth.png"; none if the name is another.
std::optional<std::uint32_t> frame_number(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (!name.starts_with(first_name) || !name.ends_with(image_ending)) {
        return std::nullopt;
    }
    const char* const end = name.data() + name.size() - image_ending.size();
    std::uint32_t number = 0;
    const auto [stop, error] = std::from_chars(name.data() + first_name.size(), end, number);
    if (error != std::errc{} || stop != end) {
        return std::nullopt;
    }
    return number;
}

struct NumberedImage {
    std::uint32_t number;
    std::filesystem::path file;
};

std::vector<NumberedImage> find_images(const std::filesystem::path& folder) {
    std::vector<NumberedImage> images;
    for (const std::filesystem::path& entry : list_folder(folder)) {
        if (const std::optional<std::uint32_t> number = frame_number(entry)) {
            images.push_back({*number, entry});
        }
    }
    std::ranges::stable_sort(images, {}, &NumberedImage::number);
    return images;
}

/// The folder itself, or its subfolder data/, which holds the images.
std::filesystem::path image_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::path inner = folder / "data";
    if (find_images(folder).empty() && std::filesystem::is_directory(inner, error)) {
        return inner;
    }
    return folder;
}

/// `count` rows of `count` numbers.
Eigen::MatrixXd read_matrix(const std::filesystem::path& file, std::size_t count) {
    const std::vector<ListLine> lines = read_text_list(file);
    const auto size = static_cast<Eigen::Index>(count);
    Eigen::MatrixXd matrix(size, size);
    if (lines.size() != count) {
        throw InputError(file.string(), fmt::format("{} rows where {} belong", lines.size(), count),
                         fmt::format("give a {0} x {0} matrix as text", count));
    }
    for (std::size_t row = 0; row < count; ++row) {
        const std::string where = place_of(file, lines[row].number);
        if (lines[row].fields.size() != count) {
            throw InputError(
                where, fmt::format("{} fields where {} belong", lines[row].fields.size(), count),
                fmt::format("give a {0} x {0} matrix as text", count));
        }
        for (std::size_t column = 0; column < count; ++column) {
            matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
                parse_number(lines[row].fields[column], "the matrix entry", where);
        }
    }
    return matrix;
}

Eigen::Isometry3d read_pose(const std::filesystem::path& file) {
    const Eigen::MatrixXd matrix = read_matrix(file, 4);
    if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
        throw InputError(file.string(), "the last row of the pose is not 0 0 0 1",
                         "give camera-to-world matrices, not transposed");
    }
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = checked_rotation(matrix.topLeftCorner<3, 3>(), file.string());
    pose.translation() = matrix.topRightCorner<3, 1>();
    return pose;
}

std::array<double, 4> choose_intrinsics(const std::filesystem::path& folder,
                                        const std::filesystem::path& images,
                                        const RecordingOptions& options,
                                        std::vector<std::string>& notes) {
    if (options.intrinsics) {
        notes.emplace_back("Intrinsics: as given by the caller.");
        return *options.intrinsics;
    }
    std::error_code error;
    std::filesystem::path file = images / "camera-intrinsics.txt";
    if (!std::filesystem::exists(file, error)) {
        file = folder / "camera-intrinsics.txt";
    }
    const Eigen::MatrixXd matrix = read_matrix(file, 3);
    if (!(matrix(0, 0) > 0.0) || !(matrix(1, 1) > 0.0) || matrix(0, 1) != 0.0 ||
        matrix(1, 0) != 0.0 || matrix.row(2) != Eigen::RowVector3d(0, 0, 1)) {
        throw InputError(file.string(), "the matrix is no pinhole camera",
                         "give fx 0 cx / 0 fy cy / 0 0 1 in pixels with fx and fy above 0");
    }
    notes.push_back(fmt::format("Intrinsics fx {} fy {} cx {} cy {}: from {}.", matrix(0, 0),
                                matrix(1, 1), matrix(0, 2), matrix(1, 2),
                                file.filename().string()));
    return {matrix(0, 0), matrix(1, 1), matrix(0, 2), matrix(1, 2)};
}

/// Fills frames, warnings and poses from the images that have a pose file.
std::vector<TimedPose> pair_images(const std::filesystem::path& images,
                                   RecordingContents& contents) {
    std::vector<TimedPose> poses;
    FrameList frames(images);
    std::size_t without_pose = 0;
    for (const auto& [number, file] : find_images(images)) {
        std::string pose_name = file.filename().string();
        pose_name.replace(pose_name.size() - image_ending.size(), image_ending.size(), ".pose.txt");
        std::error_code error;
        if (!std::filesystem::exists(images / pose_name, error)) {
            ++without_pose;
            continue;
        }
        const double time_s = static_cast<double>(number) / frames_per_second;
        frames.add(time_s, file, file.string());
        poses.push_back({time_s, read_pose(images / pose_name)});
    }
    if (without_pose > 0) {
        contents.warnings.push_back(
            {images.string(),
             fmt::format("{} depth images have no .pose.txt beside them and are skipped",
                         without_pose)});
    }
    if (poses.empty()) {
        throw InputError(images.string(), "no depth image has a pose",
                         "put a frame-NNNNNN.pose.txt beside each frame-NNNNNN.depth.png");
    }
    contents.frames = frames.take(contents.warnings);
    return poses;
}

} // namespace

bool is_poses_recording(const std::filesystem::path& folder) {
    return !find_images(image_folder(folder)).empty();
}

std::unique_ptr<Recording> open_poses_recording(const std::filesystem::path& folder,
                                                const RecordingOptions& options) {
    RecordingContents contents;
    contents.layout = "poses";
    contents.path = folder;
    const std::filesystem::path images = image_folder(folder);
    const std::vector<TimedPose> poses = pair_images(images, contents);
    contents.camera =
        forward_pinhole(size_of_first_image(contents.frames),
                        choose_intrinsics(folder, images, options, contents.notes), options);
    const WorldAxes axes =
        options.world_axes == WorldAxes::layout_default ? WorldAxes::y_down : options.world_axes;
    contents.navigation = samples_of_poses(poses, axes, contents.camera->body_from_camera);
    contents.notes.push_back(describe_pose_navigation(axes));
    contents.notes.push_back(
        fmt::format("Times: frame number / {} s, for the layout has none.", frames_per_second));
    DepthCoding coding;
    coding.units_per_m = options.depth_units_per_m.value_or(default_units_per_m);
    coding.missing = {0.0F, 65535.0F};
    contents.notes.push_back(
        fmt::format("Depth: {} units per metre, 0 and 65535 are missing.", coding.units_per_m));
    return std::make_unique<ImageRecording>(std::move(contents), std::move(coding));
}

} // namespace zonegrid
