#include "io/flight_writer.h"

#include "io/npy.h"
#include "io/plain_writer.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <string>
#include <system_error>

namespace zonegrid {
namespace {

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
    const bool table = plan.camera && !plan.camera->directions.empty();
    write_plain_description(folder / "description.toml",
                            {plan.camera, plan.mounting, {}, table ? "frames/rays.npy" : "", {}});
    write_navigation_csv(folder / "navigation.csv", plan.navigation);
    write_frames_csv(folder / "frames.csv", flight.frames());
    for (std::size_t i = 0; i < plan.frames.size(); ++i) {
        write_npy(folder / flight.frames()[i].file, array_of(plan.frames[i], plan.camera));
    }
    if (table) {
        write_npy(folder / flight_frames_name / "rays.npy", table_of(*plan.camera));
    }
}

} // namespace zonegrid
