#include "inspection_report.h"

#include "recording_json.h"

#include <cmath>

namespace zonegrid {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const Spread& spread) {
    return {{"least", number(spread.least)},
            {"median", number(spread.median)},
            {"greatest", number(spread.greatest)}};
}

Json json_of(const TimeSeries& series) {
    return {{"count", series.count},
            {"duration_s", series.duration_s},
            {"rate_hz", series.rate_hz},
            {"greatest_gap_s", series.greatest_gap_s},
            {"greatest_gap_at_s", series.greatest_gap_at_s},
            {"gap_limit_s", series.gap_limit_s},
            {"gaps_above_limit", series.gaps_above_limit}};
}

Json json_of(const SensorPath& path) {
    return {{"frames_with_pose", path.frames_with_pose},
            {"frames_without_navigation", path.frames_without_navigation},
            {"length_m", path.length_m},
            {"greatest_step_m", path.greatest_step_m},
            {"greatest_turn_rad", path.greatest_turn_rad},
            {"greatest_speed_mps", path.greatest_speed_mps},
            {"horizontal_extent_m", path.horizontal_extent_m},
            {"vertical_extent_m", path.vertical_extent_m},
            {"share_looking_steeply", path.share_looking_steeply}};
}

Json json_of(const FrameContents& contents) {
    return {{"read", contents.read},
            {"damaged", contents.damaged},
            {"damaged_first", contents.damaged_first},
            {"pixels", json_of(contents.pixels)},
            {"valid_share", json_of(contents.valid_share)},
            {"infinite_share", json_of(contents.infinite_share)},
            {"depth_m",
             {{"least", number(contents.least_depth_m)},
              {"median", number(contents.median_depth_m)},
              {"greatest", number(contents.greatest_depth_m)}}}};
}

} // namespace

Json inspection_report(const Recording& recording, const RecordingInspection& inspection) {
    Json json;
    json["zonegrid"] = {{"version", ZONEGRID_VERSION}, {"inspection", 1}};
    json["recording"] = recording_json(recording);
    json["frames"] = json_of(inspection.frames);
    json["navigation"] = json_of(inspection.navigation);
    json["navigation"]["not_finite"] = inspection.navigation_not_finite;
    json["path"] = json_of(inspection.path);
    json["contents"] = json_of(inspection.contents);
    json["pose_direction"] = nullptr;
    if (const auto& direction = inspection.pose_direction) {
        json["pose_direction"] = {{"pairs", direction->pairs},
                                  {"points", direction->points},
                                  {"difference_as_stated_m", number(direction->stated_m)},
                                  {"difference_inverted_m", number(direction->inverse_m)}};
    }
    json["warnings"] = inspection.warnings;
    return json;
}

} // namespace zonegrid
