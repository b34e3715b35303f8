#include "setting.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <sstream>
#include <system_error>
#include <utility>

namespace zonegrid {
namespace {

template <class Number>
std::optional<Number> parse_whole_text(std::string_view text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) {
        return std::nullopt;
    }
    return value;
}

std::vector<std::string_view> split_at_spaces(std::string_view text) {
    std::vector<std::string_view> fields;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(' '), text.size());
        if (length > 0) {
            fields.push_back(text.substr(0, length));
        }
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return fields;
}

/// All four, or nothing.
std::optional<std::array<double, 4>> gather(std::span<const std::optional<double>> values) {
    if (values.size() != 4 || !std::ranges::all_of(values, [](const auto& v) { return !!v; })) {
        return std::nullopt;
    }
    return std::array<double, 4>{*values[0], *values[1], *values[2], *values[3]};
}

} // namespace

std::optional<double> ValueForm<double>::from_text(std::string_view text) {
    return parse_whole_text<double>(text);
}

std::optional<double> ValueForm<double>::from_node(const toml::node& node) {
    return node.is_number() ? node.value<double>() : std::nullopt;
}

std::string ValueForm<double>::to_toml(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) {
        text += ".0"; // TOML would take it for a whole number
    }
    return text;
}

std::optional<int> ValueForm<int>::from_text(std::string_view text) {
    return parse_whole_text<int>(text);
}

std::optional<int> ValueForm<int>::from_node(const toml::node& node) {
    const auto* const whole = node.as_integer();
    if (whole == nullptr || !std::in_range<int>(whole->get())) {
        return std::nullopt;
    }
    return static_cast<int>(whole->get());
}

std::string ValueForm<int>::to_toml(int value) {
    return fmt::format("{}", value);
}

std::optional<bool> ValueForm<bool>::from_text(std::string_view text) {
    return text == "true" ? std::optional(true) : std::nullopt;
}

std::optional<bool> ValueForm<bool>::from_node(const toml::node& node) {
    return node.is_boolean() ? node.value<bool>() : std::nullopt;
}

std::string ValueForm<bool>::to_toml(bool value) {
    return value ? "true" : "false";
}

std::optional<std::string> ValueForm<std::string>::from_text(std::string_view text) {
    return std::string(text);
}

std::optional<std::string> ValueForm<std::string>::from_node(const toml::node& node) {
    return node.is_string() ? node.value<std::string>() : std::nullopt;
}

std::string ValueForm<std::string>::to_toml(const std::string& value) {
    return shown(toml::value<std::string>(value));
}

std::optional<std::array<double, 4>> ValueForm<std::array<double, 4>>::from_text(
    std::string_view text) {
    std::vector<std::optional<double>> values;
    for (const std::string_view field : split_at_spaces(text)) {
        values.push_back(ValueForm<double>::from_text(field));
    }
    return gather(values);
}

std::optional<std::array<double, 4>> ValueForm<std::array<double, 4>>::from_node(
    const toml::node& node) {
    std::vector<std::optional<double>> values;
    if (const toml::array* const array = node.as_array()) {
        for (const toml::node& entry : *array) {
            values.push_back(ValueForm<double>::from_node(entry));
        }
    }
    return gather(values);
}

std::string ValueForm<std::array<double, 4>>::to_toml(const std::array<double, 4>& value) {
    std::vector<std::string> texts;
    std::ranges::transform(value, std::back_inserter(texts), ValueForm<double>::to_toml);
    return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string shown(const toml::node& node) {
    if (node.is_table()) {
        return "a table";
    }
    std::ostringstream text;
    node.visit([&text](const auto& concrete) { text << concrete; });
    return text.str();
}

Setting switch_setting(std::string name, std::string help, bool& target) {
    Setting setting = bind_setting(std::move(name), "", std::move(help), target,
                                   {[](bool /*value*/) { return true; }, "true or false"});
    setting.is_switch = true;
    return setting;
}

Rule<std::string> one_of(std::vector<std::string> choices) {
    std::string words = fmt::format("{} or {}", fmt::join(choices.begin(), choices.end() - 1, ", "),
                                    choices.back());
    if (choices.size() == 1) {
        words = choices.front();
    }
    const auto allows = [choices = std::move(choices)](const std::string& value) {
        return std::ranges::find(choices, value) != choices.end();
    };
    return {allows, std::move(words)};
}

Rule<double> finite_where(std::function<bool(double)> allows, std::string words) {
    return {[allows = std::move(allows)](double value) {
                return std::isfinite(value) && allows(value);
            },
            std::move(words)};
}

} // namespace zonegrid
