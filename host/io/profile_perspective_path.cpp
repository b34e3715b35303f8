#include "io/profile_perspective_path.h"

#include "io/profile_picture_furniture.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace zonegrid {
namespace {

/// A piece of the path that is seen or hidden as a whole.
struct Piece {
    std::vector<Eigen::Vector2d> points_px;
    bool hidden = false;
};

/// Cuts the path into pieces; segments are looked at every three pixels.
class PathCutter {
public:
    PathCutter(const PerspectiveView& view, const BlockRaster& raster)
        : view_(view), raster_(raster) {}

    void add(const Eigen::Vector3d& point_m) {
        if (!is_drawable(point_m)) {
            started_ = false;
            return;
        }
        const SeenPoint seen = view_.project(point_m.x(), point_m.y(), -point_m.z());
        if (!started_) {
            begin(seen);
            return;
        }
        const double length_px = std::hypot(seen.x_px - last_.x_px, seen.y_px - last_.y_px);
        if (length_px < 0.5) {
            return; // hovering adds nothing but cost
        }
        const int steps = std::clamp(static_cast<int>(length_px / 3.0), 1, 5000);
        const SeenPoint from = last_;
        for (int i = 1; i <= steps; ++i) {
            // A straight line in space is straight in the picture, and so is 1/depth along it.
            const double share = static_cast<double>(i) / steps;
            go_on({from.x_px + share * (seen.x_px - from.x_px),
                   from.y_px + share * (seen.y_px - from.y_px),
                   from.inverse_depth + share * (seen.inverse_depth - from.inverse_depth)});
        }
    }

    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

private:
    void begin(const SeenPoint& seen) {
        pieces_.push_back({{{seen.x_px, seen.y_px}}, raster_.hides(seen)});
        last_ = seen;
        started_ = true;
    }

    void go_on(const SeenPoint& seen) {
        if (const bool hidden = raster_.hides(seen); hidden != pieces_.back().hidden) {
            pieces_.push_back({{{last_.x_px, last_.y_px}}, hidden});
        }
        pieces_.back().points_px.emplace_back(seen.x_px, seen.y_px);
        last_ = seen;
    }

    const PerspectiveView& view_;
    const BlockRaster& raster_;
    std::vector<Piece> pieces_;
    SeenPoint last_;
    bool started_ = false;
};

void stroke_pieces(Canvas& canvas, const std::vector<Piece>& pieces, bool hidden, double width_px,
                   Rgb colour, double opacity) {
    for (const Piece& piece : pieces) {
        if (piece.hidden != hidden) {
            continue;
        }
        cairo_new_sub_path(canvas.cairo());
        for (const Eigen::Vector2d& point : piece.points_px) {
            cairo_line_to(canvas.cairo(), point.x(), point.y());
        }
    }
    canvas.set_colour(colour, opacity);
    cairo_set_line_width(canvas.cairo(), width_px);
    cairo_stroke(canvas.cairo());
}

void drop_line(Canvas& canvas, const PerspectiveView& view, const TileGrid& tiles,
               const SceneBox& box, const Eigen::Vector3d& point_m) {
    const double under_m = tiles.top_at_m(point_m.x(), point_m.y());
    const double foot_m = std::isnan(under_m) ? box.base_m : under_m;
    const SeenPoint upper = view.project(point_m.x(), point_m.y(), -point_m.z());
    const SeenPoint foot = view.project(point_m.x(), point_m.y(), foot_m);
    const double unit = canvas.unit();
    canvas.stroke_line(upper.x_px, upper.y_px, foot.x_px, foot.y_px, 3.5 * unit, paper_colour);
    canvas.stroke_line(upper.x_px, upper.y_px, foot.x_px, foot.y_px, 1.5 * unit, path_colour);
    cairo_arc(canvas.cairo(), foot.x_px, foot.y_px, 2.5 * unit, 0.0, 6.283185307179586);
    canvas.set_colour(path_colour);
    cairo_fill(canvas.cairo());
}

/// Text on a plate, so that it can be read over any block.
void draw_height_label(Canvas& canvas, const SeenPoint& seen, double height_m, double step_m) {
    const double unit = canvas.unit();
    const TextStyle style{12.5 * unit, Align::left, false, ink_colour};
    const std::string text = number_text(height_m, step_m) + " m";
    const double width_px = canvas.text_width_px(text, style);
    const double left_px = std::min(seen.x_px + 13 * unit, canvas.width_px() - width_px - 6 * unit);
    canvas.set_colour(paper_colour, 0.8);
    cairo_rectangle(canvas.cairo(), left_px - 3 * unit, seen.y_px - 9 * unit, width_px + 6 * unit,
                    18 * unit);
    cairo_fill(canvas.cairo());
    canvas.draw_text(left_px, seen.y_px + 4.5 * unit, text, style);
}

} // namespace

void draw_path(Canvas& canvas, const PerspectiveView& view, const BlockRaster& raster,
               const TileGrid& tiles, const SceneBox& box,
               std::span<const Eigen::Vector3d> trajectory_m) {
    const auto start = std::ranges::find_if(trajectory_m, is_drawable);
    if (start == trajectory_m.end()) {
        return;
    }
    const auto end = std::ranges::find_if(trajectory_m.rbegin(), trajectory_m.rend(), is_drawable);
    PathCutter cutter(view, raster);
    for (const Eigen::Vector3d& point : trajectory_m) {
        cutter.add(point);
    }
    drop_line(canvas, view, tiles, box, *start);
    drop_line(canvas, view, tiles, box, *end);

    const double unit = canvas.unit();
    cairo_set_line_join(canvas.cairo(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(canvas.cairo(), CAIRO_LINE_CAP_BUTT);
    stroke_pieces(canvas, cutter.pieces(), true, 2.0 * unit, path_colour, 0.35);
    cairo_set_line_cap(canvas.cairo(), CAIRO_LINE_CAP_ROUND);
    stroke_pieces(canvas, cutter.pieces(), false, 5.0 * unit, paper_colour, 0.85);
    stroke_pieces(canvas, cutter.pieces(), false, 2.2 * unit, path_colour, 1.0);
    cairo_set_line_cap(canvas.cairo(), CAIRO_LINE_CAP_BUTT);

    const SeenPoint start_px = view.project(start->x(), start->y(), -start->z());
    const SeenPoint end_px = view.project(end->x(), end->y(), -end->z());
    draw_start_marker(canvas, start_px.x_px, start_px.y_px);
    draw_end_marker(canvas, end_px.x_px, end_px.y_px);
    const double step_m = round_step(box.top_m - box.base_m, 50);
    draw_height_label(canvas, start_px, -start->z(), step_m);
    draw_height_label(canvas, end_px, -end->z(), step_m);
}

} // namespace zonegrid
