#include "truth/surfaces_ply.h"

#include "io/file_bytes.h"
#include "io/float_bytes.h"
#include "io/little_endian.h"
#include "io/output_file.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

namespace zonegrid {
namespace {

constexpr std::size_t vertex_bytes = 12;
constexpr std::size_t triangle_bytes = 13;

std::string header_text(std::size_t vertices, std::size_t triangles) {
    return fmt::format(
        "ply\n"
        "format binary_little_endian 1.0\n"
        "comment true surfaces, north-east-down in metres\n"
        "element vertex {}\n"
        "property float x\n"
        "property float y\n"
        "property float z\n"
        "element face {}\n"
        "property list uchar int vertex_indices\n"
        "end_header\n",
        vertices, triangles);
}

/// The number after `words` in the header, if it is there.
std::optional<std::size_t> count_after(std::string_view header, std::string_view words) {
    const std::size_t at = header.find(words);
    if (at == std::string_view::npos) {
        return std::nullopt;
    }
    std::size_t count = 0;
    const char* const first = header.data() + at + words.size();
    const auto [stop, error] = std::from_chars(first, header.data() + header.size(), count);
    return error == std::errc{} ? std::optional(count) : std::nullopt;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
    throw InputError(file.string(), problem, "simulate the scene again");
}

} // namespace

void write_surfaces_ply(const std::filesystem::path& file, const Surfaces& surfaces) {
    OutputFile output(file);
    output.write(header_text(surfaces.vertices_m.size(), surfaces.triangles.size()));
    std::vector<std::uint8_t> bytes;
    for (const Eigen::Vector3f& vertex : surfaces.vertices_m) {
        bytes.clear();
        for (const float value : vertex) {
            append_little_endian(bytes, std::bit_cast<std::uint32_t>(value));
        }
        output.write(bytes);
    }
    for (const auto& triangle : surfaces.triangles) {
        bytes.assign(1, 3);
        for (const std::uint32_t index : triangle) {
            append_little_endian(bytes, index);
        }
        output.write(bytes);
    }
    output.close();
}

Surfaces read_surfaces_ply(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string_view start = text.substr(0, 1024); // the header is shorter
    const std::optional<std::size_t> vertices = count_after(start, "element vertex ");
    const std::optional<std::size_t> triangles = count_after(start, "element face ");
    if (!vertices || !triangles || !start.starts_with(header_text(*vertices, *triangles))) {
        refuse(file, "the header is not the one that zonegrid writes");
    }
    const std::size_t header_bytes = header_text(*vertices, *triangles).size();
    const std::size_t rest = bytes.size() - header_bytes;
    // Counts beyond the file's size would overflow the product below.
    if (*vertices > bytes.size() || *triangles > bytes.size() ||
        rest != *vertices * vertex_bytes + *triangles * triangle_bytes) {
        refuse(file, fmt::format("{} bytes follow the header, which {} vertices and {} triangles "
                                 "do not fill exactly",
                                 rest, *vertices, *triangles));
    }
    Surfaces surfaces;
    surfaces.vertices_m.reserve(*vertices);
    surfaces.triangles.reserve(*triangles);
    const std::uint8_t* at = bytes.data() + header_bytes;
    for (std::size_t i = 0; i < *vertices; ++i, at += vertex_bytes) {
        surfaces.vertices_m.emplace_back(little_endian_float(at), little_endian_float(at + 4),
                                         little_endian_float(at + 8));
    }
    for (std::size_t i = 0; i < *triangles; ++i, at += triangle_bytes) {
        if (*at != 3) {
            refuse(file, fmt::format("face {} has {} corners in place of 3", i, *at));
        }
        const auto index = [&](std::size_t corner) {
            return from_little_endian<std::uint32_t>(std::span(at + 1 + 4 * corner, 4));
        };
        surfaces.triangles.push_back({index(0), index(1), index(2)});
    }
    return surfaces;
}

} // namespace zonegrid
