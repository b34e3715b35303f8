#include "map_run.h"
#include "recording_json.h"

#include <cmath>

namespace zonegrid {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json json_of(const CellIndex& cell) {
    return Json::array({cell.x, cell.y, cell.z});
}

Json parameters_of(const MapRun& run) {
    const MapperOptions& options = run.options;
    const RecordingSettings& source = run.settings.source;
    Json json;
    json["cell_m"] = options.cell_m;
    json["range_m"] = options.range_m;
    json["zone_cells"] = options.zone;
    json["model"] = run.settings.model;
    json["span_sigmas"] = options.span_sigmas;
    json["backend"] = options.backend;
    json["hit"] = options.hit;
    json["miss"] = options.miss;
    json["limit"] = options.limit;
    json["threshold"] = options.threshold;
    json["max_gap_s"] = options.max_gap_s;
    json["frames"] = {run.span.first, run.span.last};
    json["cut_height_m"] = or_null(run.settings.cut_height);
    json["layout"] = source.layout;
    json["world_axes"] = source.world_axes;
    json["intrinsics_px"] = or_null(source.intrinsics);
    json["depth_units_per_m"] = or_null(source.depth_scale);
    return json;
}

Json images_of(const ReplaySummary& replay) {
    Json json;
    json["replayed"] = replay.images;
    json["integrated"] = replay.integrated;
    json["without_change"] = replay.images_without_change;
    for (std::size_t reason = 0; reason < skip_reasons; ++reason) {
        json["skipped"][name_of(static_cast<SkipReason>(reason))] = replay.skipped[reason];
    }
    json["skipped_first"] = Json::array();
    for (const SkippedImage& image : replay.skipped_first) {
        json["skipped_first"].push_back(
            {{"file", image.where}, {"reason", name_of(image.reason)}, {"problem", image.problem}});
    }
    return json;
}

/// Milliseconds with three decimals: no clock is better than that.
double in_ms(double seconds) {
    return std::round(seconds * 1e6) / 1e3;
}

Json json_of(const StageTimes& stage) {
    return {{"median", in_ms(stage.percentile_s(0.5))},
            {"p95", in_ms(stage.percentile_s(0.95))},
            {"total", in_ms(stage.total_s())}};
}

double rate_of(const StageTimes& stage) {
    const double total_s = stage.total_s();
    return total_s > 0.0 ? static_cast<double>(stage.seconds.size()) / total_s : 0.0;
}

Json times_of(const MapRun& run) {
    const ReplaySummary& replay = run.replay;
    Json json;
    json["image_ms"] = {
        {"read", json_of(replay.read)},         {"prepare", json_of(replay.prepare)},
        {"window", json_of(replay.window)},     {"integrate", json_of(replay.integrate)},
        {"fuse", json_of(replay.fuse)},         {"map", json_of(replay.map)},
        {"read_and_map", json_of(replay.image)}};
    json["images_per_s"] = {{"map", rate_of(replay.map)}, {"read_and_map", rate_of(replay.image)}};
    json["objects_ms"] = in_ms(run.contents.objects_s);
    json["cells_ms"] = in_ms(run.contents.cells_s);
    json["pictures_ms"] = in_ms(run.contents.pictures_s);
    json["total_ms"] = in_ms(run.total_s);
    return json;
}

Json map_of(const MapRun& run) {
    const MapStatistics& map = run.statistics;
    Json json;
    json["window_first_cell"] = json_of(map.window_first_cell);
    json["window_cells"] = map.window_cells;
    json["zones_held"] = map.zones_held;
    json["zones_held_most"] = map.zones_held_most;
    json["zones_remembered"] = map.zones_remembered;
    json["zones_entered"] = run.replay.zones_entered;
    json["zones_left"] = run.replay.zones_left;
    json["cells_known"] = run.contents.cells_known;
    json["cells_occupied"] = map.cells_occupied;
    json["cells_free"] = map.cells_free;
    json["cells_changed"] = run.replay.cells_changed;
    json["objects"] = run.contents.objects.size();
    json["profile_columns"] = run.contents.profile_columns;
    return json;
}

} // namespace

Json report_of(const MapRun& run) {
    Json json;
    json["zonegrid"] = {{"version", ZONEGRID_VERSION}, {"report", 1}};
    json["recording"] = recording_json(run.recording);
    json["parameters"] = parameters_of(run);
    json["backend"] = backend_json(run.backend);
    json["images"] = images_of(run.replay);
    json["rays"] = {{"stated", run.replay.rays},
                    {"missing", run.replay.missing},
                    {"dropped", run.replay.dropped}};
    json["map"] = map_of(run);
    json["digest"] = {{"cells", run.contents.cells_digest},
                      {"objects", run.contents.objects_digest}};
    json["warnings"] = run.warnings;
    json["time"] = times_of(run);
    json["memory_most_bytes"] = run.memory_most_bytes;
    return json;
}

} // namespace zonegrid
