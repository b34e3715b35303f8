#include "io/profile_picture.h"

#include "io/profile_picture_canvas.h"
#include "io/profile_picture_columns.h"
#include "io/profile_picture_furniture.h"
#include "io/profile_picture_layout.h"

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

/// Calls `draw(tick_m)` for each multiple of `step_m` in [low, high].
template <typename Draw>
void for_each_tick(double low_m, double high_m, double step_m, Draw draw) {
    const double first = std::ceil(low_m / step_m - 1e-9);
    const double last = std::floor(high_m / step_m + 1e-9);
    for (double i = first; i <= last; i += 1.0) {
        draw(i * step_m);
    }
}

void draw_axes(Canvas& canvas, const ProfileLayout& layout) {
    const double unit = canvas.unit();
    const PictureFrame& frame = layout.frame;
    const double east_min_m = layout.east_m(frame.left_px);
    const double east_max_m = layout.east_m(frame.right_px());
    const double north_min_m = layout.place_north_m(frame.bottom_px());
    const double north_max_m = layout.place_north_m(frame.top_px);
    const double step_m =
        round_step(std::max(east_max_m - east_min_m, north_max_m - north_min_m), 12);
    const TextStyle number{13 * unit, Align::centre, false, ink_colour};
    const TextStyle label{14 * unit, Align::centre, false, ink_colour};

    for_each_tick(east_min_m, east_max_m, step_m, [&](double tick_m) {
        const double x_px = std::floor(layout.x_px(tick_m)) + 0.5;
        canvas.stroke_line(x_px, frame.bottom_px(), x_px, frame.bottom_px() + 6 * unit, unit,
                           ink_colour);
        canvas.draw_text(x_px, frame.bottom_px() + 20 * unit, number_text(tick_m, step_m), number);
    });
    for_each_tick(north_min_m, north_max_m, step_m, [&](double tick_m) {
        const double y_px = std::floor(layout.y_px(tick_m)) + 0.5;
        canvas.stroke_line(frame.left_px - 6 * unit, y_px, frame.left_px, y_px, unit, ink_colour);
        canvas.draw_text(frame.left_px - 9 * unit, y_px + 4.5 * unit, number_text(tick_m, step_m),
                         {13 * unit, Align::right, false, ink_colour});
    });
    canvas.draw_text(frame.left_px + 0.5 * frame.width_px, frame.bottom_px() + 42 * unit,
                     "east [m]", label);
    canvas.draw_text_upwards(26 * unit, frame.top_px + 0.5 * frame.height_px, "north [m]", label);

    canvas.set_colour(ink_colour);
    cairo_set_line_width(canvas.cairo(), unit);
    cairo_rectangle(canvas.cairo(), frame.left_px - 0.5, frame.top_px - 0.5, frame.width_px + 1,
                    frame.height_px + 1);
    cairo_stroke(canvas.cairo());
}

/// Traces the drawable points as one path, broken where points are missing.
void trace_trajectory(Canvas& canvas, const ProfileLayout& layout,
                      std::span<const Eigen::Vector3d> trajectory_m) {
    bool pen_down = false;
    Eigen::Vector2d last_px = Eigen::Vector2d::Zero();
    for (const Eigen::Vector3d& point : trajectory_m) {
        if (!is_drawable(point)) {
            pen_down = false;
            continue;
        }
        const Eigen::Vector2d place_px(layout.x_px(point.y()), layout.y_px(point.x()));
        if (!pen_down) {
            cairo_move_to(canvas.cairo(), place_px.x(), place_px.y());
            // A lone point still leaves a dot with round caps.
            cairo_line_to(canvas.cairo(), place_px.x(), place_px.y());
        } else if ((place_px - last_px).norm() < 0.5) {
            continue; // hovering adds nothing but cost
        } else {
            cairo_line_to(canvas.cairo(), place_px.x(), place_px.y());
        }
        pen_down = true;
        last_px = place_px;
    }
}

void draw_trajectory(Canvas& canvas, const ProfileLayout& layout,
                     std::span<const Eigen::Vector3d> trajectory_m) {
    const auto start = std::ranges::find_if(trajectory_m, is_drawable);
    if (start == trajectory_m.end()) {
        return;
    }
    const auto end = std::ranges::find_if(trajectory_m.rbegin(), trajectory_m.rend(), is_drawable);

    cairo_save(canvas.cairo());
    cairo_rectangle(canvas.cairo(), layout.frame.left_px, layout.frame.top_px,
                    layout.frame.width_px, layout.frame.height_px);
    cairo_clip(canvas.cairo());
    cairo_set_line_join(canvas.cairo(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(canvas.cairo(), CAIRO_LINE_CAP_ROUND);
    trace_trajectory(canvas, layout, trajectory_m);
    canvas.set_colour(paper_colour, 0.85);
    cairo_set_line_width(canvas.cairo(), 5 * canvas.unit());
    cairo_stroke_preserve(canvas.cairo());
    canvas.set_colour(path_colour);
    cairo_set_line_width(canvas.cairo(), 2.2 * canvas.unit());
    cairo_stroke(canvas.cairo());
    cairo_restore(canvas.cairo());

    draw_start_marker(canvas, layout.x_px(start->y()), layout.y_px(start->x()));
    draw_end_marker(canvas, layout.x_px(end->y()), layout.y_px(end->x()));
    draw_trajectory_legend(canvas, layout.frame);
}

} // namespace

void draw_profile(const HeightProfile& profile, std::span<const Eigen::Vector3d> trajectory_m,
                  const ProfilePictureOptions& options, const std::filesystem::path& file) {
    check_profile(profile);
    if (profile.columns.empty()) {
        draw_empty_picture(options, file);
        return;
    }
    Canvas canvas(options.width_px, options.height_px);
    const PictureFrame frame = picture_frame(canvas.width_px(), canvas.height_px());
    const HeightProfile& scale = options.scale == nullptr ? profile : *options.scale;
    const GroundPlan plan = ground_plan(scale, trajectory_m);
    const ProfileLayout layout = layout_profile(frame, plan, profile.cell_m);
    const HeightRange range = height_ranges(scale, plan).colour;

    canvas.fill_rectangle(frame.left_px, frame.top_px, frame.width_px, frame.height_px,
                          unknown_colour);
    draw_columns(canvas, layout, profile, range);
    draw_trajectory(canvas, layout, trajectory_m);
    draw_axes(canvas, layout);
    draw_colour_bar(canvas, frame, range);
    draw_scale_bar(canvas, frame, layout.px_per_m);
    draw_header(canvas, frame, options, clipping_note(range));
    canvas.write_png(file);
}

} // namespace zonegrid
