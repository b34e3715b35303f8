#pragma once

#include <toml++/toml.h>

#include <array>
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
    /// `name` is the table's name in messages; empty for the whole file. `page` is where the keys
    /// are listed.
    DescriptionTable(const toml::table& table, std::filesystem::path file, std::string name,
                     std::string page = "docs/formats.md");

    [[nodiscard]] std::optional<DescriptionTable> table(std::string_view key);
    /// The tables of [[key]] in the file's order; none if the key is absent.
    [[nodiscard]] std::vector<DescriptionTable> tables(std::string_view key);
    [[nodiscard]] std::optional<double> number(std::string_view key); ///< finite
    [[nodiscard]] double needed_number(std::string_view key);
    [[nodiscard]] double positive_number(std::string_view key); ///< needed and above 0
    [[nodiscard]] int needed_size(std::string_view key);        ///< 1 ... 16384
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view key);
    /// One finite number, which is both ends, or [least, most] with least <= most.
    [[nodiscard]] std::optional<std::array<double, 2>> range(std::string_view key);
    [[nodiscard]] std::optional<bool> flag(std::string_view key);
    [[nodiscard]] std::optional<std::string> text(std::string_view key);
    [[nodiscard]] std::string needed_text(std::string_view key);

    /// Throws if the table holds a key that was not asked for.
    void require_all_read() const;

    /// Throws the InputError of the given key.
    [[noreturn]] void refuse(std::string_view key, const std::string& problem,
                             const std::string& remedy) const;
    /// The same for a needed key that is not there.
    [[noreturn]] void refuse_absent(std::string_view key) const;
    /// "file:line" of the table, for messages.
    [[nodiscard]] std::string place() const;
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    [[nodiscard]] std::string name_within(std::string_view key) const;
    [[nodiscard]] const toml::node* find(std::string_view key);
    const toml::table* table_;
    std::filesystem::path file_;
    std::string name_;
    std::string page_;
    std::set<std::string, std::less<>> asked_;
};

} // namespace zonegrid
