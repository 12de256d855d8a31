#include "pipeline/formats/toml/toml_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <tuple>

#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/text/stoppable_text.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_text.h"

namespace pipeline {
namespace {

std::string described(const toml::node& node) {
    if (const auto* value = node.as_string()) return inQuotes(value->get());
    if (const auto* value = node.as_integer()) return fmt::format("{}", value->get());
    if (const auto* value = node.as_floating_point())
        return std::isfinite(value->get()) ? shortestText(value->get()) : "not finite";
    if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
    if (const auto* value = node.as_array()) return fmt::format("an array of {}", value->size());
    if (node.is_table()) return "a table";
    return "a date or a time";
}

std::string oneOf(std::span<const std::string_view> choices) {
    std::string text;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
        text += fmt::format("\"{}\"", choices[i]);
    }
    return text;
}

std::optional<double> finite(const toml::node& node) {
    if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
    const auto* real = node.as_floating_point();
    return real && std::isfinite(real->get()) ? std::optional(real->get()) : std::nullopt;
}

std::string range(double min, double max) { return fmt::format("{} to {}", shortestText(min), shortestText(max)); }

}  // namespace

Result<toml::table> parseToml(const SourceText& source) {
    if (source.text.size() > kMaxTomlBytes)
        return Error{{source.name, 0, 0},
                     fmt::format("the file is larger than {} bytes", groupedDigits(kMaxTomlBytes)),
                     "a smaller file"};
    if (const auto stray = strayCharacter(source.text, source.progress.stop))
        return Error{{source.name, stray->line, stray->column},
                     "this is not TOML: a character that is not ASCII stands outside quotes and comments",
                     "a string in quotes"};
    if (const auto deep = deepKey(source.text, source.progress.stop))
        return Error{{source.name, deep->line, deep->column},
                     fmt::format("this key has more than {} parts", kMostKeyParts),
                     "a key that a scene has"};
    StoppableBuffer bytes(source.text, source.progress.stop);
    std::istream stream(&bytes);
    toml::parse_result parsed = toml::parse(stream);
    if (source.progress.stop.stop_requested()) return readingStopped(source.name);
    if (!parsed) {
        const toml::source_position at = parsed.error().source().begin;
        return Error{{source.name, static_cast<int>(at.line), static_cast<int>(at.column)},
                     fmt::format("this is not TOML: {}", escaped(parsed.error().description())),
                     {}};
    }
    return std::move(parsed).table();
}

std::vector<TomlEntry> inFileOrder(const toml::table& table) {
    std::vector<TomlEntry> entries;
    entries.reserve(table.size());
    for (const auto& [key, node] : table) entries.push_back({&key, &node});
    std::ranges::sort(entries, {}, [](const TomlEntry& entry) {
        const toml::source_position at = entry.key->source().begin;
        return std::pair(at.line, at.column);
    });
    return entries;
}

std::optional<double> TomlValues::number(const toml::node& node, const std::string& path, double min, double max) {
    const std::optional<double> value = finite(node);
    if (value && *value >= min && *value <= max) return value;
    refuse(node, path, fmt::format("a number from {}", range(min, max)));
    return {};
}

std::optional<double> TomlValues::wholeNumber(const toml::node& node, const std::string& path, double min, double max) {
    const std::optional<double> value = finite(node);
    if (value && *value == std::trunc(*value) && *value >= min && *value <= max) return value;
    refuse(node, path, fmt::format("a whole number from {}", range(min, max)));
    return {};
}

std::optional<std::string> TomlValues::text(const toml::node& node, const std::string& path) {
    if (const auto* value = node.as_string()) return value->get();
    refuse(node, path, "a string");
    return {};
}

std::optional<std::string> TomlValues::name(const toml::node& node, const std::string& path) {
    std::optional<std::string> found = text(node, path);
    if (!found || isPrintable(*found)) return found;
    fail(node.source(), path + " is " + quotedInput(*found), "one line without control characters");
    return {};
}

