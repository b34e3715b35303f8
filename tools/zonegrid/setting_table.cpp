#include "setting_table.h"

#include <algorithm>
#include <numeric>
#include <system_error>

namespace zonegrid {
namespace {

/// How many letters to change, add or leave out to make one word of the other.
std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (const char letter : from) {
        std::size_t diagonal = row[0]++;
        for (std::size_t i = 0; i < to.size(); ++i) {
            const std::size_t changed = diagonal + (letter == to[i] ? 0 : 1);
            diagonal = row[i + 1];
            row[i + 1] = std::min({changed, row[i] + 1, row[i + 1] + 1});
        }
    }
    return row.back();
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " ") + word;
    }
    return text;
}

std::string place_in(const std::filesystem::path& file, const toml::source_region& region) {
    return fmt::format("{}:{}", file.string(), region.begin.line);
}

} // namespace

void SettingTable::add(Setting setting) {
    entries_.push_back({std::move(setting), group_});
}

void SettingTable::declare(CLI::App& command) {
    for (const Entry& entry : entries_) {
        declare_one(command, entry);
    }
}

void SettingTable::declare_one(CLI::App& command, const Entry& entry) {
    const Setting* const setting = &entry.setting;
    const std::string default_value = setting->to_toml();
    std::string help = setting->help;
    if (!default_value.empty() && default_value != "''" && !setting->is_switch) {
        help += fmt::format(" (default {})", default_value);
    }
    std::string names = setting->positional ? setting->placeholder : "--" + setting->name;
    if (!setting->short_name.empty()) {
        names = fmt::format("-{},{}", setting->short_name, names);
    }
    if (setting->is_switch) {
        command
            .add_flag_callback(
                names, [this, setting] { arguments_.emplace_back(setting, "true"); }, help)
            ->group(entry.group);
        return;
    }
    const auto note = [this, setting](const CLI::results_t& results) {
        arguments_.emplace_back(setting, joined(results));
        return true;
    };
    command.add_option(names, note, help)
        ->type_name(setting->positional ? "" : setting->placeholder)
        ->type_size(setting->arguments)
        ->group(entry.group);
}

void SettingTable::read_file(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw UsageError(
            fmt::format("--config {}: there is no such file; name a TOML file, such "
                        "as --dump-config prints",
                        file.string()));
    }
    toml::table table;
    try {
        table = toml::parse_file(file.string());
    } catch (const toml::parse_error& problem) {
        throw UsageError(fmt::format("{}: {}; correct the TOML", place_in(file, problem.source()),
                                     problem.description()));
    }
    for (const auto& [key, node] : table) {
        const std::string where = place_in(file, key.source());
        const Setting* const setting = find(key.str());
        if (setting == nullptr) {
            throw UsageError(fmt::format("{}: '{}' is no setting; {}", where, key.str(),
                                         nearest_name(key.str())));
        }
        setting->read_node(node, fmt::format("{}: {}", where, setting->name));
    }
}

void SettingTable::read_arguments() {
    for (const auto& [setting, text] : arguments_) {
        setting->read_text(text, setting->positional ? setting->placeholder : "--" + setting->name);
    }
}

std::vector<std::string> SettingTable::given() const {
    std::vector<std::string> names;
    for (const auto& [setting, text] : arguments_) {
        names.push_back(setting->name);
    }
    return names;
}

std::string SettingTable::to_toml() const {
    std::string text;
    for (const auto& [setting, group] : entries_) {
        const std::string value = setting.to_toml();
        text += value.empty() ? fmt::format("# {} is not set\n", setting.name)
                              : fmt::format("{} = {}\n", setting.name, value);
    }
    return text;
}

const Setting* SettingTable::find(std::string_view name) const {
    const auto found = std::ranges::find(
        entries_, name, [](const Entry& entry) { return std::string_view(entry.setting.name); });
    return found == entries_.end() ? nullptr : &found->setting;
}

std::string SettingTable::nearest_name(std::string_view name) const {
    constexpr std::size_t furthest = 3;
    const auto distance = [name](const Entry& entry) {
        return edit_distance(name, entry.setting.name);
    };
    const auto nearest = std::ranges::min_element(entries_, {}, distance);
    if (distance(*nearest) <= furthest) {
        return fmt::format("did you mean '{}'?", nearest->setting.name);
    }
    return "--dump-config prints all of them";
}

} // namespace zonegrid
