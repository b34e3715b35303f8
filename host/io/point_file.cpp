#include "io/point_file.h"

#include "io/file_bytes.h"
#include "io/float_bytes.h"
#include "io/npy.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace zonegrid {
namespace {

std::size_t length_of(PointFields fields) {
    return fields == PointFields::xyz ? 3 : 4;
}

std::vector<Eigen::Vector3f> read_binary_points(const std::filesystem::path& file,
                                                PointFields fields) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    const std::size_t stride = length_of(fields) * sizeof(float);
    if (bytes.size() % stride != 0) {
        throw InputError(
            file.string(),
            fmt::format("{} bytes are no whole number of points of {} bytes", bytes.size(), stride),
            "the file is truncated: copy it again from its source");
    }
    std::vector<Eigen::Vector3f> points;
    points.reserve(bytes.size() / stride);
    for (std::size_t at = 0; at < bytes.size(); at += stride) {
        points.emplace_back(little_endian_float(bytes.data() + at),
                            little_endian_float(bytes.data() + at + 4),
                            little_endian_float(bytes.data() + at + 8));
    }
    return points;
}

std::vector<Eigen::Vector3f> read_text_points(const std::filesystem::path& file,
                                              PointFields fields) {
    std::vector<Eigen::Vector3f> points;
    for (const ListLine& line : read_text_list(file)) {
        const std::string where = place_of(file, line.number);
        if (line.fields.size() != length_of(fields)) {
            throw InputError(where,
                             fmt::format("{} fields where a point has {}", line.fields.size(),
                                         length_of(fields)),
                             "the file is truncated or no scan: copy it again from its source");
        }
        points.emplace_back(static_cast<float>(parse_number(line.fields[0], "x", where)),
                            static_cast<float>(parse_number(line.fields[1], "y", where)),
                            static_cast<float>(parse_number(line.fields[2], "z", where)));
    }
    return points;
}

std::vector<Eigen::Vector3f> read_npy_points(const std::filesystem::path& file) {
    const NpyArray array = read_npy(file);
    if (array.shape.size() != 2 || array.shape[1] != 3 || array.shape[0] == 0) {
        throw InputError(file.string(),
                         fmt::format("the NPY shape is ({})", fmt::join(array.shape, ", ")),
                         "a scan has the shape N x 3 with at least one point");
    }
    std::vector<Eigen::Vector3f> points;
    points.reserve(array.shape[0]);
    for (std::size_t at = 0; at < array.values.size(); at += 3) {
        points.emplace_back(array.values[at], array.values[at + 1], array.values[at + 2]);
    }
    return points;
}

} // namespace

std::vector<Eigen::Vector3f> read_points(const std::filesystem::path& file, PointFields fields) {
    const std::filesystem::path ending = file.extension();
    if (ending == ".npy") {
        return read_npy_points(file);
    }
    if (ending == ".txt") {
        return read_text_points(file, fields);
    }
    if (ending == ".bin") {
        return read_binary_points(file, fields);
    }
    throw InputError(file.string(), "the name's ending is no scan format",
                     "scans end in .npy, .bin or .txt");
}

} // namespace zonegrid
