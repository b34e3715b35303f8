#pragma once

#include "io/colour_map.h"

#include <cairo.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace zonegrid {

enum class Align { left, centre, right };

struct TextStyle {
    double size_px = 13.0;
    Align align = Align::left;
    bool bold = false;
    Rgb colour{40, 40, 40};
};

/// Colours of everything that is no height.
inline constexpr Rgb paper_colour{255, 255, 255};
inline constexpr Rgb unknown_colour{229, 229, 229};
inline constexpr Rgb ink_colour{40, 40, 40};
inline constexpr Rgb quiet_colour{110, 110, 110};
inline constexpr Rgb grid_colour{205, 205, 205};
inline constexpr Rgb path_colour{0, 0, 0};
inline constexpr Rgb start_colour{40, 180, 90};
inline constexpr Rgb end_colour{225, 40, 60};

/// A white picture of whole pixels that cairo draws on; y points down.
class Canvas {
public:
    /// Throws UsageError unless both sides lie in 400 x 300 .. 8192 x 8192.
    Canvas(int width_px, int height_px);

    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return height_px_; }
    /// Size of fonts and margins relative to a picture of 1200 x 900.
    [[nodiscard]] double unit() const { return unit_; }
    [[nodiscard]] cairo_t* cairo() const { return context_.get(); }

    void set_colour(Rgb colour, double opacity = 1.0);
    /// Overwrites one pixel; call `pixels_changed` once before and after a run of such calls.
    void set_pixel(int x_px, int y_px, Rgb colour);
    [[nodiscard]] Rgb pixel(int x_px, int y_px) const;
    void begin_pixels();
    void end_pixels();

    void fill_rectangle(double x_px, double y_px, double width_px, double height_px, Rgb colour);
    void stroke_line(double x0_px, double y0_px, double x1_px, double y1_px, double width_px,
                     Rgb colour);
    /// (x, y) is the end of the baseline that `align` says. Bytes that are no UTF-8 become '?'.
    void draw_text(double x_px, double y_px, std::string_view text, const TextStyle& style);
    /// The same, turned by 90 degrees to read upwards.
    void draw_text_upwards(double x_px, double y_px, std::string_view text, const TextStyle& style);
    [[nodiscard]] double text_width_px(std::string_view text, const TextStyle& style);
    /// `text`, or as much of its beginning as fits into `width_px`, then with an ellipsis.
    [[nodiscard]] std::string fitting_text(std::string_view text, const TextStyle& style,
                                           double width_px);

    /// Writes an 8-bit RGB PNG beside `file` first and renames it, so that `file` is either whole
    /// or untouched. Throws OutputError.
    void write_png(const std::filesystem::path& file);

private:
    struct Deleter {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };

    int width_px_;
    int height_px_;
    double unit_;
    std::unique_ptr<cairo_surface_t, Deleter> surface_;
    std::unique_ptr<cairo_t, Deleter> context_;
};

} // namespace zonegrid
