#include "io/profile_perspective_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace zonegrid {
namespace {

using Place = Eigen::Vector3d; // north, east, height in metres

Eigen::Vector2d seen_px(const PerspectiveView& view, const Place& place) {
    const SeenPoint seen = view.project(place.x(), place.y(), place.z());
    return {seen.x_px, seen.y_px};
}

void stroke(Canvas& canvas, const PerspectiveView& view, const Place& from, const Place& to,
            double width_px, Rgb colour) {
    const Eigen::Vector2d a = seen_px(view, from);
    const Eigen::Vector2d b = seen_px(view, to);
    canvas.stroke_line(a.x(), a.y(), b.x(), b.y(), width_px, colour);
}

/// Step of the ticks along one side of the floor: the same on both, unless that leaves a short
/// side bare.
double plan_step_m(const SceneBox& box, double side_m) {
    const double longest_m = std::max(box.plan.north_extent_m(), box.plan.east_extent_m());
    return std::min(round_step(longest_m, 8), round_step(side_m, 3));
}

/// Step of the ticks up the leftmost corner, so that their numbers stand clear of each other.
double height_step_m(const Canvas& canvas, const SceneBox& box, double length_px) {
    const int most = std::clamp(static_cast<int>(length_px / (18 * canvas.unit())), 1, 5);
    return round_step(box.top_m - box.base_m, most);
}

template <typename Draw>
void for_each_tick(double low_m, double high_m, double step_m, Draw draw) {
    for (double i = std::ceil(low_m / step_m - 1e-9); i <= high_m / step_m + 1e-9; i += 1.0) {
        draw(i * step_m);
    }
}

/// Text at `distance_px` from a point in a direction of the picture, clear of the point.
void draw_text_beside(Canvas& canvas, const Eigen::Vector2d& point_px,
                      const Eigen::Vector2d& direction, double distance_px, const std::string& text,
                      TextStyle style) {
    const Eigen::Vector2d place = point_px + distance_px * direction;
    style.align = direction.x() > 0.35    ? Align::left
                  : direction.x() < -0.35 ? Align::right
                                          : Align::centre;
    canvas.draw_text(place.x(), place.y() + (0.35 + 0.35 * direction.y()) * style.size_px, text,
                     style);
}

/// One numbered edge of the box: from + s * along for s in [low, high], numbers on the `outward`
/// side.
struct Axis {
    Place from;
    Place along;
    double low_m;
    double high_m;
    double step_m;
    Eigen::Vector2d outward; ///< unit vector in the picture
    std::string label;
};

void draw_axis(Canvas& canvas, const PerspectiveView& view, const Axis& axis) {
    const double unit = canvas.unit();
    const TextStyle number{12.5 * unit, Align::centre, false, ink_colour};
    const TextStyle label{14 * unit, Align::centre, false, ink_colour};
    const auto at = [&](double value_m) -> Place { return axis.from + value_m * axis.along; };
    stroke(canvas, view, at(axis.low_m), at(axis.high_m), 1.3 * unit, ink_colour);
    double widest_px = 0.0;
    for_each_tick(axis.low_m, axis.high_m, axis.step_m, [&](double tick_m) {
        const Eigen::Vector2d point = seen_px(view, at(tick_m));
        const Eigen::Vector2d tip = point + 6 * unit * axis.outward;
        canvas.stroke_line(point.x(), point.y(), tip.x(), tip.y(), unit, ink_colour);
        const std::string text = number_text(tick_m, axis.step_m);
        draw_text_beside(canvas, point, axis.outward, 11 * unit, text, number);
        widest_px = std::max(widest_px, canvas.text_width_px(text, number));
    });
    const Eigen::Vector2d middle = seen_px(view, at(0.5 * (axis.low_m + axis.high_m)));
    const double clear_px =
        22 * unit + std::abs(axis.outward.x()) * widest_px + std::abs(axis.outward.y()) * 14 * unit;
    draw_text_beside(canvas, middle, axis.outward, clear_px, axis.label, label);
}

/// Unit vector in the picture square to an edge, pointing away from `inside`.
Eigen::Vector2d outward_normal(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                               const Eigen::Vector2d& inside) {
    const Eigen::Vector2d along = (to - from).normalized();
    const Eigen::Vector2d normal(-along.y(), along.x());
    return normal.dot(inside - from) > 0.0 ? -normal : normal;
}

} // namespace

