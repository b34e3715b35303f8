#include "io/pfm.h"

#include "io/file_bytes.h"
#include "io/float_bytes.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace zonegrid {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
    throw InputError(file.string(), problem, "write it again as a grey PFM ('Pf')");
}

/// Takes the next word off `text` together with the one white-space character behind it, which is
/// all that may stand between the header and the data.
std::string_view take_word(std::string_view& text, const std::filesystem::path& file) {
    constexpr std::string_view space = " \t\r\n";
    const std::size_t start = text.find_first_not_of(space);
    const std::size_t end = text.find_first_of(space, start);
    if (start == std::string_view::npos || end == std::string_view::npos) {
        refuse(file, "the PFM header is truncated");
    }
    const std::string_view word = text.substr(start, end - start);
    text.remove_prefix(end + 1);
    return word;
}

int take_size(std::string_view& text, const std::filesystem::path& file) {
    const double size = parse_number(take_word(text, file), "the PFM size", file.string());
    if (!(size >= 1.0 && size <= largest_image_px)) {
        refuse(file, fmt::format("the PFM size {} is outside 1 ... {}", size, largest_image_px));
    }
    return static_cast<int>(size);
}

} // namespace

PfmImage read_pfm(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string_view kind = take_word(text, file);
    if (kind != "Pf") {
        refuse(file, kind == "PF" ? "the PFM holds colours" : "the file is no PFM");
    }
    PfmImage image;
    image.size.width_px = take_size(text, file);
    image.size.height_px = take_size(text, file);
    const double scale = parse_number(take_word(text, file), "the PFM scale", file.string());
    const auto load = scale < 0.0 ? little_endian_float : big_endian_float;

    const auto width = static_cast<std::size_t>(image.size.width_px);
    const auto height = static_cast<std::size_t>(image.size.height_px);
    if (text.size() != width * height * sizeof(float)) {
        refuse(file, fmt::format("the PFM holds {} bytes, not the {} of {} x {} pixels",
                                 text.size(), width * height * sizeof(float), width, height));
    }
    const std::uint8_t* const data = bytes.data() + (bytes.size() - text.size());
    image.values.resize(width * height);
    for (std::size_t v = 0; v < height; ++v) { // the file's first row is the lowest
        const std::uint8_t* const row = data + (height - 1 - v) * width * sizeof(float);
        for (std::size_t u = 0; u < width; ++u) {
            image.values[v * width + u] = load(row + u * sizeof(float));
        }
    }
    return image;
}

} // namespace zonegrid
