#include "io/profile_picture_canvas.h"

#include "io/profile_picture_layout.h"
#include "io/readable_text.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <system_error>

namespace zonegrid {
namespace {

constexpr const char* font_family = "DejaVu Sans";

cairo_status_t append_to_stream(void* stream, const unsigned char* data, unsigned int length) {
    auto& out = *static_cast<std::ofstream*>(stream);
    out.write(static_cast<const char*>(static_cast<const void*>(data)), length);
    return out ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

void choose_font(cairo_t* context, const TextStyle& style) {
    cairo_select_font_face(context, font_family, CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, style.size_px);
}

} // namespace

Canvas::Canvas(int width_px, int height_px)
    : width_px_(width_px), height_px_(height_px), unit_(picture_unit(width_px, height_px)) {
    if (width_px < 400 || height_px < 300 || width_px > 8192 || height_px > 8192) {
        throw UsageError(
            fmt::format("a picture of {} x {} pixels cannot be drawn; choose a size "
                        "from 400 x 300 to 8192 x 8192",
                        width_px, height_px));
    }
    surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px));
    if (cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS) {
        throw CapacityError(
            fmt::format("no memory for a picture of {} x {} pixels; choose a "
                        "smaller size",
                        width_px, height_px));
    }
    context_.reset(cairo_create(surface_.get()));
    fill_rectangle(0, 0, width_px, height_px, paper_colour);
}

void Canvas::set_colour(Rgb colour, double opacity) {
    cairo_set_source_rgba(cairo(), colour.r / 255.0, colour.g / 255.0, colour.b / 255.0, opacity);
}

void Canvas::begin_pixels() {
    cairo_surface_flush(surface_.get());
}

void Canvas::end_pixels() {
    cairo_surface_mark_dirty(surface_.get());
}

void Canvas::set_pixel(int x_px, int y_px, Rgb colour) {
    // RGB24 is one native 32-bit word per pixel, 0x00RRGGBB; rows are 4-byte aligned.
    auto* words = reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface_.get()));
    const int stride = cairo_image_surface_get_stride(surface_.get()) / 4;
    words[static_cast<std::ptrdiff_t>(y_px) * stride + x_px] =
        (std::uint32_t{colour.r} << 16U) | (std::uint32_t{colour.g} << 8U) | colour.b;
}

Rgb Canvas::pixel(int x_px, int y_px) const {
    const auto* words =
        reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(surface_.get()));
    const int stride = cairo_image_surface_get_stride(surface_.get()) / 4;
    const std::uint32_t word = words[static_cast<std::ptrdiff_t>(y_px) * stride + x_px];
    return {static_cast<std::uint8_t>(word >> 16U), static_cast<std::uint8_t>(word >> 8U),
            static_cast<std::uint8_t>(word)};
}

void Canvas::fill_rectangle(double x_px, double y_px, double width_px, double height_px,
                            Rgb colour) {
    set_colour(colour);
    cairo_rectangle(cairo(), x_px, y_px, width_px, height_px);
    cairo_fill(cairo());
}

void Canvas::stroke_line(double x0_px, double y0_px, double x1_px, double y1_px, double width_px,
                         Rgb colour) {
    set_colour(colour);
    cairo_set_line_width(cairo(), width_px);
    cairo_move_to(cairo(), x0_px, y0_px);
    cairo_line_to(cairo(), x1_px, y1_px);
    cairo_stroke(cairo());
}

double Canvas::text_width_px(std::string_view text, const TextStyle& style) {
    choose_font(cairo(), style);
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo(), readable_text(text).c_str(), &extents);
    return extents.x_advance;
}

void Canvas::draw_text(double x_px, double y_px, std::string_view text, const TextStyle& style) {
    const double width = text_width_px(text, style);
    const double shift = style.align == Align::left     ? 0.0
                         : style.align == Align::centre ? 0.5 * width
                                                        : width;
    set_colour(style.colour);
    cairo_move_to(cairo(), x_px - shift, y_px);
    cairo_show_text(cairo(), readable_text(text).c_str());
    cairo_new_path(cairo());
}

void Canvas::draw_text_upwards(double x_px, double y_px, std::string_view text,
                               const TextStyle& style) {
    cairo_save(cairo());
    cairo_translate(cairo(), x_px, y_px);
    cairo_rotate(cairo(), -0.5 * std::acos(-1.0));
    draw_text(0.0, 0.0, text, style);
    cairo_restore(cairo());
}

std::string Canvas::fitting_text(std::string_view text, const TextStyle& style, double width_px) {
    // More characters than this fit into no picture.
    std::string whole = readable_text(text.substr(0, 2000));
    if (text_width_px(whole, style) <= width_px) {
        return whole;
    }
    while (!whole.empty() && text_width_px(whole + "\u2026", style) > width_px) {
        // One character: its last byte and the continuation bytes before it.
        do {
            const bool continuation = (static_cast<std::uint8_t>(whole.back()) & 0xC0U) == 0x80U;
            whole.pop_back();
            if (!continuation) {
                break;
            }
        } while (!whole.empty());
    }
    return whole + "\u2026";
}

void Canvas::write_png(const std::filesystem::path& file) {
    if (const cairo_status_t status = cairo_status(cairo()); status != CAIRO_STATUS_SUCCESS) {
        throw OutputError(
            fmt::format("{}: the picture could not be drawn ({}); check the fonts "
                        "(package fonts-dejavu-core) and the free memory",
                        file.string(), cairo_status_to_string(status)));
    }
    std::filesystem::path part = file;
    part += ".part";
    const auto fail = [&file](const std::string& problem) {
        throw OutputError(
            fmt::format("{}: {}; check that its folder exists, may be written to "
                        "and has space left, or choose another file",
                        file.string(), problem));
    };
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    if (!out) {
        fail("the picture cannot be created");
    }
    const cairo_status_t status =
        cairo_surface_write_to_png_stream(surface_.get(), append_to_stream, &out);
    out.close();
    std::error_code error;
    if (status != CAIRO_STATUS_SUCCESS || !out) {
        std::filesystem::remove(part, error);
        fail("the picture cannot be written");
    }
    std::filesystem::rename(part, file, error);
    if (error) {
        const std::string reason = error.message();
        std::filesystem::remove(part, error);
        fail("the picture cannot be put in place (" + reason + ")");
    }
}

} // namespace zonegrid
