#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

/// One line of a text list, cut into its fields.
struct ListLine {
    std::size_t number = 0; ///< counted from 1, as editors do
    std::vector<std::string> fields;
};

/// The lines of a text file cut at white space. Blank lines and lines that start with '#' are left
/// out. Throws InputError if the file cannot be read or no line is left.
[[nodiscard]] std::vector<ListLine> read_text_list(const std::filesystem::path& file);

/// The same for a comma-separated table; spaces around the fields are removed.
[[nodiscard]] std::vector<ListLine> read_comma_list(const std::filesystem::path& file);

/// "file:line", as messages name a place.
[[nodiscard]] std::string place_of(const std::filesystem::path& file, std::size_t line_number);

/// The number in `text`; `what` names the field in the message. NaN and infinity are refused.
/// Throws InputError at `where`.
[[nodiscard]] double parse_number(std::string_view text, std::string_view what,
                                  const std::string& where);

/// True if `text` is a number as a whole (also NaN or infinity).
[[nodiscard]] bool is_number(std::string_view text);

/// Throws InputError at `where` unless `time_s` is later than `previous_s`.
void require_later(double previous_s, double time_s, const std::string& where);

} // namespace zonegrid
