#pragma once

#include "setting.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace zonegrid {

/// The settings of one command, in the order in which --help and --dump-config show them.
class SettingTable {
public:
    /// Starts a group of --help that the settings added next belong to.
    void start_group(std::string title) { group_ = std::move(title); }
    void add(Setting setting);

    /// Makes an option of each setting. Arguments are only noted; the table must stay where it is.
    void declare(CLI::App& command);

    /// Takes values from a TOML file. Throws UsageError naming file and line.
    void read_file(const std::filesystem::path& file);

    /// Takes the noted arguments; called after `read_file`, so that they win.
    void read_arguments();

    /// Names of the settings that arguments give, in their order.
    [[nodiscard]] std::vector<std::string> given() const;

    /// A configuration file that gives what the settings are now.
    [[nodiscard]] std::string to_toml() const;

private:
    struct Entry {
        Setting setting;
        std::string group;
    };

    [[nodiscard]] const Setting* find(std::string_view name) const;
    [[nodiscard]] std::string nearest_name(std::string_view name) const;
    void declare_one(CLI::App& command, const Entry& entry);

    std::vector<Entry> entries_;
    std::string group_;
    std::vector<std::pair<const Setting*, std::string>> arguments_;
};

} // namespace zonegrid
