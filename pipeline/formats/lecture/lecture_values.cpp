#include "pipeline/formats/lecture/lecture_values.h"

#include <algorithm>

#include "pipeline/core/text.h"

namespace pipeline {
namespace {

// Labels begin a line in the window: "Scale x", but "L x".
std::string labelInSentence(std::string_view label) {
    std::string text(label);
    const auto isLetter = [&](std::size_t i, char first, char last) { return text[i] >= first && text[i] <= last; };
    if (text.size() > 1 && isLetter(0, 'A', 'Z') && isLetter(1, 'a', 'z')) text[0] = static_cast<char>(text[0] + 32);
    return text;
}

std::string amount(std::size_t count, const Countable& thing) {
    return groupedDigits(count) + ' ' + std::string(count == 1 ? thing.one : thing.many);
}

}  // namespace

std::optional<std::size_t> readCount(TextScanner& scanner, const Countable& thing, std::optional<std::size_t> polygon) {
    const std::optional<std::uint64_t> count = parseCount(scanner.next());
    if (count && *count > scanner.bytesLeft() / (2 * thing.words)) {
        scanner.fail(amount(*count, thing) + " announced, the file ends after " + groupedDigits(scanner.size()) +
                     " bytes");
        return {};
    }
    if (!count || *count < thing.least || *count > thing.most) {
        const std::string of = polygon ? " of polygon " + std::to_string(*polygon) : "";
        scanner.refuse("the number of " + std::string(thing.many) + of + ", from " + groupedDigits(thing.least) +
                       " to " + groupedDigits(thing.most));
        if (!count || *count > thing.most) return {};
    }
    return *count;
}

const Setting& settingRow(std::string_view key) { return *std::ranges::find(settingsTable(), key, &Setting::key); }

std::string numberFrom(double min, double max) {
    return "a number from " + shortestText(min) + " to " + shortestText(max);
}

void readSettings(TextScanner& scanner, std::span<const std::string_view> keys, Scene& scene, std::size_t index,
                  KeyPlaces* places) {
    for (const std::string_view key : keys) {
        const Setting& row = settingRow(key);
        const std::optional<double> value = parseNumber(scanner.next());
        if (places) places->add(SettingRef{&row, index}.key(), scanner.where());
        if (value && *value >= row.min && *value <= row.max)
            row.set(scene, index, *value);
        else
            scanner.refuse(labelInSentence(row.label) + ", " + numberFrom(row.min, row.max));
    }
}

void expectEnd(TextScanner& scanner) {
    if (!scanner.next().empty()) scanner.refuse("the end of the file");
}

std::vector<std::string_view> firstWords(std::string_view start, std::size_t count) {
    Errors none;
    TextScanner scanner(start, {}, none);
    std::vector<std::string_view> words;
    for (std::string_view word = scanner.next(); !word.empty() && words.size() < count; word = scanner.next())
        words.push_back(word);
    return words;
}

}  // namespace pipeline
