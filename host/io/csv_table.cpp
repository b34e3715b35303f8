#include "io/csv_table.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace zonegrid {

CsvTable::CsvTable(std::filesystem::path file)
    : file_(std::move(file)), lines_(read_comma_list(file_)) {
    const std::vector<std::string>& names = lines_.front().fields;
    for (const std::string& name : names) {
        if (std::ranges::count(names, name) > 1) {
            throw InputError(place_of_header(), fmt::format("column '{}' comes twice", name),
                             "keep one of them");
        }
    }
    if (lines_.size() == 1) {
        throw InputError(file_.string(), "there is no line below the header",
                         "copy the file again from its source");
    }
    for (const ListLine& line : lines_) {
        if (line.fields.size() != names.size()) {
            throw InputError(place_of(file_, line.number),
                             fmt::format("{} fields where the header names {}", line.fields.size(),
                                         names.size()),
                             "correct or remove the line");
        }
    }
}

std::string CsvTable::place(std::size_t row) const {
    return place_of(file_, lines_[row + 1].number);
}

std::string CsvTable::place_of_header() const {
    return place_of(file_, lines_.front().number);
}

std::optional<std::size_t> CsvTable::find(std::string_view name) {
    asked_.emplace(name);
    const std::vector<std::string>& names = lines_.front().fields;
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - names.begin());
}

std::size_t CsvTable::need(std::string_view name) {
    const std::optional<std::size_t> column = find(name);
    if (!column) {
        throw InputError(place_of_header(), fmt::format("there is no column '{}'", name),
                         "name it in the header line");
    }
    return *column;
}

void CsvTable::require_all_read() const {
    for (const std::string& name : lines_.front().fields) {
        if (!asked_.contains(name)) {
            throw InputError(
                place_of_header(), fmt::format("column '{}' is unknown or does not apply", name),
                fmt::format("correct or remove it; known here: {}", fmt::join(asked_, ", ")));
        }
    }
}

double CsvTable::number(std::size_t row, std::size_t column) const {
    return parse_number(text(row, column), lines_.front().fields[column], place(row));
}

Eigen::Vector3d CsvTable::vector(std::size_t row, const std::array<std::size_t, 3>& columns) const {
    return {number(row, columns[0]), number(row, columns[1]), number(row, columns[2])};
}

} // namespace zonegrid
