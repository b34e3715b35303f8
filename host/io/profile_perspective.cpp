#include "io/profile_perspective_blocks.h"
#include "io/profile_perspective_frame.h"
#include "io/profile_perspective_grid.h"
#include "io/profile_perspective_path.h"
#include "io/profile_perspective_raster.h"
#include "io/profile_perspective_view.h"
#include "io/profile_picture.h"
#include "io/profile_picture_canvas.h"
#include "io/profile_picture_furniture.h"
#include "io/profile_picture_layout.h"
#include "io/profile_picture_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zonegrid {
namespace {

/// Tiles a side; more would be smaller than a sample of the usual picture.
constexpr int most_tiles = 2400;

SceneBox scene_box(const GroundPlan& plan, const HeightRange& drawn, double cell_m,
                   std::span<const Eigen::Vector3d> trajectory_m) {
    SceneBox box{plan, drawn.low_m - cell_m, drawn.high_m, 1.0};
    for (const Eigen::Vector3d& point : trajectory_m) {
        if (is_drawable(point)) {
            box.base_m = std::min(box.base_m, -point.z());
            box.top_m = std::max(box.top_m, -point.z());
        }
    }
    const double flatness =
        (box.top_m - box.base_m) / std::max(plan.north_extent_m(), plan.east_extent_m());
    box.exaggeration = flatness > 1.0 / 15.0 ? 1.0 : flatness > 1.0 / 40.0 ? 2.0 : 5.0;
    return box;
}

std::string note_on_heights(const HeightRange& drawn, double exaggeration) {
    const std::string clipped = clipping_note(drawn);
    const std::string raised =
        exaggeration > 1.0 ? fmt::format("heights drawn {} times as high", exaggeration) : "";
    return clipped + (clipped.empty() || raised.empty() ? "" : "; ") + raised;
}

} // namespace

void draw_profile_3d(const HeightProfile& profile, std::span<const Eigen::Vector3d> trajectory_m,
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
    const HeightRanges ranges = height_ranges(scale, plan);
    const SceneBox box = scene_box(plan, ranges.drawn, profile.cell_m, trajectory_m);
    const TileGrid tiles(profile, ranges.drawn, most_tiles);
    const PerspectiveView view = choose_view(
        box, frame, options.scale == nullptr ? tiles : TileGrid(scale, ranges.drawn, most_tiles));

    // Beyond 4 K the samples would cost more memory than they add sharpness.
    const int samples = std::max(canvas.width_px(), canvas.height_px()) <= 4096 ? 2 : 1;
    BlockRaster raster(canvas.width_px(), canvas.height_px(), samples);
    fill_blocks(raster, tiles, view, box);

    draw_floor(canvas, view, box);
    const double elevation_rad = view.elevation_deg() * std::numbers::pi / 180.0;
    raster.paint(canvas, ColourTable(ranges.colour.low_m, ranges.colour.high_m),
                 1.0 / (view.px_per_m() * samples * std::tan(elevation_rad) * view.distance_m()));
    draw_box_axes(canvas, view, box);
    draw_path(canvas, view, raster, tiles, box, trajectory_m);
    if (std::ranges::any_of(trajectory_m, is_drawable)) {
        draw_trajectory_legend(canvas, frame);
    }
    draw_colour_bar(canvas, frame, ranges.colour);
    draw_header(canvas, frame, options, note_on_heights(ranges.drawn, box.exaggeration));
    canvas.write_png(file);
}

} // namespace zonegrid
