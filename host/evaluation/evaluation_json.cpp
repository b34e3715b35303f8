#include "evaluation/evaluation_json.h"

namespace zonegrid {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Share& share) {
    const auto value = share.value();
    return {{"count", share.count}, {"of", share.of}, {"share", value ? Json(*value) : Json()}};
}

Json json_of(const std::array<Share, reaches>& shares) {
    Json json = Json::array();
    for (std::size_t reach = 0; reach < reaches; ++reach) {
        Json entry{{"within_cells", reach}};
        entry.update(json_of(shares[reach]));
        json.push_back(entry);
    }
    return json;
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

Json or_null(const std::optional<Eigen::Vector3d>& value) {
    return value ? Json::array({value->x(), value->y(), value->z()}) : Json();
}

Json or_null(const std::optional<Moment>& moment) {
    if (!moment) {
        return {};
    }
    return {
        {"image", moment->image}, {"time_s", moment->time_s}, {"distance_m", moment->distance_m}};
}

Json seconds_between(const std::optional<Moment>& first, const std::optional<Moment>& second) {
    return first && second ? Json(second->time_s - first->time_s) : Json();
}

Json json_of(const CellMeasures& cells) {
    Json json;
    json["precision"] = json_of(cells.precision);
    json["recall"] = json_of(cells.recall);
    json["wrong_free_surface"] = json_of(cells.wrong_free_surface);
    json["wrong_free_solid"] = json_of(cells.wrong_free_solid);
    json["wrong_occupied_free"] = json_of(cells.wrong_occupied_free);
    json["unknown_free"] = json_of(cells.unknown_free);
    json["unknown_surface"] = json_of(cells.unknown_surface);
    return json;
}

Json json_of(const ObstacleMeasures& obstacle) {
    Json json;
    json["name"] = obstacle.name;
    json["kind"] = name_of(obstacle.kind);
    json["visible_cells"] = obstacle.visible_cells;
    json["judged_with_ground"] = obstacle.judged_with_ground;
    json["found"] = obstacle.judged_with_ground ? Json() : Json(obstacle.found);
    json["found_cells"] = json_of(obstacle.found_cells);
    json["erased_cells"] = json_of(obstacle.erased_cells);
    json["map_cells"] = obstacle.map_cells;
    json["objects"] = obstacle.objects;
    json["split"] = obstacle.split();
    json["largest_share"] = obstacle.largest_share;
    json["merged"] = obstacle.merged();
    json["merged_with"] = obstacle.merged_with;
    json["touching"] = obstacle.touching;
    json["joined_with_ground"] = obstacle.joined_with_ground;
    json["centre_m"] = or_null(obstacle.centre_m);
    json["true_centre_m"] = or_null(obstacle.true_centre_m);
    json["horizontal_error_m"] = or_null(obstacle.horizontal_error_m);
    json["vertical_error_m"] = or_null(obstacle.vertical_error_m);
    json["size_m"] = or_null(obstacle.size_m);
    json["true_size_m"] = or_null(obstacle.true_size_m);
    json["size_error_m"] = or_null(obstacle.size_error_m);
    json["first_sight"] = or_null(obstacle.first_sight);
    json["detection"] = or_null(obstacle.detection);
    json["sight_to_detection_s"] = seconds_between(obstacle.first_sight, obstacle.detection);
    return json;
}

Json json_of(const MovingMeasures& moving) {
    Json json;
    json["name"] = moving.name;
    json["trail_cells"] = moving.trail_cells;
    json["first_sight"] = or_null(moving.first_sight);
    json["detection"] = or_null(moving.detection);
    json["sight_to_detection_s"] = seconds_between(moving.first_sight, moving.detection);
    return json;
}

Json summary_of(const Evaluation& evaluation) {
    std::size_t found = 0;
    std::size_t split = 0;
    std::size_t merged = 0;
    for (const auto& obstacle : evaluation.obstacles) {
        found += obstacle.found ? 1U : 0U;
        split += obstacle.split() ? 1U : 0U;
        merged += obstacle.merged() ? 1U : 0U;
    }
    return {{"visible", evaluation.obstacles.size()},
            {"never_visible", evaluation.obstacles_never_visible},
            {"found", found},
            {"split", split},
            {"merged", merged}};
}

Json gaps_of(const LineMeasures& line) {
    Json gaps = Json::array();
    for (const auto& gap : line.gaps) {
        gaps.push_back({{"before", gap.before},
                        {"after", gap.after},
                        {"true_m", gap.true_m},
                        {"clear_m", gap.clear_m},
                        {"free", json_of(gap.free)},
                        {"occupied", json_of(gap.occupied)}});
    }
    return gaps;
}

} // namespace

nlohmann::ordered_json json_of(const Evaluation& evaluation) {
    Json json;
    json["evaluation"] = 1;
    json["map"] = {{"folder", evaluation.map},    {"recording", evaluation.recording},
                   {"cell_m", evaluation.cell_m}, {"range_m", evaluation.range_m},
                   {"model", evaluation.model},   {"history", evaluation.has_history}};
    json["truth"] = {{"scene", evaluation.scene}, {"seed", evaluation.seed},
                     {"every", evaluation.every}, {"images", evaluation.images},
                     {"hits", evaluation.hits},   {"unplaced_hits", evaluation.unplaced_hits}};
    json["cells"] = json_of(evaluation.cells);
    json["obstacles"] = summary_of(evaluation);
    json["obstacles"]["each"] = Json::array();
    for (const auto& obstacle : evaluation.obstacles) {
        json["obstacles"]["each"].push_back(json_of(obstacle));
    }
    json["moving"] = Json::array();
    for (const auto& moving : evaluation.moving) {
        json["moving"].push_back(json_of(moving));
    }
    json["lines"] = Json::array();
    for (const auto& line : evaluation.lines) {
        json["lines"].push_back({{"kind", name_of(line.kind)},
                                 {"members", line.members},
                                 {"line_error_m", line.line_error_m},
                                 {"true_line_error_m", line.true_line_error_m},
                                 {"gaps", gaps_of(line)}});
    }
    return json;
}

} // namespace zonegrid
