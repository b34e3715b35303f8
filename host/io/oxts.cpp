#include "io/oxts.h"

#include "io/frame_list.h"
#include "io/pose_conversion.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/NormalGravity.hpp>

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

namespace zonegrid {
namespace {

/// Columns of a row, as oxts/dataformat.txt numbers them from 0.
enum Column : std::size_t {
    latitude_deg,
    longitude_deg,
    altitude_m,
    roll_rad,
    pitch_rad,
    yaw_rad,
    north_mps,
    east_mps,
    forward_mps,
    left_mps,
    up_mps,
    x_mps2,
    y_mps2,
    z_mps2,
    forward_mps2,
    left_mps2,
    up_mps2,
    x_radps,
    y_radps,
    z_radps,
    used_columns
};

using Row = std::array<double, used_columns>;

Row read_row(const std::filesystem::path& file) {
    const std::vector<ListLine> lines = read_text_list(file);
    const std::string where = place_of(file, lines.front().number);
    const std::vector<std::string>& fields = lines.front().fields;
    if (lines.size() != 1 || fields.size() < used_columns) {
        throw InputError(where,
                         fmt::format("{} lines, the first of {} fields, are no oxts row",
                                     lines.size(), fields.size()),
                         "a row is one line of 30 numbers: copy the file again from its source");
    }
    Row row{};
    for (std::size_t column = 0; column < used_columns; ++column) {
        row[column] = parse_number(fields[column], fmt::format("field {}", column + 1), where);
    }
    if (std::abs(row[latitude_deg]) > 90.0) {
        throw InputError(where, fmt::format("latitude {} is beyond the pole", row[latitude_deg]),
                         "fields 1 to 3 are latitude and longitude in degrees and altitude in m");
    }
    return row;
}

/// Attitude of the forward-left-up IMU in the east-north-up world.
Eigen::Quaterniond attitude_of(const Row& row) {
    return Eigen::AngleAxisd(row[yaw_rad], Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(row[pitch_rad], Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(row[roll_rad], Eigen::Vector3d::UnitX());
}

NavigationSample sample_of(double time_s, const Row& row,
                           const GeographicLib::LocalCartesian& local) {
    const Eigen::Matrix3d north_east_down = north_east_down_from(WorldAxes::east_north_up);
    const Eigen::Matrix3d body_from_imu = body_from_forward_left_up();
    const Eigen::Matrix3d world_from_imu = north_east_down * attitude_of(row).toRotationMatrix();

    NavigationSample sample;
    sample.time_s = time_s;
    Eigen::Vector3d east_north_up_m;
    local.Forward(row[latitude_deg], row[longitude_deg], row[altitude_m], east_north_up_m.x(),
                  east_north_up_m.y(), east_north_up_m.z());
    sample.position_m = north_east_down * east_north_up_m;
    sample.velocity_mps = {row[north_mps], row[east_mps], -row[up_mps]};
    sample.world_from_body =
        Eigen::Quaterniond(Eigen::Matrix3d(world_from_imu * body_from_imu.transpose()));
    sample.body_rate_radps =
        body_from_imu * Eigen::Vector3d(row[x_radps], row[y_radps], row[z_radps]);

    // The log's accelerations are what the IMU feels; at rest that is the reaction to gravity.
    double gravity_north = 0.0;
    double gravity_up = 0.0;
    GeographicLib::NormalGravity::WGS84().Gravity(row[latitude_deg], row[altitude_m], gravity_north,
                                                  gravity_up);
    sample.acceleration_mps2 =
        world_from_imu * Eigen::Vector3d(row[x_mps2], row[y_mps2], row[z_mps2]) +
        Eigen::Vector3d(gravity_north, 0.0, -gravity_up);
    return sample;
}

/// The number that `count` digits at `first` make; -1 if they are none.
int digits_at(std::string_view text, std::size_t first, std::size_t count) {
    int value = -1;
    if (first + count <= text.size()) {
        const char* const end = text.data() + first + count;
        const auto [stop, error] = std::from_chars(text.data() + first, end, value);
        if (error != std::errc{} || stop != end) {
            return -1;
        }
    }
    return value;
}

double parse_time(const ListLine& line, const std::string& where) {
    const auto refuse = [&]() -> InputError {
        return {where, "the line is no time", "a line reads 'YYYY-MM-DD hh:mm:ss.fffffffff'"};
    };
    if (line.fields.size() != 2 || line.fields[0].size() != 10 || line.fields[1].size() < 8) {
        throw refuse();
    }
    const std::string_view date = line.fields[0];
    const std::string_view clock = line.fields[1];
    const int year = digits_at(date, 0, 4);
    const int month = digits_at(date, 5, 2);
    const int day = digits_at(date, 8, 2);
    const int hour = digits_at(clock, 0, 2);
    const int minute = digits_at(clock, 3, 2);
    const double second = parse_number(clock.substr(6), "the second", where);
    if (year < 0 || month < 0 || day < 0 || hour < 0 || hour > 23 || minute < 0 || minute > 59 ||
        second < 0.0 || second >= 61.0) {
        throw refuse();
    }
    const std::chrono::year_month_day calendar_day{std::chrono::year(year),
                                                   std::chrono::month(static_cast<unsigned>(month)),
                                                   std::chrono::day(static_cast<unsigned>(day))};
    if (!calendar_day.ok()) {
        throw refuse();
    }
    const auto minutes = std::chrono::sys_days(calendar_day) + std::chrono::hours(hour) +
                         std::chrono::minutes(minute);
    return static_cast<double>(
               std::chrono::duration_cast<std::chrono::seconds>(minutes.time_since_epoch())
                   .count()) +
           second;
}

} // namespace

std::vector<KittiTime> read_kitti_times(const std::filesystem::path& file) {
    std::vector<KittiTime> times;
    for (const ListLine& line : read_text_list(file)) {
        const std::string where = place_of(file, line.number);
        const double time_s = parse_time(line, where);
        if (!times.empty()) {
            require_later(times.back().time_s, time_s, where);
        }
        times.push_back({time_s, where});
    }
    return times;
}

OxtsLog read_oxts(const std::filesystem::path& folder, std::vector<RecordingWarning>& warnings) {
    const std::filesystem::path list = folder / "oxts" / "timestamps.txt";
    const std::filesystem::path data = folder / "oxts" / "data";
    FrameList rows(list);
    std::size_t index = 0;
    for (const auto& [time_s, where] : read_kitti_times(list)) {
        rows.add(time_s, data / fmt::format("{:010}.txt", index), where);
        ++index;
    }
    OxtsLog log;
    GeographicLib::LocalCartesian local;
    for (const FrameEntry& entry : rows.take(warnings)) {
        const Row row = read_row(entry.file);
        if (log.samples.empty()) {
            log.origin = {row[latitude_deg], row[longitude_deg], row[altitude_m]};
            local.Reset(row[latitude_deg], row[longitude_deg], row[altitude_m]);
        }
        log.samples.push_back(sample_of(entry.time_s, row, local));
    }
    return log;
}

} // namespace zonegrid
