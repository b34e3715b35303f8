#pragma once

#include "io/text_list.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

/// A comma-separated table whose first line names its columns, in any order. Columns that nobody
/// asks for are an error, so a misspelt name cannot pass unnoticed.
class CsvTable {
public:
    /// Throws InputError if the file is unreadable, a name comes twice, there is no line below the
    /// header, or a line has more or fewer fields than it.
    explicit CsvTable(std::filesystem::path file);

    [[nodiscard]] std::size_t row_count() const { return lines_.size() - 1; }
    /// "file:line" of a row, for messages.
    [[nodiscard]] std::string place(std::size_t row) const;

    [[nodiscard]] std::string place_of_header() const;

    /// The column's index, if there is one.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name);
    /// The column's index. Throws InputError if there is none.
    [[nodiscard]] std::size_t need(std::string_view name);
    /// The indices of columns that are given all or not at all.
    /// Throws InputError if some are given and others not.
    template <std::size_t count>
    [[nodiscard]] std::optional<std::array<std::size_t, count>> find_all(
        const std::array<std::string_view, count>& names) {
        std::array<std::size_t, count> columns{};
        bool any = false;
        for (const std::string_view name : names) {
            any = find(name).has_value() || any;
        }
        if (!any) {
            return std::nullopt;
        }
        for (std::size_t index = 0; index < count; ++index) {
            columns[index] = need(names[index]);
        }
        return columns;
    }
    /// Throws InputError if there is a column that was not asked for.
    void require_all_read() const;

    [[nodiscard]] const std::string& text(std::size_t row, std::size_t column) const {
        return lines_[row + 1].fields[column];
    }
    /// Throws InputError if the field is no finite number.
    [[nodiscard]] double number(std::size_t row, std::size_t column) const;
    [[nodiscard]] Eigen::Vector3d vector(std::size_t row,
                                         const std::array<std::size_t, 3>& columns) const;

private:
    std::filesystem::path file_;
    std::vector<ListLine> lines_; ///< the header first
    std::set<std::string, std::less<>> asked_;
};

} // namespace zonegrid
