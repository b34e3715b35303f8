#include "inspection_report.h"
#include "text_lines.h"

#include <numbers>

namespace zonegrid {
namespace {

std::string degrees(double angle_rad) {
    return fmt::format("{:.2f} deg", angle_rad * 180.0 / std::numbers::pi);
}

std::string recording_lines(const Recording& recording) {
    std::string text = labelled("recording", recording.path().string());
    text += labelled("layout", recording.layout());
    if (const auto& camera = recording.camera()) {
        text +=
            labelled("camera",
                     fmt::format("{} x {} pixels, fx {:.2f} fy {:.2f} cx {:.2f} cy "
                                 "{:.2f}{}",
                                 camera->width_px, camera->height_px, camera->fx_px, camera->fy_px,
                                 camera->cx_px, camera->cy_px,
                                 camera->directions.empty() ? "" : ", with a table of directions"));
    } else {
        text += labelled("sensor", "laser scanner");
    }
    if (const auto& origin = recording.origin()) {
        text += labelled(
            "origin", fmt::format("{:.7f} deg latitude, {:.7f} deg longitude, {:.2f} m",
                                  origin->latitude_deg, origin->longitude_deg, origin->altitude_m));
    } else {
        text += labelled("origin", "not given");
    }
    return text;
}

std::string series_line(const char* label, const TimeSeries& series) {
    std::string text = fmt::format("{} over {:.2f} s", series.count, series.duration_s);
    if (series.count > 1) {
        text += fmt::format(
            ", {:.1f} a second; greatest gap {:.3f} s (at {:.3f} s), {} above "
            "{:.3f} s",
            series.rate_hz, series.greatest_gap_s, series.greatest_gap_at_s,
            series.gaps_above_limit, series.gap_limit_s);
    }
    return labelled(label, text);
}

std::string path_lines(const RecordingInspection& found) {
    const SensorPath& path = found.path;
    std::string text =
        labelled("poses", fmt::format("{} images with, {} without navigation; {} "
                                      "samples not finite",
                                      path.frames_with_pose, path.frames_without_navigation,
                                      found.navigation_not_finite));
    text += labelled("path", fmt::format("{:.2f} m long, {:.2f} m wide on the ground, {:.2f} m in "
                                         "height; at most {:.2f} m/s",
                                         path.length_m, path.horizontal_extent_m,
                                         path.vertical_extent_m, path.greatest_speed_mps));
    text += labelled("", fmt::format("greatest step between images {:.3f} m and {}",
                                     path.greatest_step_m, degrees(path.greatest_turn_rad)));
    if (const auto& direction = found.pose_direction) {
        text +=
            labelled("", fmt::format("pairs of images differ by {:.4f} m with the stated poses, "
                                     "by {:.4f} m with inverted ones ({} points)",
                                     direction->stated_m, direction->inverse_m, direction->points));
    } else {
        text += labelled("", "too little motion to tell a pose from its inverse");
    }
    return text;
}

std::string contents_lines(const RecordingInspection& found) {
    const FrameContents& contents = found.contents;
    const Spread& valid = contents.valid_share;
    std::string text = labelled(
        "looked at", fmt::format("{} of {} images, {} damaged", contents.read + contents.damaged,
                                 found.frames.count, contents.damaged));
    for (const std::string& problem : contents.damaged_first) {
        text += labelled("", problem);
    }
    text += labelled("with distance", fmt::format("{:.1f} % of the pixels (median of the images; "
                                                  "{:.1f} to {:.1f} %)",
                                                  100.0 * valid.median, 100.0 * valid.least,
                                                  100.0 * valid.greatest));
    text += labelled("sky", fmt::format("{:.1f} %", 100.0 * contents.infinite_share.median));
    text += labelled("distance",
                     fmt::format("{:.3f} to {:.3f} m, median {:.3f} m", contents.least_depth_m,
                                 contents.greatest_depth_m, contents.median_depth_m));
    return text;
}

} // namespace

std::string inspection_text(const Recording& recording, const RecordingInspection& inspection) {
    std::string text = recording_lines(recording);
    text += series_line("images", inspection.frames);
    text += series_line("navigation", inspection.navigation);
    text += path_lines(inspection) + contents_lines(inspection);
    for (const std::string& note : recording.notes()) {
        text += labelled("note", note);
    }
    for (const RecordingWarning& warning : recording.warnings()) {
        text += labelled("WARNING", warning.where + ": " + warning.problem);
    }
    for (const std::string& warning : inspection.warnings) {
        text += labelled("WARNING", warning);
    }
    return text;
}

} // namespace zonegrid
