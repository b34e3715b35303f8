#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

/// One table of a description file, read key by key. What is never asked for is an error, so a
/// misspelt key cannot pass unnoticed. All errors are InputErrors that name file, line and key.
class DescriptionTable {
public:
    /// `name` is the table's name in messages; empty for the whole file.
    DescriptionTable(const toml::table& table, std::filesystem::path file, std::string name);

    [[nodiscard]] std::optional<DescriptionTable> table(std::string_view key);
    [[nodiscard]] std::optional<double> number(std::string_view key); ///< finite
    [[nodiscard]] double needed_number(std::string_view key);
    [[nodiscard]] double positive_number(std::string_view key); ///< needed and above 0
    [[nodiscard]] int needed_size(std::string_view key);        ///< 1 ... 16384
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view key);
    [[nodiscard]] std::optional<std::string> text(std::string_view key);
    [[nodiscard]] std::string needed_text(std::string_view key);

    /// Throws if the table holds a key that was not asked for.
    void require_all_read() const;

    /// Throws the InputError of the given key.
    [[noreturn]] void refuse(std::string_view key, const std::string& problem,
                             const std::string& remedy) const;

private:
    [[nodiscard]] const toml::node* find(std::string_view key);
    [[noreturn]] void refuse_absent(std::string_view key) const;

    const toml::table* table_;
    std::filesystem::path file_;
    std::string name_;
    std::set<std::string, std::less<>> asked_;
};

} // namespace zonegrid