void draw_floor(Canvas& canvas, const PerspectiveView& view, const SceneBox& box) {
    const GroundPlan& plan = box.plan;
    const std::array<Place, 4> corners = {Place(plan.north_min_m, plan.east_min_m, box.base_m),
                                          Place(plan.north_min_m, plan.east_max_m, box.base_m),
                                          Place(plan.north_max_m, plan.east_max_m, box.base_m),
                                          Place(plan.north_max_m, plan.east_min_m, box.base_m)};
    for (const Place& corner : corners) {
        const Eigen::Vector2d point = seen_px(view, corner);
        cairo_line_to(canvas.cairo(), point.x(), point.y());
    }
    cairo_close_path(canvas.cairo());
    canvas.set_colour(unknown_colour);
    cairo_fill(canvas.cairo());

    const double north_step_m = plan_step_m(box, plan.north_extent_m());
    const double east_step_m = plan_step_m(box, plan.east_extent_m());
    for_each_tick(plan.north_min_m, plan.north_max_m, north_step_m, [&](double tick_m) {
        stroke(canvas, view, {tick_m, plan.east_min_m, box.base_m},
               {tick_m, plan.east_max_m, box.base_m}, canvas.unit(), grid_colour);
    });
    for_each_tick(plan.east_min_m, plan.east_max_m, east_step_m, [&](double tick_m) {
        stroke(canvas, view, {plan.north_min_m, tick_m, box.base_m},
               {plan.north_max_m, tick_m, box.base_m}, canvas.unit(), grid_colour);
    });
    for (std::size_t i = 0; i < 4; ++i) {
        stroke(canvas, view, corners[i], corners[(i + 1) % 4], canvas.unit(), quiet_colour);
    }
}

void draw_box_axes(Canvas& canvas, const PerspectiveView& view, const SceneBox& box) {
    const GroundPlan& plan = box.plan;
    const double near_north_m = view.eye_m().x() < 0.5 * (plan.north_min_m + plan.north_max_m)
                                    ? plan.north_min_m
                                    : plan.north_max_m;
    const double far_north_m = plan.north_min_m + plan.north_max_m - near_north_m;
    const double near_east_m = view.eye_m().y() < 0.5 * (plan.east_min_m + plan.east_max_m)
                                   ? plan.east_min_m
                                   : plan.east_max_m;
    const double far_east_m = plan.east_min_m + plan.east_max_m - near_east_m;
    const Eigen::Vector2d inside =
        seen_px(view, {0.5 * (plan.north_min_m + plan.north_max_m),
                       0.5 * (plan.east_min_m + plan.east_max_m), box.base_m});
    const Place near_corner(near_north_m, near_east_m, box.base_m);
    const Place east_end(near_north_m, far_east_m, box.base_m);
    const Place north_end(far_north_m, near_east_m, box.base_m);

    draw_axis(
        canvas, view,
        {Place(near_north_m, 0.0, box.base_m), Place(0.0, 1.0, 0.0), plan.east_min_m,
         plan.east_max_m, plan_step_m(box, plan.east_extent_m()),
         outward_normal(seen_px(view, near_corner), seen_px(view, east_end), inside), "east [m]"});
    draw_axis(canvas, view,
              {Place(0.0, near_east_m, box.base_m), Place(1.0, 0.0, 0.0), plan.north_min_m,
               plan.north_max_m, plan_step_m(box, plan.north_extent_m()),
               outward_normal(seen_px(view, near_corner), seen_px(view, north_end), inside),
               "north [m]"});
    // Heights stand at the leftmost corner, where nothing is drawn to their left.
    const Place& left =
        seen_px(view, east_end).x() < seen_px(view, north_end).x() ? east_end : north_end;
    const double length_px = (seen_px(view, {left.x(), left.y(), box.top_m}) -
                              seen_px(view, {left.x(), left.y(), box.base_m}))
                                 .norm();
    draw_axis(canvas, view,
              {Place(left.x(), left.y(), 0.0),
               Place(0.0, 0.0, 1.0),
               box.base_m,
               box.top_m,
               height_step_m(canvas, box, length_px),
               Eigen::Vector2d(-1.0, 0.0),
               {}});
}

} // namespace zonegrid
