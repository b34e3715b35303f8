#include "evaluation/evaluation_pictures.h"

#include "io/profile_picture_canvas.h"
#include "io/profile_picture_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zonegrid {
namespace {

constexpr int width_px = 1400;
constexpr int height_px = 760;
constexpr std::size_t most_named = 24;
constexpr Rgb precision_colour{30, 100, 200};
constexpr Rgb recall_colour{215, 90, 20};
constexpr double dot_px = 5.0;

/// A rectangle with a scale on either axis.
struct Panel {
    double left_px;
    double top_px;
    double right_px;
    double bottom_px;
    double x_low;
    double x_high;

    [[nodiscard]] double x(double value) const {
        return left_px + (value - x_low) / (x_high - x_low) * (right_px - left_px);
    }
    /// `share` from 0 at the bottom to 1 at the top.
    [[nodiscard]] double y(double share) const { return bottom_px - share * (bottom_px - top_px); }
};

const TextStyle small{13, Align::centre, false, ink_colour};

void draw_dot(Canvas& canvas, double x_px, double y_px, Rgb colour, bool filled) {
    canvas.set_colour(colour);
    cairo_set_line_width(canvas.cairo(), 2.0);
    cairo_new_path(canvas.cairo());
    cairo_arc(canvas.cairo(), x_px, y_px, dot_px, 0.0, 6.2831853);
    filled ? cairo_fill(canvas.cairo()) : cairo_stroke(canvas.cairo());
}

void draw_frame(Canvas& canvas, const Panel& panel, const char* title, const char* x_label) {
    canvas.draw_text(panel.left_px, panel.top_px - 22, title, {17, Align::left, true, ink_colour});
    canvas.set_colour(ink_colour);
    cairo_set_line_width(canvas.cairo(), 1.0);
    cairo_rectangle(canvas.cairo(), panel.left_px - 0.5, panel.top_px - 0.5,
                    panel.right_px - panel.left_px + 1, panel.bottom_px - panel.top_px + 1);
    cairo_stroke(canvas.cairo());
    canvas.draw_text(0.5 * (panel.left_px + panel.right_px), panel.bottom_px + 44, x_label, small);
}

void draw_x_ticks(Canvas& canvas, const Panel& panel, double step) {
    for (double value = std::ceil(panel.x_low / step) * step; value <= panel.x_high + 1e-9;
         value += step) {
        const double x_px = panel.x(value);
        canvas.stroke_line(x_px, panel.top_px, x_px, panel.bottom_px, 1.0, grid_colour);
        canvas.draw_text(x_px, panel.bottom_px + 20, number_text(value, step), small);
    }
}

void draw_shares(Canvas& canvas, const Panel& panel, const std::array<Share, reaches>& shares,
                 Rgb colour, const char* name, double label_share) {
    double last_x_px = 0.0;
    double last_y_px = 0.0;
    bool pen_down = false;
    for (std::size_t reach = 0; reach < reaches; ++reach) {
        const auto share = shares[reach].value();
        if (!share) {
            continue;
        }
        const double x_px = panel.x(static_cast<double>(reach));
        const double y_px = panel.y(*share);
        if (pen_down) {
            canvas.stroke_line(last_x_px, last_y_px, x_px, y_px, 2.5, colour);
        }
        draw_dot(canvas, x_px, y_px, colour, true);
        last_x_px = x_px;
        last_y_px = y_px;
        pen_down = true;
    }
    const double x_px = panel.right_px - 130;
    draw_dot(canvas, x_px, panel.y(label_share), colour, true);
    canvas.draw_text(x_px + 14, panel.y(label_share) + 5, name, {14, Align::left, false, colour});
}

void draw_precision_and_recall(Canvas& canvas, const CellMeasures& cells) {
    const Panel panel{80, 100, 520, height_px - 80, -0.2, 2.2};
    draw_x_ticks(canvas, panel, 1.0);
    for (int tenth = 0; tenth <= 10; tenth += 2) {
        const double y_px = panel.y(0.1 * tenth);
        canvas.stroke_line(panel.left_px, y_px, panel.right_px, y_px, 1.0, grid_colour);
        canvas.draw_text(panel.left_px - 8, y_px + 5, fmt::format("{} %", 10 * tenth),
                         {13, Align::right, false, ink_colour});
    }
    draw_frame(canvas, panel, "occupied cells", "distance at which cells are compared [cells]");
    draw_shares(canvas, panel, cells.precision, precision_colour, "precision", 0.12);
    draw_shares(canvas, panel, cells.recall, recall_colour, "recall", 0.06);
}

/// The obstacles that came into sight while the vehicle flew, farthest first.
std::vector<const ObstacleMeasures*> approached(const Evaluation& evaluation) {
    std::vector<const ObstacleMeasures*> rows;
    for (const auto& obstacle : evaluation.obstacles) {
        if (obstacle.kind != ObstacleKind::ground && obstacle.first_sight) {
            rows.push_back(&obstacle);
        }
    }
    std::ranges::stable_sort(rows, std::ranges::greater(), [](const auto* obstacle) {
        return obstacle->detection ? obstacle->detection->distance_m : -1.0;
    });
    return rows;
}

void draw_detections(Canvas& canvas, const Evaluation& evaluation) {
    const auto rows = approached(evaluation);
    const bool named = rows.size() <= most_named;
    const Panel panel{named ? 760.0 : 620.0, 100, width_px - 40,
                      height_px - 80,        0.0, 1.1 * evaluation.range_m};
    draw_x_ticks(canvas, panel, round_step(panel.x_high, 10));
    draw_frame(canvas, panel,
               evaluation.has_history ? "first sight (ring) and detection that lasts (dot)"
                                      : "first sight (ring); detections need a map with --history",
               "distance from the vehicle [m]");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ObstacleMeasures& obstacle = *rows[i];
        const double y_px =
            panel.y(1.0 - (static_cast<double>(i) + 0.5) / static_cast<double>(rows.size()));
        const auto within = [&panel](double distance_m) {
            return std::min(panel.x(distance_m), panel.right_px);
        };
        const double seen_px = within(obstacle.first_sight->distance_m);
        if (obstacle.detection) {
            const double held_px = within(obstacle.detection->distance_m);
            canvas.stroke_line(seen_px, y_px, held_px, y_px, 1.5, quiet_colour);
            draw_dot(canvas, held_px, y_px, precision_colour, true);
        }
        draw_dot(canvas, seen_px, y_px, recall_colour, false);
        if (named) {
            const TextStyle style{13, Align::right, false, ink_colour};
            canvas.draw_text(panel.left_px - 8, y_px + 5,
                             canvas.fitting_text(obstacle.name, style, 200), style);
        }
    }
}

} // namespace

void draw_measures(const Evaluation& evaluation, const std::filesystem::path& file) {
    Canvas canvas(width_px, height_px);
    canvas.draw_text(20, 28,
                     fmt::format("{}: cell {:g} m, range {:g} m, {} model", evaluation.scene,
                                 evaluation.cell_m, evaluation.range_m, evaluation.model),
                     {15, Align::left, false, quiet_colour});
    draw_precision_and_recall(canvas, evaluation.cells);
    draw_detections(canvas, evaluation);
    canvas.write_png(file);
}

} // namespace zonegrid
