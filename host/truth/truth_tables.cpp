#include "truth/truth_tables.h"

#include "io/csv_table.h"
#include "io/file_bytes.h"
#include "io/output_file.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace zonegrid {
namespace {

using Triple = std::array<std::size_t, 3>;

constexpr double rounding = 1e-6;  // what long chains of turns may leave
constexpr double farthest_m = 1e6; // no scene's; rays from there would end anywhere
constexpr std::string_view remedy = "simulate the scene again";

// A frame's pose as its origin and its axes: a quaternion would not give back the same bits.
constexpr std::string_view pose_columns =
    "north_m,east_m,down_m,x_north,x_east,x_down,"
    "y_north,y_east,y_down,z_north,z_east,z_down";

std::string triple_text(const Eigen::Vector3d& values) {
    return fmt::format(",{},{},{}", values.x(), values.y(), values.z());
}

std::string pose_text(const Eigen::Isometry3d& pose) {
    return triple_text(pose.translation()) + triple_text(pose.linear().col(0)) +
           triple_text(pose.linear().col(1)) + triple_text(pose.linear().col(2));
}

/// The table, refused if it was cut within its last number, which would then be another one.
CsvTable open_table(const std::filesystem::path& file) {
    if (read_file_bytes(file).back() != '\n') {
        throw InputError(file.string(), "the last line is cut off", std::string(remedy));
    }
    return CsvTable(file);
}

Triple need_triple(CsvTable& table, const std::array<std::string_view, 3>& names) {
    return {table.need(names[0]), table.need(names[1]), table.need(names[2])};
}

struct PoseColumns {
    explicit PoseColumns(CsvTable& table)
        : origin(need_triple(table, {"north_m", "east_m", "down_m"})),
          axes{need_triple(table, {"x_north", "x_east", "x_down"}),
               need_triple(table, {"y_north", "y_east", "y_down"}),
               need_triple(table, {"z_north", "z_east", "z_down"})} {}

    Triple origin;
    std::array<Triple, 3> axes;
};

Eigen::Isometry3d read_pose(const CsvTable& table, std::size_t row, const PoseColumns& columns) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = table.vector(row, columns.origin);
    if (pose.translation().cwiseAbs().maxCoeff() > farthest_m) {
        throw InputError(table.place(row), fmt::format("the place is beyond {:g} m", farthest_m),
                         std::string(remedy));
    }
    for (int axis = 0; axis < 3; ++axis) {
        pose.linear().col(axis) =
            table.vector(row, columns.axes.at(static_cast<std::size_t>(axis)));
    }
    if (!is_rotation(pose.linear())) {
        throw InputError(table.place(row), "the axes are not at right angles, of length 1",
                         std::string(remedy));
    }
    return pose;
}

std::uint32_t read_moving_obstacle(const CsvTable& table, std::size_t row, std::size_t column,
                                   std::span<const TrueObstacle> obstacles) {
    const double number = table.number(row, column);
    if (number < 0.0 || number >= static_cast<double>(obstacles.size()) ||
        number != std::floor(number) || !obstacles[static_cast<std::size_t>(number)].moving) {
        throw InputError(table.place(row),
                         fmt::format("obstacle {} is none that moves", table.text(row, column)),
                         std::string(remedy));
    }
    return static_cast<std::uint32_t>(number);
}

} // namespace

bool is_rotation(const Eigen::Matrix3d& matrix) {
    return (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).norm() < rounding &&
           matrix.determinant() > 0.0;
}

void write_true_navigation(const std::filesystem::path& file,
                           std::span<const NavigationSample> samples) {
    OutputFile output(file);
    output.write(
        "time_s,north_m,east_m,down_m,qx,qy,qz,qw,north_mps,east_mps,down_mps,"
        "north_mps2,east_mps2,down_mps2,roll_radps,pitch_radps,yaw_radps\n");
    for (const NavigationSample& sample : samples) {
        const Eigen::Quaterniond& attitude = sample.world_from_body;
        output.write(fmt::format(
            "{}{},{},{},{},{}{}{}{}\n", sample.time_s, triple_text(sample.position_m), attitude.x(),
            attitude.y(), attitude.z(), attitude.w(), triple_text(sample.velocity_mps),
            triple_text(sample.acceleration_mps2), triple_text(sample.body_rate_radps)));
    }
    output.close();
}

