#include "io/plain_description.h"

#include "io/description_table.h"
#include "io/hexadecimal.h"
#include "io/plain_camera.h"
#include "io/pose_conversion.h"
#include "io/sha256.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace zonegrid {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;

toml::table parse_description(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw InputError(file.string(), "there is no such file",
                         "describe the sensor there; docs/formats.md has a complete example");
    }
    try {
        return toml::parse_file(file.string());
    } catch (const toml::parse_error& problem) {
        throw InputError(place_of(file, problem.source().begin.line),
                         std::string(problem.description()), "correct the TOML");
    }
}

/// Turns a sensor that looks forward by its mounting in the body: position, then roll, pitch, yaw.
Eigen::Isometry3d read_mounting(DescriptionTable& root, const Eigen::Matrix3d& body_from_forward) {
    Eigen::Isometry3d mounting = Eigen::Isometry3d::Identity();
    std::optional<DescriptionTable> table = root.table("mounting");
    if (table) {
        if (const std::optional<std::vector<double>> position = table->numbers("position_m")) {
            const auto finite = [](double value) { return std::isfinite(value); };
            if (position->size() != 3 || !std::ranges::all_of(*position, finite)) {
                table->refuse("position_m", "is no position", "give [forward, right, down] in m");
            }
            mounting.translation() = Eigen::Vector3d(position->data());
        }
        const double roll_deg = table->number("roll_deg").value_or(0.0);
        const double pitch_deg = table->number("pitch_deg").value_or(0.0);
        const double yaw_deg = table->number("yaw_deg").value_or(0.0);
        table->require_all_read();
        mounting.linear() = mounted_rotation(roll_deg, pitch_deg, yaw_deg, body_from_forward);
        return mounting;
    }
    mounting.linear() = body_from_forward;
    return mounting;
}

std::vector<float> as_floats(const std::vector<double>& values) {
    std::vector<float> floats(values.size());
    std::ranges::transform(values, floats.begin(),
                           [](double value) { return static_cast<float>(value); });
    return floats;
}

void read_depth(DescriptionTable& root, PlainDescription& description) {
    std::optional<DescriptionTable> table = root.table("depth");
    if (!table) {
        return;
    }
    DepthCoding& coding = description.coding;
    if (const std::optional<double> scale = table->number("units_per_m")) {
        if (!is_depth_scale(*scale)) {
            table->refuse("units_per_m", fmt::format("is {}", *scale),
                          "give the value that stands for 1 m, from 0.001 to 1e6");
        }
        coding.units_per_m = *scale;
        description.depth_scale_given = true;
    }
    const std::string kind = table->text("kind").value_or("axis");
    if (kind != "axis" && kind != "ray") {
        table->refuse("kind", fmt::format("is '{}'", kind), R"(give "axis" or "ray")");
    }
    coding.kind = kind == "ray" ? DepthKind::ray : DepthKind::axis;
    if (const std::optional<std::vector<double>> values = table->numbers("missing")) {
        coding.missing = as_floats(*values);
    }
    if (const std::optional<std::vector<double>> values = table->numbers("infinite")) {
        coding.infinite = as_floats(*values);
    }
    table->require_all_read();
}

void read_stereo(DescriptionTable& root, Camera& camera) {
    if (std::optional<DescriptionTable> table = root.table("stereo")) {
        camera.stereo = StereoNoise{table->positive_number("baseline_m"),
                                    table->positive_number("disparity_sigma_px")};
        table->require_all_read();
    }
}

WorldAxes read_axes(DescriptionTable& table) {
    constexpr std::array choices{WorldAxes::north_east_down, WorldAxes::east_north_up,
                                 WorldAxes::z_up, WorldAxes::y_down};
    const std::string name = table.text("axes").value_or(name_of(WorldAxes::north_east_down));
    const auto found = std::ranges::find(choices, name, name_of);
    if (found == choices.end()) {
        table.refuse("axes", fmt::format("is '{}'", name),
                     R"(give "north_east_down", "east_north_up", "z_up" or "y_down")");
    }
    return *found;
}

void read_world(DescriptionTable& root, PlainDescription& description) {
    std::optional<DescriptionTable> table = root.table("world");
    if (!table) {
        return;
    }
    description.world_axes = read_axes(*table);
    const std::optional<double> latitude_deg = table->number("latitude_deg");
    const std::optional<double> longitude_deg = table->number("longitude_deg");
    const std::optional<double> altitude_m = table->number("altitude_m");
    if (latitude_deg || longitude_deg || altitude_m) {
        description.origin =
            GeoOrigin{table->needed_number("latitude_deg"), table->needed_number("longitude_deg"),
                      table->needed_number("altitude_m")};
        if (std::abs(description.origin->latitude_deg) > 90.0) {
            table->refuse("latitude_deg", fmt::format("is {}", *latitude_deg),
                          "give degrees from -90 to 90");
        }
        if (std::abs(description.origin->longitude_deg) > 360.0) {
            table->refuse("longitude_deg", fmt::format("is {}", *longitude_deg),
                          "give degrees from -180 to 180");
        }
    }
    table->require_all_read();
}

void read_truth_digest(DescriptionTable& root, PlainDescription& description) {
    std::optional<DescriptionTable> table = root.table("truth");
    if (!table) {
        return;
    }
    const std::string digest = table->needed_text("digest");
    const auto bytes = from_hexadecimal(digest);
    if (!bytes || bytes->size() != Sha256::size_bytes) {
        table->refuse("digest", fmt::format("is '{}'", digest),
                      "give the 64 lower-case hexadecimal digits of a SHA-256");
    }
    description.truth_digest = digest;
    table->require_all_read();
}

} // namespace

Eigen::Matrix3d mounted_rotation(double roll_deg, double pitch_deg, double yaw_deg,
                                 const Eigen::Matrix3d& body_from_forward) {
    return attitude_from_euler(roll_deg * rad_per_deg, pitch_deg * rad_per_deg,
                               yaw_deg * rad_per_deg)
               .toRotationMatrix() *
           body_from_forward;
}

PlainDescription read_plain_description(const std::filesystem::path& file) {
    const toml::table parsed = parse_description(file);
    DescriptionTable root(parsed, file, "");
    PlainDescription description;
    std::optional<DescriptionTable> camera = root.table("camera");
    std::optional<DescriptionTable> scanner = root.table("scanner");
    if (camera.has_value() == scanner.has_value()) {
        throw InputError(file.string(),
                         camera ? "there is both a [camera] and a [scanner]"
                                : "there is neither a [camera] nor a [scanner]",
                         "describe exactly one of them");
    }
    if (camera) {
        description.camera = read_plain_camera(*camera, file.parent_path());
        read_depth(root, description);
        read_stereo(root, *description.camera);
        description.camera->body_from_camera = read_mounting(root, body_from_forward_camera());
    } else {
        scanner->require_all_read();
        description.body_from_sensor = read_mounting(root, body_from_forward_left_up());
    }
    read_world(root, description);
    read_truth_digest(root, description);
    root.require_all_read();
    return description;
}

} // namespace zonegrid
