#include "recording_json.h"

namespace zonegrid {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Camera& camera) {
    Json json;
    json["width_px"] = camera.width_px;
    json["height_px"] = camera.height_px;
    json["fx_px"] = camera.fx_px;
    json["fy_px"] = camera.fy_px;
    json["cx_px"] = camera.cx_px;
    json["cy_px"] = camera.cy_px;
    json["ideal_pinhole"] = camera.directions.empty();
    json["baseline_m"] = camera.stereo ? Json(camera.stereo->baseline_m) : Json(nullptr);
    json["disparity_sigma_px"] =
        camera.stereo ? Json(camera.stereo->disparity_sigma_px) : Json(nullptr);
    return json;
}

} // namespace

Json recording_json(const Recording& recording) {
    Json json;
    json["path"] = recording.path().string();
    json["layout"] = recording.layout();
    json["frames"] = recording.frames().size();
    json["first_frame_s"] = recording.frames().front().time_s;
    json["last_frame_s"] = recording.frames().back().time_s;
    json["navigation_samples"] = recording.navigation().size();
    json["camera"] = recording.camera() ? json_of(*recording.camera()) : Json(nullptr);
    json["origin"] = nullptr;
    if (const auto& origin = recording.origin()) {
        json["origin"] = {{"latitude_deg", origin->latitude_deg},
                          {"longitude_deg", origin->longitude_deg},
                          {"altitude_m", origin->altitude_m}};
    }
    const auto& truth = recording.truth_digest();
    json["truth_digest"] = truth ? Json(*truth) : Json(nullptr);
    json["warnings"] = Json::array();
    for (const RecordingWarning& warning : recording.warnings()) {
        json["warnings"].push_back({{"where", warning.where}, {"problem", warning.problem}});
    }
    json["notes"] = recording.notes();
    return json;
}

} // namespace zonegrid
