#include "truth/truth_folder.h"

#include "io/file_bytes.h"
#include "io/output_file.h"
#include "io/sha256.h"
#include "truth/surfaces_ply.h"
#include "truth/truth_tables.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <system_error>

namespace zonegrid {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format_version = 1;
constexpr const char* remedy = "simulate the scene again";

/// How many lines each table holds: a table cut between two lines must not pass.
struct Counts {
    std::size_t navigation = 0;
    std::size_t images = 0;
    std::size_t motion_poses = 0;
};

Counts counts_of(const Truth& truth) {
    Counts counts{truth.navigation.size(), truth.images.size(), 0};
    for (const ObstacleMotion& motion : truth.motions) {
        counts.motion_poses += motion.poses.size();
    }
    return counts;
}

Json json_of(const Camera& camera) {
    const Eigen::Isometry3d& mounting = camera.body_from_camera;
    Json json{{"width_px", camera.width_px}, {"height_px", camera.height_px},
              {"fx_px", camera.fx_px},       {"fy_px", camera.fy_px},
              {"cx_px", camera.cx_px},       {"cy_px", camera.cy_px}};
    json["baseline_m"] = camera.stereo ? Json(camera.stereo->baseline_m) : Json();
    json["disparity_sigma_px"] = camera.stereo ? Json(camera.stereo->disparity_sigma_px) : Json();
    json["position_m"] = {mounting(0, 3), mounting(1, 3), mounting(2, 3)};
    json["body_from_camera"] = Json::array();
    for (int row = 0; row < 3; ++row) {
        json["body_from_camera"].push_back({mounting(row, 0), mounting(row, 1), mounting(row, 2)});
    }
    return json;
}

Json json_of(const TrueObstacle& obstacle) {
    return {{"name", obstacle.name},
            {"kind", name_of(obstacle.kind)},
            {"first_triangle", obstacle.first_triangle},
            {"triangles", obstacle.triangles},
            {"moving", obstacle.moving}};
}

Camera camera_of(const Json& json) {
    Camera camera;
    camera.width_px = json.at("width_px").get<int>();
    camera.height_px = json.at("height_px").get<int>();
    camera.fx_px = json.at("fx_px").get<double>();
    camera.fy_px = json.at("fy_px").get<double>();
    camera.cx_px = json.at("cx_px").get<double>();
    camera.cy_px = json.at("cy_px").get<double>();
    if (camera.width_px < 1 || camera.height_px < 1 || !(camera.fx_px > 0.0) ||
        !(camera.fy_px > 0.0)) {
        throw std::invalid_argument("the camera's size or focal length is not above 0");
    }
    if (!json.at("baseline_m").is_null()) {
        camera.stereo = StereoNoise{json.at("baseline_m").get<double>(),
                                    json.at("disparity_sigma_px").get<double>()};
    }
    const auto position = json.at("position_m").get<std::array<double, 3>>();
    const auto rotation = json.at("body_from_camera").get<std::array<std::array<double, 3>, 3>>();
    camera.body_from_camera.translation() = Eigen::Vector3d(position.data());
    for (int row = 0; row < 3; ++row) {
        const auto& values = rotation.at(static_cast<std::size_t>(row));
        camera.body_from_camera.linear().row(row) = Eigen::RowVector3d(values.data());
    }
    if (!is_rotation(camera.body_from_camera.linear())) {
        throw std::invalid_argument("body_from_camera is no rotation");
    }
    return camera;
}

ObstacleKind kind_of(const std::string& name) {
    constexpr std::array kinds{ObstacleKind::ground,   ObstacleKind::tree, ObstacleKind::bush,
                               ObstacleKind::building, ObstacleKind::wire, ObstacleKind::mast,
                               ObstacleKind::aircraft, ObstacleKind::other};
    for (const ObstacleKind kind : kinds) {
        if (name_of(kind) == name) {
            return kind;
        }
    }
    throw std::invalid_argument(fmt::format("an obstacle is a '{}'", name));
}

TrueObstacle obstacle_of(const Json& json) {
    return {json.at("name").get<std::string>(), kind_of(json.at("kind").get<std::string>()),
            json.at("first_triangle").get<std::uint32_t>(),
            json.at("triangles").get<std::uint32_t>(), json.at("moving").get<bool>()};
}

void write_json(const std::filesystem::path& file, const Truth& truth) {
    const Counts counts = counts_of(truth);
    Json json{{"version", format_version},
              {"scene", truth.scene},
              {"seed", truth.seed},
              {"navigation_samples", counts.navigation},
              {"images", counts.images},
              {"motion_poses", counts.motion_poses},
              {"camera", json_of(truth.camera)},
              {"obstacles", Json::array()}};
    for (const TrueObstacle& obstacle : truth.surfaces.obstacles) {
        json["obstacles"].push_back(json_of(obstacle));
    }
    OutputFile output(file);
    output.write(json.dump(1) + "\n");
    output.close();
}

/// Reads truth.json into `truth`, its obstacles into `truth.surfaces`.
Counts read_json(const std::filesystem::path& file, Truth& truth) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    try {
        const Json json = Json::parse(bytes);
        if (json.at("version") != format_version) {
            throw std::invalid_argument(fmt::format("version {}", json.at("version").dump()));
        }
        truth.scene = json.at("scene").get<std::string>();
        truth.seed = json.at("seed").get<std::uint64_t>();
        truth.camera = camera_of(json.at("camera"));
        for (const Json& obstacle : json.at("obstacles")) {
            truth.surfaces.obstacles.push_back(obstacle_of(obstacle));
        }
        return {json.at("navigation_samples").get<std::size_t>(),
                json.at("images").get<std::size_t>(), json.at("motion_poses").get<std::size_t>()};
    } catch (const std::exception& error) {
        throw InputError(file.string(), fmt::format("the truth is damaged ({})", error.what()),
                         remedy);
    }
}

