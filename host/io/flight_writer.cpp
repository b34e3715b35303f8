#include "io/flight_writer.h"

#include "io/npy.h"
#include "io/output_file.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <string>
#include <system_error>

namespace zonegrid {
namespace {

void write_text(const std::filesystem::path& file, const std::string& text) {
    OutputFile output(file);
    output.write(text);
    output.close();
}

/// The shortest decimal number that is read back as the same double.
std::string number_text(double value) {
    const std::string text = fmt::format("{}", value);
    // TOML takes a number without a point for a whole one, of at most 64 bits.
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string list_text(const Eigen::Vector3d& values) {
    return fmt::format("{}, {}, {}", number_text(values.x()), number_text(values.y()),
                       number_text(values.z()));
}

std::string csv_text(const Eigen::Vector3d& values) {
    return fmt::format(",{},{},{}", values.x(), values.y(), values.z());
}

std::string camera_text(const Camera& camera) {
    std::string text =
        fmt::format("[camera]\nwidth_px = {}\nheight_px = {}\n", camera.width_px, camera.height_px);
    if (camera.directions.empty()) {
        text += fmt::format("model = \"pinhole\"\nfx_px = {}\nfy_px = {}\ncx_px = {}\ncy_px = {}\n",
                            number_text(camera.fx_px), number_text(camera.fy_px),
                            number_text(camera.cx_px), number_text(camera.cy_px));
    } else {
        text += "model = \"table\"\ntable = \"frames/rays.npy\"\n";
    }
    if (camera.stereo) {
        text += fmt::format("\n[stereo]\nbaseline_m = {}\ndisparity_sigma_px = {}\n",
                            number_text(camera.stereo->baseline_m),
                            number_text(camera.stereo->disparity_sigma_px));
    }
    return text;
}

std::string description_text(const FlightPlan& plan) {
    const Eigen::Vector3d& angles_deg = plan.mounting.roll_pitch_yaw_deg;
    return (plan.camera ? camera_text(*plan.camera) : std::string("[scanner]\n")) +
           fmt::format(
               "\n[mounting]\nposition_m = [{}]\nroll_deg = {}\npitch_deg = {}\nyaw_deg = "
               "{}\n",
               list_text(plan.mounting.position_m), number_text(angles_deg.x()),
               number_text(angles_deg.y()), number_text(angles_deg.z()));
}

std::string navigation_text(const FlightPlan& plan) {
    std::string text =
        "time_s,north_m,east_m,down_m,roll_rad,pitch_rad,yaw_rad,north_mps,east_mps,down_mps,"
        "north_mps2,east_mps2,down_mps2,roll_radps,pitch_radps,yaw_radps\n";
    for (const GeneratedSample& generated : plan.navigation) {
        const NavigationSample& sample = generated.sample;
        text += fmt::format("{}", sample.time_s);
        for (const Eigen::Vector3d& values :
             {sample.position_m, generated.roll_pitch_yaw_rad, sample.velocity_mps,
              sample.acceleration_mps2, sample.body_rate_radps}) {
            text += csv_text(values);
        }
        text += "\n";
    }
    return text;
}

NpyArray array_of(const FrameData& frame, const std::optional<Camera>& camera) {
    NpyArray array;
    if (camera) {
        array.shape = {static_cast<std::size_t>(camera->height_px),
                       static_cast<std::size_t>(camera->width_px)};
        array.values = frame.depth_m;
        return array;
    }
    array.shape = {frame.ends_m.size(), 3};
    for (const Eigen::Vector3f& end : frame.ends_m) {
        array.values.insert(array.values.end(), {end.x(), end.y(), end.z()});
    }
    return array;
}

NpyArray table_of(const Camera& camera) {
    NpyArray array{
        {static_cast<std::size_t>(camera.height_px), static_cast<std::size_t>(camera.width_px), 2},
        {}};
    for (const Eigen::Vector2f& slope : camera.directions) {
        array.values.insert(array.values.end(), {slope.x(), slope.y()});
    }
    return array;
}

} // namespace

void write_flight(const std::filesystem::path& folder, const GeneratedFlight& flight) {
    const FlightPlan& plan = flight.plan();
    std::error_code error;
    std::filesystem::create_directory(folder / flight_frames_name, error);
    if (error) {
        throw OutputError(
            fmt::format("{}: the folder cannot be made ({}); check permissions and "
                        "space",
                        (folder / flight_frames_name).string(), error.message()));
    }
    write_text(folder / "description.toml", description_text(plan));
    write_text(folder / "navigation.csv", navigation_text(plan));
    std::string frames = "time_s,file\n";
    for (std::size_t i = 0; i < plan.frames.size(); ++i) {
        const FrameEntry& entry = flight.frames()[i];
        frames += fmt::format("{},{}\n", entry.time_s, entry.file.string());
        write_npy(folder / entry.file, array_of(plan.frames[i], plan.camera));
    }
    write_text(folder / "frames.csv", frames);
    if (plan.camera && !plan.camera->directions.empty()) {
        write_npy(folder / flight_frames_name / "rays.npy", table_of(*plan.camera));
    }
}

} // namespace zonegrid
