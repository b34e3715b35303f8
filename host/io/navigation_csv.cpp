#include "io/navigation_csv.h"

#include "io/csv_table.h"
#include "io/navigation_differences.h"
#include "io/pose_conversion.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>

namespace zonegrid {
namespace {

using Triple = std::array<std::size_t, 3>;
using Names = std::array<std::string_view, 3>;

constexpr double rad_per_deg = std::numbers::pi / 180.0;

/// Three columns and the factor that turns them into SI units.
struct ScaledTriple {
    Triple columns;
    double scale;
};

std::optional<ScaledTriple> find_angles(CsvTable& table, const Names& in_rad, const Names& in_deg) {
    if (const std::optional<Triple> columns = table.find_all(in_rad)) {
        return ScaledTriple{*columns, 1.0};
    }
    if (const std::optional<Triple> columns = table.find_all(in_deg)) {
        return ScaledTriple{*columns, rad_per_deg};
    }
    return std::nullopt;
}

/// Which columns hold what.
struct Columns {
    std::size_t time = 0;
    Triple position{};
    std::optional<Triple> velocity;
    std::optional<Triple> acceleration;
    std::optional<ScaledTriple> euler;
    std::optional<std::array<std::size_t, 4>> quaternion;
    std::optional<ScaledTriple> rates;
};

Columns find_columns(CsvTable& table, WorldAxes axes) {
    Columns columns;
    columns.time = table.need("time_s");
    const std::optional<Triple> position = table.find_all(Names{"x_m", "y_m", "z_m"});
    if (position) {
        columns.position = *position;
        columns.velocity = table.find_all(Names{"x_mps", "y_mps", "z_mps"});
        columns.acceleration = table.find_all(Names{"x_mps2", "y_mps2", "z_mps2"});
    } else {
        columns.position = {table.need("north_m"), table.need("east_m"), table.need("down_m")};
        columns.velocity = table.find_all(Names{"north_mps", "east_mps", "down_mps"});
        columns.acceleration = table.find_all(Names{"north_mps2", "east_mps2", "down_mps2"});
    }
    const bool north_east_down = axes == WorldAxes::north_east_down;
    if (!position && !north_east_down) {
        throw InputError(
            table.place_of_header(),
            fmt::format("north_m, east_m, down_m in a world of axes {}", name_of(axes)),
            "name the columns x_m, y_m, z_m or leave out the world axes");
    }
    if (north_east_down) { // roll, pitch and yaw have no agreed meaning in other worlds
        columns.euler = find_angles(table, {"roll_rad", "pitch_rad", "yaw_rad"},
                                    {"roll_deg", "pitch_deg", "yaw_deg"});
    }
    if (!columns.euler) {
        columns.quaternion =
            std::array{table.need("qx"), table.need("qy"), table.need("qz"), table.need("qw")};
    }
    columns.rates = find_angles(table, {"roll_radps", "pitch_radps", "yaw_radps"},
                                {"roll_degps", "pitch_degps", "yaw_degps"});
    table.require_all_read();
    return columns;
}

NavigationSample read_sample(const CsvTable& table, std::size_t row, const Columns& columns,
                             const Eigen::Matrix3d& north_east_down) {
    NavigationSample sample;
    sample.time_s = table.number(row, columns.time);
    sample.position_m = north_east_down * table.vector(row, columns.position);
    if (columns.velocity) {
        sample.velocity_mps = north_east_down * table.vector(row, *columns.velocity);
        if (columns.acceleration) {
            sample.acceleration_mps2 = north_east_down * table.vector(row, *columns.acceleration);
        }
    }
    if (columns.euler) {
        const Eigen::Vector3d euler_rad =
            columns.euler->scale * table.vector(row, columns.euler->columns);
        sample.world_from_body = attitude_from_euler(euler_rad.x(), euler_rad.y(), euler_rad.z());
    } else {
        const auto& [x, y, z, w] = *columns.quaternion;
        sample.world_from_body =
            Eigen::Quaterniond(north_east_down) *
            checked_quaternion(table.number(row, x), table.number(row, y), table.number(row, z),
                               table.number(row, w), table.place(row));
    }
    if (columns.rates) {
        sample.body_rate_radps = columns.rates->scale * table.vector(row, columns.rates->columns);
    }
    return sample;
}

} // namespace

std::vector<NavigationSample> read_navigation_csv(const std::filesystem::path& file,
                                                  WorldAxes axes) {
    CsvTable table(file);
    const Columns columns = find_columns(table, axes);
    const Eigen::Matrix3d north_east_down = north_east_down_from(axes);
    std::vector<NavigationSample> samples;
    samples.reserve(table.row_count());
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        samples.push_back(read_sample(table, row, columns, north_east_down));
        if (row > 0) {
            require_later(samples[row - 1].time_s, samples[row].time_s, table.place(row));
        }
    }
    if (!columns.velocity) {
        derive_velocities(samples);
    }
    if (!columns.rates) {
        derive_body_rates(samples);
    }
    return samples;
}

} // namespace zonegrid