/// Throws unless the table `file` has as many lines as truth.json says. A table without lines is
/// not written.
bool table_is_there(const std::filesystem::path& file, std::size_t lines) {
    std::error_code error;
    if (lines == 0 && std::filesystem::exists(file, error)) {
        throw InputError(file.string(), "truth.json says that there is none", remedy);
    }
    return lines > 0;
}

void require_lines(const std::filesystem::path& file, std::size_t lines, std::size_t wanted) {
    if (lines != wanted) {
        throw InputError(
            file.string(),
            fmt::format("{} lines below the header where truth.json says {}", lines, wanted),
            remedy);
    }
}

void require_motions(const std::filesystem::path& folder, const Truth& truth) {
    std::size_t moving = 0;
    for (const TrueObstacle& obstacle : truth.surfaces.obstacles) {
        moving += obstacle.moving ? 1 : 0;
    }
    // read_motions has seen to it that each is the motion of another obstacle that moves.
    if (moving != truth.motions.size()) {
        throw InputError((folder / "motions.csv").string(),
                         fmt::format("{} obstacles move, but there are motions of {}", moving,
                                     truth.motions.size()),
                         remedy);
    }
}

} // namespace

void write_truth(const std::filesystem::path& folder, const Truth& truth) {
    if (!truth.camera.directions.empty()) {
        throw UsageError("the camera of a truth must be an ideal pinhole without directions");
    }
    check_surfaces(truth.surfaces, (folder / "surfaces.ply").string());
    write_json(folder / "truth.json", truth);
    write_surfaces_ply(folder / "surfaces.ply", truth.surfaces);
    if (!truth.navigation.empty()) {
        write_true_navigation(folder / "navigation.csv", truth.navigation);
    }
    if (!truth.images.empty()) {
        write_true_images(folder / "images.csv", truth.images);
    }
    if (!truth.motions.empty()) {
        write_motions(folder / "motions.csv", truth.motions);
    }
}

Truth read_truth(const std::filesystem::path& folder) {
    Truth truth;
    const Counts counts = read_json(folder / "truth.json", truth);
    std::vector<TrueObstacle> obstacles = std::move(truth.surfaces.obstacles);
    truth.surfaces = read_surfaces_ply(folder / "surfaces.ply");
    truth.surfaces.obstacles = std::move(obstacles);
    check_surfaces(truth.surfaces, (folder / "surfaces.ply").string());
    if (table_is_there(folder / "navigation.csv", counts.navigation)) {
        truth.navigation = read_true_navigation(folder / "navigation.csv");
    }
    if (table_is_there(folder / "images.csv", counts.images)) {
        truth.images = read_true_images(folder / "images.csv");
    }
    if (table_is_there(folder / "motions.csv", counts.motion_poses)) {
        truth.motions = read_motions(folder / "motions.csv", truth.surfaces.obstacles);
    }
    const Counts read = counts_of(truth);
    require_lines(folder / "navigation.csv", read.navigation, counts.navigation);
    require_lines(folder / "images.csv", read.images, counts.images);
    require_lines(folder / "motions.csv", read.motion_poses, counts.motion_poses);
    require_motions(folder, truth);
    return truth;
}

std::string digest_of_truth(const std::filesystem::path& folder) {
    Sha256 digest;
    for (const char* name :
         {"truth.json", "surfaces.ply", "navigation.csv", "images.csv", "motions.csv"}) {
        std::error_code error;
        // Tables without lines are left out. No other truth has the same bytes in a row:
        // truth.json and the header of surfaces.ply say how much of each follows.
        if (std::filesystem::exists(folder / name, error)) {
            digest.add(read_file_bytes(folder / name));
        }
    }
    return digest.finish_hex();
}

} // namespace zonegrid
