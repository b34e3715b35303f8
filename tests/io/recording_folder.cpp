#include "io/recording_folder.h"

#include <fmt/format.h>
#include <png.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace zonegrid::testing {
namespace {

void write_image(const std::filesystem::path& file, png_uint_32 format, int width_px, int height_px,
                 const void* pixels) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width_px);
    image.height = static_cast<png_uint_32>(height_px);
    image.format = format;
    if (png_image_write_to_file(&image, file.c_str(), 0, pixels, 0, nullptr) == 0) {
        throw std::runtime_error(image.message);
    }
}

} // namespace

RecordingFolder::RecordingFolder(const std::string& name) : path_(root_.path() / name) {
    std::filesystem::create_directories(path_);
}

std::filesystem::path RecordingFolder::write(const std::string& name, std::string_view text) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

std::filesystem::path RecordingFolder::write_floats(const std::string& name,
                                                    std::span<const float> values) const {
    std::string bytes(values.size_bytes(), '\0');
    std::memcpy(bytes.data(), values.data(), values.size_bytes());
    return write(name, bytes);
}

std::filesystem::path RecordingFolder::write_depth(const std::string& name, int width_px,
                                                   std::span<const std::uint16_t> values) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    write_image(file, PNG_FORMAT_LINEAR_Y, width_px, static_cast<int>(values.size()) / width_px,
                values.data());
    return file;
}

std::filesystem::path RecordingFolder::write_8_bit(const std::string& name, int width_px,
                                                   int height_px, bool in_colour) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    const std::vector<std::uint8_t> black(static_cast<std::size_t>(width_px * height_px * 3));
    write_image(file, in_colour ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY, width_px, height_px,
                black.data());
    return file;
}

std::filesystem::path RecordingFolder::write_npy(const std::string& name, const std::string& shape,
                                                 std::span<const float> values,
                                                 const std::string& type,
                                                 const std::string& fortran_order) const {
    std::string header = fmt::format("{{'descr': {}, 'fortran_order': {}, 'shape': {}, }}", type,
                                     fortran_order, shape);
    header.resize(117, ' ');
    header += '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size());
    bytes += '\0';
    bytes += header;
    const std::size_t start = bytes.size();
    bytes.resize(start + values.size_bytes());
    std::memcpy(bytes.data() + start, values.data(), values.size_bytes());
    return write(name, bytes);
}

std::string RecordingFolder::bytes(const std::string& name) const {
    std::ifstream stream(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void RecordingFolder::truncate(const std::string& name, std::size_t size) const {
    std::filesystem::resize_file(path_ / name, size);
}

} // namespace zonegrid::testing