std::vector<NavigationSample> read_true_navigation(const std::filesystem::path& file) {
    CsvTable table = open_table(file);
    const std::size_t time = table.need("time_s");
    const Triple position = need_triple(table, {"north_m", "east_m", "down_m"});
    const std::array quaternion{table.need("qx"), table.need("qy"), table.need("qz"),
                                table.need("qw")};
    const Triple velocity = need_triple(table, {"north_mps", "east_mps", "down_mps"});
    const Triple acceleration = need_triple(table, {"north_mps2", "east_mps2", "down_mps2"});
    const Triple rate = need_triple(table, {"roll_radps", "pitch_radps", "yaw_radps"});
    table.require_all_read();
    std::vector<NavigationSample> samples(table.row_count());
    for (std::size_t row = 0; row < samples.size(); ++row) {
        NavigationSample& sample = samples[row];
        sample.time_s = table.number(row, time);
        sample.position_m = table.vector(row, position);
        sample.velocity_mps = table.vector(row, velocity);
        sample.acceleration_mps2 = table.vector(row, acceleration);
        sample.body_rate_radps = table.vector(row, rate);
        const auto& [x, y, z, w] = quaternion;
        sample.world_from_body = Eigen::Quaterniond(table.number(row, w), table.number(row, x),
                                                    table.number(row, y), table.number(row, z));
        if (std::abs(sample.world_from_body.norm() - 1.0) > rounding) {
            throw InputError(table.place(row), "the quaternion's norm is not 1",
                             std::string(remedy));
        }
        if (row > 0) {
            require_later(samples[row - 1].time_s, sample.time_s, table.place(row));
        }
    }
    return samples;
}

void write_true_images(const std::filesystem::path& file, std::span<const TrueImage> images) {
    OutputFile output(file);
    output.write(fmt::format("time_s,{}\n", pose_columns));
    for (const TrueImage& image : images) {
        output.write(fmt::format("{}{}\n", image.time_s, pose_text(image.world_from_camera)));
    }
    output.close();
}

std::vector<TrueImage> read_true_images(const std::filesystem::path& file) {
    CsvTable table = open_table(file);
    const std::size_t time = table.need("time_s");
    const PoseColumns columns(table);
    table.require_all_read();
    std::vector<TrueImage> images(table.row_count());
    for (std::size_t row = 0; row < images.size(); ++row) {
        images[row] = {table.number(row, time), read_pose(table, row, columns)};
        if (row > 0) {
            require_later(images[row - 1].time_s, images[row].time_s, table.place(row));
        }
    }
    return images;
}

void write_motions(const std::filesystem::path& file, std::span<const ObstacleMotion> motions) {
    OutputFile output(file);
    output.write(fmt::format("obstacle,time_s,{}\n", pose_columns));
    for (const ObstacleMotion& motion : motions) {
        for (const MovingPose& pose : motion.poses) {
            output.write(fmt::format("{},{}{}\n", motion.obstacle, pose.time_s,
                                     pose_text(pose.world_from_obstacle)));
        }
    }
    output.close();
}

std::vector<ObstacleMotion> read_motions(const std::filesystem::path& file,
                                         std::span<const TrueObstacle> obstacles) {
    CsvTable table = open_table(file);
    const std::size_t which = table.need("obstacle");
    const std::size_t time = table.need("time_s");
    const PoseColumns columns(table);
    table.require_all_read();
    std::vector<ObstacleMotion> motions;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const std::uint32_t obstacle = read_moving_obstacle(table, row, which, obstacles);
        const MovingPose pose{table.number(row, time), read_pose(table, row, columns)};
        if (!motions.empty() && motions.back().obstacle == obstacle) {
            require_later(motions.back().poses.back().time_s, pose.time_s, table.place(row));
        } else {
            for (const ObstacleMotion& earlier : motions) {
                if (earlier.obstacle == obstacle) {
                    throw InputError(table.place(row),
                                     fmt::format("the lines of obstacle {} do not follow each "
                                                 "other",
                                                 obstacle),
                                     std::string(remedy));
                }
            }
            motions.push_back({obstacle, {}});
        }
        motions.back().poses.push_back(pose);
    }
    return motions;
}

} // namespace zonegrid
