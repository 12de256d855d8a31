// Settings as people write them: "light.0.x=500".
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pipeline/core/index_words.h"
#include "pipeline/core/number.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/scene/vertex_settings.h"

namespace pipeline {

namespace {

// "light.12.x" taken apart at its number: "light.#.x" and 12. Keys without one stay whole.
struct SplitKey {
    std::string pattern;
    std::optional<std::size_t> index;
};

SplitKey split(std::string_view key) {
    const auto first = key.find('.');
    const auto second = first == key.npos ? key.npos : key.find('.', first + 1);
    if (second == key.npos) return {std::string(key), {}};
    const std::string_view digits = key.substr(first + 1, second - first - 1);
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return {std::string(key), {}};
    return {std::string(key.substr(0, first + 1)) + '#' + std::string(key.substr(second)), index};
}

std::string expectedText(const Setting& setting) {
    switch (setting.kind) {
        case SettingKind::Switch:
        case SettingKind::Choice: {
            std::string text;
            for (std::size_t i = 0; i < setting.choices.size(); ++i) {
                if (i > 0) text += i + 1 == setting.choices.size() ? " or " : ", ";
                text += setting.choices[i];
            }
            return text;
        }
        case SettingKind::Number:
        case SettingKind::Integer: break;
    }
    const std::string_view what = setting.kind == SettingKind::Integer ? "a whole number from " : "a number from ";
    return std::string(what) + shortestText(setting.min) + " to " + shortestText(setting.max);
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const auto first = text.find_first_not_of(kBlank);
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace

std::string SettingRef::key() const {
    std::string text(setting->key);
    if (const auto of = vertexOf(*this))
        text.replace(text.find('#'), 1, fmt::format("{}.{}", of->object, of->vertex));
    else if (const auto hash = text.find('#'); hash != text.npos)
        text.replace(hash, 1, std::to_string(index));
    return text;
}

Result<SettingRef> findSetting(const Scene& scene, std::string_view key) {
    if (key.starts_with(kVertexPrefix)) return findVertexSetting(scene, key);
    const SplitKey wanted = split(key);
    const auto rows = settingsTable();
    const auto found = std::ranges::find(rows, std::string_view(wanted.pattern), &Setting::key);
    if (found != rows.end() && wanted.index.has_value() == (found->key.find('#') != found->key.npos)) {
        const std::size_t index = wanted.index.value_or(0), count = found->count(scene);
        if (index < count) {
            const std::string_view absent = found->absent(scene, index);
            if (absent.empty()) return SettingRef{&*found, index};
            return Error{{}, fmt::format("no setting {}: {}", inQuotes(key), absent), {}};
        }
        const std::string kind(found->key.substr(0, found->key.find('.')));
        if (count == 0) return Error{{}, "no setting " + inQuotes(key) + ": this scene has no " + kind, {}};
        return Error{{}, "no setting " + inQuotes(key), kind + ' ' + indexWords(count, "")};
    }
    std::vector<std::string> keys;
    for (const SettingRef& ref : settingsOf(scene)) keys.push_back(ref.key());
    return Error{{}, "no setting " + inQuotes(key) + "; " + insteadOf(key, keys, kListingCommand), {}};
}

Result<double> parseSetting(const SettingRef& ref, std::string_view text) {
    const Setting& setting = *ref.setting;
    const std::string_view word = trimmed(text);
    const Error refused{{}, ref.key() + " is " + inQuotes(text), expectedText(setting)};
    if (!setting.choices.empty()) {
        const auto found = std::ranges::find(setting.choices, word);
        if (found == setting.choices.end()) return refused;
        return static_cast<double>(found - setting.choices.begin());
    }
    const std::string_view digits = word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word;
    const std::optional<double> value = readNumber(digits);
    if (!value || !(*value >= setting.min && *value <= setting.max)) return refused;  // so written, NaN is refused too
    if (setting.kind == SettingKind::Integer && *value != std::trunc(*value)) return refused;
    return *value;
}

std::string formatSetting(const SettingRef& ref, double value) {
    const auto choices = ref.setting->choices;
    if (choices.empty()) return shortestText(value);
    const auto last = static_cast<double>(choices.size() - 1);
    return std::string(choices[static_cast<std::size_t>(std::clamp(value, 0.0, last))]);
}

std::string_view assignedKey(std::string_view assignment) {
    return trimmed(assignment.substr(0, assignment.find('=')));
}

Result<Scene> withSetting(Scene scene, std::string_view assignment) {
    const auto equals = assignment.find('=');
    if (equals == assignment.npos) return Error{{}, "found " + inQuotes(assignment), "KEY=VALUE"};
    const auto ref = findSetting(scene, assignedKey(assignment));
    if (!ref) return ref.errors();
    const auto value = parseSetting(*ref, assignment.substr(equals + 1));
    if (!value) return value.errors();
    ref->set(scene, *value);
    return scene;
}

}  // namespace pipeline
