#include "evaluation/evaluation_pictures.h"

#include "io/profile_picture.h"
#include "io/profile_picture_canvas.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <system_error>

namespace zonegrid {
namespace {

namespace fs = std::filesystem;

constexpr int width_px = 960;
constexpr int height_px = 760;

using DrawProfile = void (*)(const HeightProfile&, std::span<const Eigen::Vector3d>,
                             const ProfilePictureOptions&, const fs::path&);

/// Removed at the end.
class ScratchFile {
public:
    explicit ScratchFile(fs::path path) : path_(std::move(path)) {}
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ~ScratchFile() {
        std::error_code error; // nobody is left to tell
        fs::remove(path_, error);
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

void paste(Canvas& canvas, const fs::path& picture, int x_px) {
    struct Deleter {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    };
    const std::unique_ptr<cairo_surface_t, Deleter> surface(
        cairo_image_surface_create_from_png(picture.c_str()));
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
        throw OutputError(fmt::format("{}: the picture cannot be read back; check the space left",
                                      picture.string()));
    }
    cairo_set_source_surface(canvas.cairo(), surface.get(), x_px, 0.0);
    cairo_paint(canvas.cairo());
}

/// All columns of both.
HeightProfile both(const HeightProfile& one, const HeightProfile& other) {
    HeightProfile all{one.cell_m, {}};
    std::ranges::merge(one.columns, other.columns, std::back_inserter(all.columns));
    // Of a column in both the lesser z stands first.
    const auto doubled = std::ranges::unique(
        all.columns, [](const auto& a, const auto& b) { return a.x == b.x && a.y == b.y; });
    all.columns.erase(doubled.begin(), doubled.end());
    return all;
}

void draw_pair(const Evaluation& evaluation, DrawProfile draw, const fs::path& file) {
    const HeightProfile scale = both(evaluation.map_profile, evaluation.true_profile);
    ProfilePictureOptions options;
    options.width_px = width_px;
    options.height_px = height_px;
    options.scale = scale.columns.empty() ? nullptr : &scale;
    const auto scratch = [&file](const char* ending) {
        fs::path path = file;
        path += ending;
        return path;
    };
    const ScratchFile map(scratch(".map.png"));
    options.title = "map";
    options.subtitle = fmt::format("cell {:g} m, range {:g} m, {} model", evaluation.cell_m,
                                   evaluation.range_m, evaluation.model);
    draw(evaluation.map_profile, evaluation.trajectory_m, options, map.path());
    const ScratchFile truth(scratch(".truth.png"));
    options.title = fmt::format("truth: {}", evaluation.scene);
    options.subtitle = "cells in which rays of a perfect sensor end";
    draw(evaluation.true_profile, evaluation.trajectory_m, options, truth.path());
    Canvas canvas(2 * width_px, height_px);
    paste(canvas, map.path(), 0);
    paste(canvas, truth.path(), width_px);
    canvas.write_png(file);
}

} // namespace

void draw_profiles(const Evaluation& evaluation, const fs::path& file) {
    draw_pair(evaluation, &draw_profile, file);
}

void draw_profiles_3d(const Evaluation& evaluation, const fs::path& file) {
    draw_pair(evaluation, &draw_profile_3d, file);
}

} // namespace zonegrid
