#include "io/depth_png.h"

#include "io/file_bytes.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <span>
#include <string>

namespace zonegrid {
namespace {

/// What libpng's callbacks share: the bytes not yet read, and the first error.
struct PngSource {
    std::span<const std::uint8_t> rest;
    std::array<char, 128> error{};
};

void read_bytes(png_structp png, png_bytep target, std::size_t size) {
    auto* const source = static_cast<PngSource*>(png_get_io_ptr(png));
    if (source->rest.size() < size) {
        png_error(png, "the file ends early");
    }
    std::memcpy(target, source->rest.data(), size);
    source->rest = source->rest.subspan(size);
}

[[noreturn]] void keep_error(png_structp png, png_const_charp message) {
    auto* const source = static_cast<PngSource*>(png_get_error_ptr(png));
    std::strncpy(source->error.data(), message, source->error.size() - 1);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

/// libpng's two handles.
struct PngReader {
    explicit PngReader(PngSource& source)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, keep_error, ignore_warning)),
          info(png == nullptr ? nullptr : png_create_info_struct(png)) {}
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

    png_structp png;
    png_infop info;
};

// libpng leaves by longjmp on an error. The two functions below are all it may jump across: nothing
// in them has a destructor, and they return false instead of throwing.

bool read_header(png_structp png, png_infop info, PngSource& source) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_set_user_limits(png, largest_image_px, largest_image_px);
    png_set_read_fn(png, &source, read_bytes);
    png_read_info(png, info);
    return true;
}

bool read_pixels(png_structp png, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    if constexpr (std::endian::native == std::endian::little) {
        png_set_swap(png); // PNG is big-endian
    }
    png_set_interlace_handling(png);
    png_read_image(png, rows);
    png_read_end(png, nullptr);
    return true;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const PngSource& source) {
    throw InputError(file.string(),
                     fmt::format("the PNG cannot be decoded ({})", source.error.data()),
                     "copy the file again from its source or take it out of the list");
}

ImageSize open_png(const std::filesystem::path& file, const PngReader& reader, PngSource& source) {
    if (reader.info == nullptr || !read_header(reader.png, reader.info, source)) {
        refuse(file, source);
    }
    const int channels = png_get_channels(reader.png, reader.info);
    const int depth_bit = png_get_bit_depth(reader.png, reader.info);
    if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_GRAY || depth_bit != 16) {
        throw InputError(file.string(),
                         fmt::format("the PNG has {} channel{} of {} bits", channels,
                                     channels == 1 ? "" : "s", depth_bit),
                         "depth images are 16-bit grey PNGs: give the depth, not the colour image");
    }
    return {static_cast<int>(png_get_image_width(reader.png, reader.info)),
            static_cast<int>(png_get_image_height(reader.png, reader.info))};
}

} // namespace

DepthPng read_depth_png(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    PngSource source{bytes};
    const PngReader reader(source);
    DepthPng image;
    image.size = open_png(file, reader, source);
    const auto width = static_cast<std::size_t>(image.size.width_px);
    image.values.resize(width * static_cast<std::size_t>(image.size.height_px));
    std::vector<png_bytep> rows;
    for (std::size_t first = 0; first < image.values.size(); first += width) {
        // libpng writes 16-bit samples through byte pointers.
        rows.push_back(reinterpret_cast<png_bytep>(image.values.data() + first));
    }
    if (!read_pixels(reader.png, rows.data())) {
        refuse(file, source);
    }
    return image;
}

ImageSize read_depth_png_size(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    PngSource source{bytes};
    const PngReader reader(source);
    return open_png(file, reader, source);
}

} // namespace zonegrid
