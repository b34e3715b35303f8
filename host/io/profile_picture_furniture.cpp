#include "io/profile_picture_furniture.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

constexpr double full_turn_rad = 6.283185307179586;

void fill_and_outline(Canvas& canvas, Rgb fill) {
    canvas.set_colour(fill);
    cairo_fill_preserve(canvas.cairo());
    canvas.set_colour(paper_colour);
    cairo_set_line_width(canvas.cairo(), 3.5 * canvas.unit());
    cairo_stroke_preserve(canvas.cairo());
    canvas.set_colour(path_colour);
    cairo_set_line_width(canvas.cairo(), 1.5 * canvas.unit());
    cairo_stroke(canvas.cairo());
}

void fill_triangle(Canvas& canvas, double left_px, double right_px, double base_px, double tip_px,
                   Rgb colour) {
    canvas.set_colour(colour);
    cairo_move_to(canvas.cairo(), left_px, base_px);
    cairo_line_to(canvas.cairo(), right_px, base_px);
    cairo_line_to(canvas.cairo(), 0.5 * (left_px + right_px), tip_px);
    cairo_close_path(canvas.cairo());
    cairo_fill(canvas.cairo());
}

} // namespace

void draw_header(Canvas& canvas, const PictureFrame& frame, const ProfilePictureOptions& options,
                 const std::string& note) {
    const double unit = canvas.unit();
    const TextStyle title{22 * unit, Align::left, true, ink_colour};
    const TextStyle subtitle{14 * unit, Align::left, false, quiet_colour};
    const TextStyle note_style{13 * unit, Align::right, false, ink_colour};
    const double note_width_px =
        note.empty() ? 0.0 : canvas.text_width_px(note, note_style) + 24 * unit;
    const double right_px = canvas.width_px() - 16 * unit;
    canvas.draw_text(frame.left_px, 36 * unit,
                     canvas.fitting_text(options.title, title, right_px - frame.left_px), title);
    canvas.draw_text(
        frame.left_px, 62 * unit,
        canvas.fitting_text(options.subtitle, subtitle, right_px - frame.left_px - note_width_px),
        subtitle);
    canvas.draw_text(right_px, 62 * unit, note, note_style);
}

void draw_colour_bar(Canvas& canvas, const PictureFrame& frame, const HeightRange& range) {
    const double unit = canvas.unit();
    const double tip_px = 18 * unit;
    const double left_px = std::round(frame.right_px() + 22 * unit);
    const double right_px = left_px + std::round(20 * unit);
    const double top_px = std::round(frame.top_px + tip_px);
    const double bottom_px = std::round(frame.bottom_px() - tip_px);
    const auto y_px = [&](double height_m) {
        return bottom_px -
               (height_m - range.low_m) / (range.high_m - range.low_m) * (bottom_px - top_px);
    };
    const int rows = static_cast<int>(bottom_px - top_px);
    for (int row = 0; row < rows; ++row) {
        canvas.fill_rectangle(left_px, bottom_px - row - 1, right_px - left_px, 1,
                              height_colour((row + 0.5) / rows));
    }
    const TextStyle beyond{11 * unit, Align::left, false, quiet_colour};
    if (range.some_above) {
        fill_triangle(canvas, left_px, right_px, top_px, top_px - tip_px, height_colour(1.0));
        canvas.draw_text(right_px + 2 * unit, top_px - 9 * unit, "higher", beyond);
    }
    if (range.some_below) {
        fill_triangle(canvas, left_px, right_px, bottom_px, bottom_px + tip_px, height_colour(0.0));
        canvas.draw_text(right_px + 2 * unit, bottom_px + 17 * unit, "lower", beyond);
    }
    const double step_m = round_step(range.high_m - range.low_m, 10);
    const TextStyle style{13 * unit, Align::left, false, ink_colour};
    for (double tick_m = std::ceil(range.low_m / step_m - 1e-6) * step_m;
         tick_m <= range.high_m + 1e-6 * step_m; tick_m += step_m) {
        canvas.stroke_line(right_px, y_px(tick_m), right_px + 5 * unit, y_px(tick_m), unit,
                           ink_colour);
        canvas.draw_text(right_px + 8 * unit, y_px(tick_m) + 4.5 * unit,
                         number_text(tick_m, step_m), style);
    }
    canvas.draw_text_upwards(canvas.width_px() - 12 * unit, 0.5 * (top_px + bottom_px),
                             "height [m]", {14 * unit, Align::centre, false, ink_colour});
}

