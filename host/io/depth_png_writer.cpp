#include "io/depth_png_writer.h"

#include "zonegrid/errors.h"

#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstddef>
#include <new>
#include <utility>

namespace zonegrid {
namespace {

/// What libpng's callbacks share.
struct PngTarget {
    std::vector<std::uint8_t> bytes;
    bool memory_exhausted = false;
};

void write_bytes(png_structp png, png_bytep source, std::size_t size) {
    auto* const target = static_cast<PngTarget*>(png_get_io_ptr(png));
    try { // no exception may pass through libpng
        target->bytes.insert(target->bytes.end(), source, source + size);
    } catch (const std::bad_alloc&) {
        target->memory_exhausted = true;
    }
}

void flush_nothing(png_structp /*png*/) {}

[[noreturn]] void leave(png_structp png, png_const_charp /*message*/) {
    png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

/// libpng's two handles.
struct PngWriter {
    PngWriter()
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore_warning)),
          info(png == nullptr ? nullptr : png_create_info_struct(png)) {}
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png, &info); }

    png_structp png;
    png_infop info;
};

// libpng leaves by longjmp on an error. This is all it may jump across: nothing in it has a
// destructor.
bool write_image(png_structp png, png_infop info, ImageSize size, png_bytepp rows,
                 PngTarget& target) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    constexpr int bits = 16;
    constexpr int fastest = 1;
    png_set_write_fn(png, &target, write_bytes, flush_nothing);
    png_set_compression_level(png, fastest);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_IHDR(png, info, static_cast<png_uint_32>(size.width_px),
                 static_cast<png_uint_32>(size.height_px), bits, PNG_COLOR_TYPE_GRAY,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    if constexpr (std::endian::native == std::endian::little) {
        png_set_swap(png); // PNG is big-endian
    }
    png_write_image(png, rows);
    png_write_end(png, nullptr);
    return true;
}

} // namespace

std::vector<std::uint8_t> encode_depth_png(const DepthPng& image) {
    const auto width = static_cast<std::size_t>(image.size.width_px);
    if (image.values.empty() ||
        image.values.size() != width * static_cast<std::size_t>(image.size.height_px)) {
        throw UsageError("the values of a depth image do not fill its size");
    }
    std::vector<png_bytep> rows;
    for (std::size_t first = 0; first < image.values.size(); first += width) {
        // libpng takes rows that it only reads by pointers to bytes that are not const.
        rows.push_back(
            const_cast<png_bytep>(reinterpret_cast<const png_byte*>(image.values.data() + first)));
    }
    PngTarget target;
    const PngWriter writer;
    if (writer.info == nullptr ||
        !write_image(writer.png, writer.info, image.size, rows.data(), target) ||
        target.memory_exhausted) {
        throw std::bad_alloc();
    }
    return std::move(target.bytes);
}

} // namespace zonegrid
