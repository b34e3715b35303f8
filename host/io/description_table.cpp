#include "io/description_table.h"

#include "io/depth_png.h"
#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>

namespace zonegrid {

DescriptionTable::DescriptionTable(const toml::table& table, std::filesystem::path file,
                                   std::string name, std::string page)
    : table_(&table), file_(std::move(file)), name_(std::move(name)), page_(std::move(page)) {}

std::string DescriptionTable::place() const {
    return place_of(file_, table_->source().begin.line);
}

std::string DescriptionTable::name_within(std::string_view key) const {
    return fmt::format("{}{}{}", name_, name_.empty() ? "" : ".", key);
}

const toml::node* DescriptionTable::find(std::string_view key) {
    asked_.emplace(key);
    return table_->get(key);
}

void DescriptionTable::refuse(std::string_view key, const std::string& problem,
                              const std::string& remedy) const {
    const toml::node* const node = table_->get(key);
    const std::size_t line = (node == nullptr ? *table_ : *node).source().begin.line;
    throw InputError(place_of(file_, line), fmt::format("{} {}", name_within(key), problem),
                     remedy);
}

void DescriptionTable::refuse_absent(std::string_view key) const {
    refuse(key, "is missing", fmt::format("add it; {} has a complete example", page_));
}

std::optional<DescriptionTable> DescriptionTable::table(std::string_view key) {
    const toml::node* const node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    if (!node->is_table()) {
        refuse(key, "is a value", fmt::format("write it as a table: [{}]", key));
    }
    return DescriptionTable(*node->as_table(), file_, name_within(key), page_);
}

std::vector<DescriptionTable> DescriptionTable::tables(std::string_view key) {
    std::vector<DescriptionTable> found;
    const toml::node* const node = find(key);
    if (node == nullptr) {
        return found;
    }
    const bool is_list = node->is_array();
    if (is_list) {
        for (const toml::node& item : *node->as_array()) {
            if (item.is_table()) {
                found.emplace_back(*item.as_table(), file_, name_within(key), page_);
            }
        }
    }
    if (!is_list || found.size() != node->as_array()->size() || found.empty()) {
        refuse(key, "is no list of tables", fmt::format("write each as [[{}]]", name_within(key)));
    }
    return found;
}

std::optional<double> DescriptionTable::number(std::string_view key) {
    const toml::node* const node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) {
        refuse(key, "is no finite number", "write a number without quotes");
    }
    return value;
}

double DescriptionTable::needed_number(std::string_view key) {
    const std::optional<double> value = number(key);
    if (!value) {
        refuse_absent(key);
    }
    return *value;
}

double DescriptionTable::positive_number(std::string_view key) {
    const double value = needed_number(key);
    if (!(value > 0.0)) {
        refuse(key, fmt::format("is {}", value), "a number above 0 is needed");
    }
    return value;
}

int DescriptionTable::needed_size(std::string_view key) {
    const double value = needed_number(key);
    if (!(value >= 1.0 && value <= largest_image_px) || value != std::floor(value)) {
        refuse(key, fmt::format("is {}", value),
               fmt::format("a whole number from 1 to {} is needed", largest_image_px));
    }
    return static_cast<int>(value);
}

std::optional<std::vector<double>> DescriptionTable::numbers(std::string_view key) {
    const toml::node* const node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    std::vector<double> values;
    if (!node->is_array()) {
        refuse(key, "is no list", "write numbers in brackets: [0, 65535]");
    }
    for (const toml::node& item : *node->as_array()) {
        const std::optional<double> value = item.is_number() ? item.value<double>() : std::nullopt;
        if (!value) {
            refuse(key, "holds something that is no number",
                   "write numbers in brackets: [0, 65535]");
        }
        values.push_back(*value);
    }
    return values;
}

std::optional<std::array<double, 2>> DescriptionTable::range(std::string_view key) {
    const toml::node* const node = find(key);
    if (node != nullptr && node->is_array()) {
        const std::vector<double> values = *numbers(key);
        if (values.size() != 2 || !std::isfinite(values[0]) || !std::isfinite(values[1]) ||
            values[0] > values[1]) {
            refuse(key, "is no range", "write one number or [least, most]");
        }
        return std::array{values[0], values[1]};
    }
    const std::optional<double> value = number(key);
    return value ? std::optional(std::array{*value, *value}) : std::nullopt;
}

std::optional<bool> DescriptionTable::flag(std::string_view key) {
    const toml::node* const node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    if (!node->is_boolean()) {
        refuse(key, "is neither true nor false", "write true or false without quotes");
    }
    return node->value<bool>();
}

std::optional<std::string> DescriptionTable::text(std::string_view key) {
    const toml::node* const node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    if (!node->is_string()) {
        refuse(key, "is no text", "write it in quotes");
    }
    return node->value<std::string>();
}

std::string DescriptionTable::needed_text(std::string_view key) {
    std::optional<std::string> value = text(key);
    if (!value) {
        refuse_absent(key);
    }
    return *std::move(value);
}

void DescriptionTable::require_all_read() const {
    for (const auto& [key, node] : *table_) {
        if (!asked_.contains(key.str())) {
            refuse(key.str(), "is unknown or does not apply here",
                   fmt::format("correct or remove it; known here: {}", fmt::join(asked_, ", ")));
        }
    }
}

} // namespace zonegrid