void draw_start_marker(Canvas& canvas, double x_px, double y_px) {
    cairo_new_path(canvas.cairo());
    cairo_arc(canvas.cairo(), x_px, y_px, 6.5 * canvas.unit(), 0.0, full_turn_rad);
    cairo_close_path(canvas.cairo());
    fill_and_outline(canvas, start_colour);
}

void draw_end_marker(Canvas& canvas, double x_px, double y_px) {
    const double half_px = 6 * canvas.unit();
    cairo_new_path(canvas.cairo());
    cairo_rectangle(canvas.cairo(), x_px - half_px, y_px - half_px, 2 * half_px, 2 * half_px);
    fill_and_outline(canvas, end_colour);
}

void draw_trajectory_legend(Canvas& canvas, const PictureFrame& frame) {
    const double unit = canvas.unit();
    const TextStyle style{13 * unit, Align::left, false, ink_colour};
    const double y_px = canvas.height_px() - 18 * unit;
    double x_px = frame.left_px;
    const auto label = [&](const char* text) {
        canvas.draw_text(x_px, y_px + 4.5 * unit, text, style);
        x_px += canvas.text_width_px(text, style) + 26 * unit;
    };
    canvas.stroke_line(x_px, y_px, x_px + 30 * unit, y_px, 2.2 * unit, path_colour);
    x_px += 38 * unit;
    label("trajectory");
    draw_start_marker(canvas, x_px + 6 * unit, y_px);
    x_px += 19 * unit;
    label("start");
    draw_end_marker(canvas, x_px + 6 * unit, y_px);
    x_px += 19 * unit;
    label("end");
}

void draw_scale_bar(Canvas& canvas, const PictureFrame& frame, double px_per_m) {
    const double unit = canvas.unit();
    const double step_m = round_step(frame.width_px / px_per_m, 4);
    // A quarter of the frame at most: half the bar is enough beyond that.
    const double length_m = step_m * px_per_m > 0.25 * frame.width_px ? 0.5 * step_m : step_m;
    const double length_px = length_m * px_per_m;
    const double right_px = frame.right_px();
    const double y_px = canvas.height_px() - 14 * unit;
    canvas.fill_rectangle(right_px - length_px, y_px, length_px, 5 * unit, ink_colour);
    canvas.fill_rectangle(right_px - 0.5 * length_px, y_px + unit, 0.5 * length_px - unit, 3 * unit,
                          paper_colour);
    const std::string text = number_text(length_m, length_m) + " m";
    canvas.draw_text(right_px - 0.5 * length_px, y_px - 5 * unit, text,
                     {13 * unit, Align::centre, false, ink_colour});
}

void draw_empty_picture(const ProfilePictureOptions& options, const std::filesystem::path& file) {
    Canvas canvas(options.width_px, options.height_px);
    const PictureFrame frame = picture_frame(canvas.width_px(), canvas.height_px());
    draw_header(canvas, frame, options, {});
    canvas.fill_rectangle(frame.left_px, frame.top_px, frame.width_px, frame.height_px,
                          unknown_colour);
    canvas.draw_text(frame.left_px + 0.5 * frame.width_px, frame.top_px + 0.5 * frame.height_px,
                     "no occupied cells", {24 * canvas.unit(), Align::centre, false, quiet_colour});
    canvas.write_png(file);
}

void check_profile(const HeightProfile& profile) {
    if (!profile.columns.empty() && !(std::isfinite(profile.cell_m) && profile.cell_m > 0.0)) {
        throw UsageError(
            fmt::format("a height profile with cells of {} m cannot be drawn; give "
                        "its cell_m in metres, above 0",
                        profile.cell_m));
    }
}

} // namespace zonegrid