std::optional<std::size_t> TomlValues::choice(const toml::node& node, const std::string& path,
                                              std::span<const std::string_view> choices) {
    const auto* value = node.as_string();
    const auto found = value ? std::ranges::find(choices, std::string_view(value->get())) : choices.end();
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    refuse(node, path, oneOf(choices));
    return {};
}

std::optional<std::vector<double>> TomlValues::numbers(const toml::node& node, const std::string& path,
                                                       std::size_t count, double min, double max) {
    const toml::array* array = node.as_array();
    if (!array || array->size() != count) {
        const std::string found = array ? fmt::format("{} is an array of {}", path, array->size())
                                        : fmt::format("{} is {}", path, described(node));
        fail(node.source(), found, fmt::format("an array of {} numbers from {}", count, range(min, max)));
        return {};
    }
    std::vector<double> values;
    for (const toml::node& element : *array)
        if (const auto value = number(element, path, min, max)) values.push_back(*value);
    return values.size() == count ? std::optional(values) : std::nullopt;
}

std::optional<std::vector<int>> TomlValues::wholeNumbers(const toml::node& node, const std::string& path,
                                                         std::size_t count, int min, int max) {
    const auto values = numbers(node, path, count, min, max);
    if (!values) return {};
    std::vector<int> whole(values->begin(), values->end());
    if (std::ranges::equal(whole, *values)) return whole;
    refuse(node, path, fmt::format("whole numbers from {}", range(min, max)));
    return {};
}

const toml::table* TomlValues::table(const toml::node& node, const std::string& path) {
    if (!node.is_table()) refuse(node, path, "a table");
    return node.as_table();
}

std::vector<const toml::table*> TomlValues::tables(const toml::node& node, const std::string& path, std::size_t most) {
    const toml::array* array = node.as_array();
    if (!array || array->size() > most) {
        fail(node.source(),
             array ? fmt::format("{} {}s", array->size(), path) : fmt::format("{} is {}", path, described(node)),
             fmt::format("at most {} tables [[{}]]", most, path));
        return {};
    }
    std::vector<const toml::table*> found;
    for (const toml::node& element : *array)
        if (const toml::table* one = table(element, path)) found.push_back(one);
    return found;
}

void TomlValues::setting(const toml::node& node, const std::string& path, const Setting& row, Scene& scene,
                         std::size_t index) {
    switch (row.kind) {
        case SettingKind::Choice:
            if (const auto value = choice(node, path, row.choices)) row.set(scene, index, static_cast<double>(*value));
            return;
        case SettingKind::Switch:
            if (const auto* value = node.as_boolean())
                row.set(scene, index, value->get() ? 1 : 0);
            else
                refuse(node, path, "true or false");
            return;
        case SettingKind::Integer:
            if (const auto value = wholeNumber(node, path, row.min, row.max)) row.set(scene, index, *value);
            return;
        case SettingKind::Number:
            if (const auto value = number(node, path, row.min, row.max)) row.set(scene, index, *value);
            return;
    }
}

void TomlValues::unknown(const toml::key& key, const std::string& path, std::span<const std::string> known) {
    if (full()) return;  // looking for the nearest name takes long
    fail(key.source(), fmt::format("no key {}; {}", inQuotes(path), insteadOf(key.str(), known)));
}

void TomlValues::refuse(const toml::node& node, const std::string& path, std::string expected) {
    fail(node.source(), fmt::format("{} is {}", path, described(node)), std::move(expected));
}

void TomlValues::fail(const toml::source_region& where, std::string found, std::string expected) {
    add({Error(place(where), std::move(found), std::move(expected))});
}

void TomlValues::add(const Errors& errors) {
    for (const Error& error : errors)
        if (!full() && std::ranges::find(m_errors, error) == m_errors.end()) m_errors.push_back(error);
}

Errors TomlValues::errors() const {
    Errors sorted = m_errors;
    // Tables are kept by name, not by place. Errors in other files come after those in this one.
    std::ranges::stable_sort(sorted, {}, [&](const Error& error) {
        const bool other = error.where.file != m_file;
        return std::tuple(other, other ? 0 : error.where.line, other ? 0 : error.where.column);
    });
    return sorted;
}

}  // namespace pipeline
