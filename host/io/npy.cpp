#include "io/npy.h"

#include "io/file_bytes.h"
#include "io/float_bytes.h"
#include "io/little_endian.h"
#include "io/output_file.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace zonegrid {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
    throw InputError(file.string(), problem,
                     "write it with numpy.save(file, numpy.ascontiguousarray(array, '<f4'))");
}

/// The header's text and the bytes behind it.
struct NpyParts {
    std::string_view header;
    std::span<const std::uint8_t> data;
};

NpyParts split(std::span<const std::uint8_t> bytes, const std::filesystem::path& file) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!text.starts_with(magic) || bytes.size() < 12) {
        refuse(file, "the file is no NPY array");
    }
    const int version = bytes[6];
    if (version != 1 && version != 2) {
        refuse(file, fmt::format("NPY version {} is not supported (1 and 2 are)", version));
    }
    const std::size_t start = version == 1 ? 10 : 12;
    std::size_t length = bytes[8] + (std::size_t{bytes[9]} << 8);
    if (version == 2) {
        length += (std::size_t{bytes[10]} << 16) + (std::size_t{bytes[11]} << 24);
    }
    if (length > bytes.size() - start) {
        refuse(file, "the NPY header is truncated");
    }
    return {text.substr(start, length), bytes.subspan(start + length)};
}

/// The text after "'key':" in the header, without leading spaces.
std::string_view value_of(std::string_view header, std::string_view key,
                          const std::filesystem::path& file) {
    const std::size_t at = header.find(fmt::format("'{}':", key));
    if (at == std::string_view::npos) {
        refuse(file, fmt::format("the NPY header has no '{}'", key));
    }
    std::string_view value = header.substr(at + key.size() + 3);
    value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
    return value;
}

std::vector<std::size_t> shape_in(std::string_view text, const std::filesystem::path& file) {
    std::vector<std::size_t> shape;
    const std::size_t close = text.find(')');
    if (!text.starts_with('(') || close == std::string_view::npos) {
        refuse(file, "the NPY shape is malformed");
    }
    text = text.substr(1, close - 1);
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" ,"), text.size()));
        if (text.empty()) {
            return shape;
        }
        std::size_t length = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), length);
        if (error != std::errc{}) {
            refuse(file, "the NPY shape is malformed");
        }
        shape.push_back(length);
        text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    }
}

/// The number of values, or more than `largest` where there are more.
std::size_t count_of(std::span<const std::size_t> shape, std::size_t largest) {
    std::size_t count = 1;
    for (const std::size_t length : shape) {
        if (length > largest || count * length > largest) {
            return largest + 1; // count and length are below 2^48: the product cannot wrap unseen
        }
        count *= length;
    }
    return count;
}

} // namespace

NpyArray read_npy(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    const auto [header, data] = split(bytes, file);
    const std::string_view type = value_of(header, "descr", file);
    if (!type.starts_with("'<f4'")) {
        refuse(file, fmt::format("the NPY type is {}, not little-endian float32",
                                 type.substr(0, type.find(','))));
    }
    if (!value_of(header, "fortran_order", file).starts_with("False")) {
        refuse(file, "the NPY array is in Fortran order");
    }
    NpyArray array;
    array.shape = shape_in(value_of(header, "shape", file), file);
    const std::size_t held = data.size() / sizeof(float);
    const std::size_t count = count_of(array.shape, held);
    if (count != held || data.size() % sizeof(float) != 0) {
        refuse(file, fmt::format("the NPY shape ({}) does not fit the {} bytes of data",
                                 fmt::join(array.shape, ", "), data.size()));
    }
    array.values.reserve(count);
    for (std::size_t at = 0; at < data.size(); at += sizeof(float)) {
        array.values.push_back(little_endian_float(data.data() + at));
    }
    return array;
}

void write_npy(const std::filesystem::path& file, const NpyArray& array) {
    constexpr std::size_t alignment = 64; // of the data, as the format asks for
    const std::size_t count = count_of(array.shape, array.values.size());
    if (array.shape.empty() || count != array.values.size()) {
        throw UsageError(fmt::format("{}: the shape ({}) does not fit {} values", file.string(),
                                     fmt::join(array.shape, ", "), array.values.size()));
    }
    std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (";
    for (const std::size_t length : array.shape) {
        header += fmt::format("{}, ", length);
    }
    header += "), }";
    while ((magic.size() + 4 + header.size() + 1) % alignment != 0) {
        header += ' ';
    }
    header += '\n';
    std::vector<std::uint8_t> bytes(magic.begin(), magic.end());
    bytes.insert(bytes.end(), {1, 0});
    append_little_endian(bytes, static_cast<std::uint16_t>(header.size()));
    bytes.insert(bytes.end(), header.begin(), header.end());
    for (const float value : array.values) {
        append_little_endian(bytes, std::bit_cast<std::uint32_t>(value));
    }
    OutputFile output(file);
    output.write(bytes);
    output.close();
}

} // namespace zonegrid
