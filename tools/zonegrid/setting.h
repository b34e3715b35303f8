#pragma once

#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

/// How values of one type are read from an argument and from a TOML file, and written as TOML.
/// Reading gives nothing if the form is wrong; `words` then says which form is right.
template <class Value>
struct ValueForm;

template <>
struct ValueForm<double> {
    static constexpr std::string_view words = "a number";
    static std::optional<double> from_text(std::string_view text);
    static std::optional<double> from_node(const toml::node& node);
    static std::string to_toml(double value);
};

template <>
struct ValueForm<int> {
    static constexpr std::string_view words = "a whole number";
    static std::optional<int> from_text(std::string_view text);
    static std::optional<int> from_node(const toml::node& node);
    static std::string to_toml(int value);
};

template <>
struct ValueForm<bool> {
    static constexpr std::string_view words = "true or false";
    static std::optional<bool> from_text(std::string_view text);
    static std::optional<bool> from_node(const toml::node& node);
    static std::string to_toml(bool value);
};

template <>
struct ValueForm<std::string> {
    static constexpr std::string_view words = "text in quotes";
    static std::optional<std::string> from_text(std::string_view text);
    static std::optional<std::string> from_node(const toml::node& node);
    static std::string to_toml(const std::string& value);
};

template <>
struct ValueForm<std::array<double, 4>> {
    static constexpr std::string_view words = "four numbers";
    static std::optional<std::array<double, 4>> from_text(std::string_view text);
    static std::optional<std::array<double, 4>> from_node(const toml::node& node);
    static std::string to_toml(const std::array<double, 4>& value);
};

/// Which values an option takes.
template <class Value>
struct Rule {
    std::function<bool(const Value&)> allows;
    std::string words; ///< completes "give ..."
};

/// One option of a command: the same on the command line, in a configuration file and in what
/// --dump-config prints. Made by `bind_setting`.
struct Setting {
    std::string name;        ///< without dashes
    std::string short_name;  ///< one letter, or empty
    std::string placeholder; ///< stands for the value in --help
    std::string help;
    bool positional = false;
    bool is_switch = false;
    int arguments = 1;

    /// Take the value from an argument or a node; `where` starts the message of the UsageError.
    std::function<void(const std::string& text, const std::string& where)> read_text;
    std::function<void(const toml::node& node, const std::string& where)> read_node;
    /// The value as TOML; empty if there is none.
    std::function<std::string()> to_toml;
};

/// The node as its author wrote it, more or less, for messages.
[[nodiscard]] std::string shown(const toml::node& node);

template <class Value>
struct Bound {
    using Type = Value;
};
template <class Value>
struct Bound<std::optional<Value>> {
    using Type = Value;
};

/// A setting that lives in `target`, a value or an optional value, which must outlive it.
template <class Target>
[[nodiscard]] Setting bind_setting(std::string name, std::string placeholder, std::string help,
                                   Target& target, Rule<typename Bound<Target>::Type> rule) {
    using Value = typename Bound<Target>::Type;
    using Form = ValueForm<Value>;
    Setting setting;
    setting.name = std::move(name);
    setting.placeholder = std::move(placeholder);
    setting.help = std::move(help);
    const auto store = [&target, rule](const std::optional<Value>& value, const std::string& text,
                                       const std::string& where) {
        if (!value || !rule.allows(*value)) {
            throw UsageError(fmt::format("{} is {}: give {}", where, text, rule.words));
        }
        target = *value;
    };
    setting.read_text = [store](const std::string& text, const std::string& where) {
        store(Form::from_text(text), text.empty() ? "empty" : text, where);
    };
    setting.read_node = [store](const toml::node& node, const std::string& where) {
        const std::optional<Value> value = Form::from_node(node);
        if (!value) {
            throw UsageError(
                fmt::format("{} is {}: it must be {}", where, shown(node), Form::words));
        }
        store(value, shown(node), where);
    };
    setting.to_toml = [&target] {
        if constexpr (std::is_same_v<Target, Value>) {
            return Form::to_toml(target);
        } else {
            return target ? Form::to_toml(*target) : std::string();
        }
    };
    return setting;
}

/// An option without a value, off unless given.
[[nodiscard]] Setting switch_setting(std::string name, std::string help, bool& target);

/// The rule "one of `choices`".
[[nodiscard]] Rule<std::string> one_of(std::vector<std::string> choices);

/// A rule for finite numbers.
[[nodiscard]] Rule<double> finite_where(std::function<bool(double)> allows, std::string words);

} // namespace zonegrid
