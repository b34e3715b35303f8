#include "evaluation/evaluation_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace zonegrid {
namespace {

constexpr std::size_t most_rows = 40;
constexpr std::size_t widest_name = 22;

std::string percent(const Share& share) {
    const auto value = share.value();
    return value ? fmt::format("{:.1f} %", 100.0 * *value) : "-";
}

std::string row(const std::string& label, const Share& share, std::string_view of) {
    return fmt::format("  {:<36}{:>9}   {} of {} {}\n", label, percent(share), share.count,
                       share.of, of);
}

std::string or_dash(const std::optional<double>& value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    // Rounded here, and 0 added: never "-0.00".
    return value ? fmt::format("{:.{}f}", std::round(*value * scale) / scale + 0.0, decimals) : "-";
}

std::string distance_of(const std::optional<Moment>& moment) {
    return moment ? fmt::format("{:.1f}", moment->distance_m) : "-";
}

std::string seconds_between(const std::optional<Moment>& first,
                            const std::optional<Moment>& second) {
    return first && second ? fmt::format("{:.2f}", second->time_s - first->time_s) : "-";
}

std::string head(const Evaluation& evaluation) {
    return fmt::format(
        "map         {} (cells of {:g} m, range {:g} m, {} model)\n"
        "truth       scene {}, seed {}; seen from {} images, every {}\n",
        evaluation.map, evaluation.cell_m, evaluation.range_m, evaluation.model, evaluation.scene,
        evaluation.seed, evaluation.images, evaluation.every);
}

std::string cell_table(const CellMeasures& cells) {
    std::string text = "\ncells\n";
    for (std::size_t reach = 0; reach < reaches; ++reach) {
        text += row(fmt::format("precision within {} cells", reach), cells.precision[reach],
                    "occupied cells");
    }
    for (std::size_t reach = 0; reach < reaches; ++reach) {
        text += row(fmt::format("recall within {} cells", reach), cells.recall[reach],
                    "visible surface cells");
    }
    text += row("wrong free: visible surface", cells.wrong_free_surface, "visible surface cells");
    text += row("wrong free: inside of things", cells.wrong_free_solid, "free cells");
    text += row("wrong occupied: visible free", cells.wrong_occupied_free, "visible free cells");
    text += row("unknown of the visible free", cells.unknown_free, "visible free cells");
    text += row("unknown of the visible surface", cells.unknown_surface, "visible surface cells");
    return text;
}

std::string objects_of(const ObstacleMeasures& obstacle) {
    std::string text = fmt::format("{}", obstacle.objects);
    text += obstacle.split() ? " split" : "";
    text += obstacle.joined_with_ground ? " ground" : "";
    if (!obstacle.merged_with.empty()) {
        text += fmt::format(" + {}{}", obstacle.merged_with.front(),
                            obstacle.merged_with.size() > 1
                                ? fmt::format(" and {} more", obstacle.merged_with.size() - 1)
                                : "");
        text += obstacle.merged() ? "" : " (touching)";
    }
    return text;
}

/// At most `widest_name` letters of UTF-8.
std::string shortened(const std::string& name) {
    std::size_t letters = 0;
    std::size_t cut = 0; // where the last letter that fits begins
    for (std::size_t i = 0; i < name.size(); ++i) {
        if ((static_cast<unsigned char>(name[i]) & 0xC0U) != 0x80U) { // a letter begins
            cut = ++letters == widest_name ? i : cut;
        }
    }
    return letters > widest_name ? name.substr(0, cut) + "~" : name;
}

std::string obstacle_row(const ObstacleMeasures& obstacle) {
    return fmt::format(
        "  {:<22} {:<5} {:>8} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}  {}\n", shortened(obstacle.name),
        obstacle.judged_with_ground ? "?"
        : obstacle.found            ? "yes"
                                    : "NO",
        percent(obstacle.found_cells), or_dash(obstacle.horizontal_error_m, 2),
        or_dash(obstacle.vertical_error_m, 2), or_dash(obstacle.size_error_m, 2),
        distance_of(obstacle.first_sight), distance_of(obstacle.detection),
        seconds_between(obstacle.first_sight, obstacle.detection), objects_of(obstacle));
}

std::string obstacle_table(const Evaluation& evaluation) {
    const auto found =
        std::ranges::count_if(evaluation.obstacles, [](const auto& one) { return one.found; });
    std::string text = fmt::format(
        "\nobstacles   {} visible, {} found, {} never visible\n"
        "  {:<22} {:<5} {:>8} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}  {}\n"
        "  {:<22} {:<5} {:>8} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}\n",
        evaluation.obstacles.size(), found, evaluation.obstacles_never_visible, "", "found",
        "cells", "aside", "above", "size", "seen", "held", "after", "objects", "", "", "", "m", "m",
        "m", "at m", "from m", "s");
    // Those that were not found are never left out before those that were.
    std::vector<const ObstacleMeasures*> rows;
    for (const auto& obstacle : evaluation.obstacles) {
        rows.push_back(&obstacle);
    }
    if (rows.size() > most_rows) {
        std::ranges::stable_sort(rows, {}, [](const auto* one) { return one->found; });
    }
    for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
        text += obstacle_row(*rows[i]);
    }
    if (rows.size() > most_rows) {
        text += fmt::format("  and {} more in the JSON\n", rows.size() - most_rows);
    }
    return text;
}

std::string moving_table(const Evaluation& evaluation) {
    std::string text;
    for (const auto& moving : evaluation.moving) {
        text += fmt::format(
            "\nmoving      {}: seen at {} m, detected at {} m, {} s after; {} cells "
            "left behind\n",
            moving.name, distance_of(moving.first_sight), distance_of(moving.detection),
            seconds_between(moving.first_sight, moving.detection), moving.trail_cells);
    }
    for (const auto& line : evaluation.lines) {
        text += fmt::format(
            "\nline        {} of kind {}: at most {:.2f} m from one line, in truth "
            "{:.2f} m\n",
            line.members, name_of(line.kind), line.line_error_m, line.true_line_error_m);
        for (const auto& gap : line.gaps) {
            text += fmt::format("  gap       {} - {}: clear over {:.1f} of {:.1f} m, {} free\n",
                                gap.before, gap.after, gap.clear_m, gap.true_m, percent(gap.free));
        }
    }
    return text;
}

std::string notes(const Evaluation& evaluation) {
    std::string text;
    if (!evaluation.has_history) {
        text +=
            "\nThe map has no history: it does not tell when obstacles were detected, and wrong "
            "free and\nunknown cells were counted in the last window only. Make it with "
            "zonegrid map --history.\n";
    }
    if (std::ranges::any_of(evaluation.obstacles,
                            [](const auto& one) { return one.judged_with_ground; })) {
        text +=
            "\n?: the ground touches all of its visible cells, which cannot tell whether it was "
            "found.\n";
    }
    if (evaluation.unplaced_hits > 0) {
        text += fmt::format("\n{} of {} true hits lie beside the cells of their surface.\n",
                            evaluation.unplaced_hits, evaluation.hits);
    }
    return text;
}

} // namespace

std::string text_of(const Evaluation& evaluation) {
    return head(evaluation) + cell_table(evaluation.cells) + obstacle_table(evaluation) +
           moving_table(evaluation) + notes(evaluation);
}

} // namespace zonegrid
