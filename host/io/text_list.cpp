#include "io/text_list.h"

#include "io/file_bytes.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <system_error>

namespace zonegrid {
namespace {

constexpr std::string_view white_space = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(white_space);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(white_space) - first + 1);
}

std::vector<std::string> cut_at_white_space(std::string_view line) {
    std::vector<std::string> fields;
    for (std::size_t at = line.find_first_not_of(white_space); at != std::string_view::npos;) {
        const std::size_t end = line.find_first_of(white_space, at);
        fields.emplace_back(line.substr(at, end - at));
        at = line.find_first_not_of(white_space, end);
    }
    return fields;
}

std::vector<std::string> cut_at_commas(std::string_view line) {
    std::vector<std::string> fields;
    for (std::size_t comma = line.find(','); comma != std::string_view::npos;
         comma = line.find(',')) {
        fields.emplace_back(trimmed(line.substr(0, comma)));
        line.remove_prefix(comma + 1);
    }
    fields.emplace_back(trimmed(line));
    return fields;
}

template <typename Cut>
std::vector<ListLine> read_list(const std::filesystem::path& file, Cut cut) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (rest.starts_with("\xEF\xBB\xBF")) { // byte order mark, as spreadsheets write it
        rest.remove_prefix(3);
    }
    std::vector<ListLine> lines;
    for (std::size_t number = 1; !rest.empty(); ++number) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = trimmed(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (!line.empty() && line.front() != '#') {
            lines.push_back({number, cut(line)});
        }
    }
    if (lines.empty()) {
        throw InputError(file.string(), "the list holds no line besides comments",
                         "copy it again from its source");
    }
    return lines;
}

std::optional<double> number_in(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) {
        return std::nullopt;
    }
    return value;
}

} // namespace

std::vector<ListLine> read_text_list(const std::filesystem::path& file) {
    return read_list(file, cut_at_white_space);
}

std::vector<ListLine> read_comma_list(const std::filesystem::path& file) {
    return read_list(file, cut_at_commas);
}

std::string place_of(const std::filesystem::path& file, std::size_t line_number) {
    return fmt::format("{}:{}", file.string(), line_number);
}

double parse_number(std::string_view text, std::string_view what, const std::string& where) {
    const std::optional<double> value = number_in(text);
    if (!value) {
        throw InputError(where, fmt::format("{} is '{}', which is no number", what, text),
                         "correct or remove the line");
    }
    if (!std::isfinite(*value)) {
        throw InputError(where, fmt::format("{} is '{}'", what, text),
                         "a finite number is needed: correct or remove the line");
    }
    return *value;
}

bool is_number(std::string_view text) {
    return number_in(text).has_value();
}

void require_later(double previous_s, double time_s, const std::string& where) {
    if (time_s > previous_s) {
        return;
    }
    throw InputError(where,
                     fmt::format("time {:.6f} s {} {:.6f} s on the line before", time_s,
                                 time_s < previous_s ? "is earlier than" : "doubles", previous_s),
                     "sort the list by time and keep one line a time");
}

} // namespace zonegrid
