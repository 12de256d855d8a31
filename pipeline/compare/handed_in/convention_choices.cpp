#include "pipeline/compare/handed_in/convention_choices.h"

#include <algorithm>
#include <utility>

#include "pipeline/compare/report/compare_text.h"

namespace pipeline::foreign {

namespace {

// The key of a line "key = value"; empty of another line.
std::string keyOfLine(const std::string& line) {
    const auto equals = line.find('=');
    if (equals == line.npos) return {};
    const auto first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t", equals - 1);
    return first >= equals ? std::string() : line.substr(first, last - first + 1);
}

// What a reading says for every key that it has a value for.
std::vector<std::pair<std::string, std::string>> valuesOf(const Reading& reading, bool isPicture, bool hasChannels,
                                                          const std::string& codingKey) {
    std::vector<std::pair<std::string, std::string>> values;
    if (isPicture) values.emplace_back("rows", reading.bottomUp ? "bottom-up" : "top-down");
    if (isPicture) values.emplace_back("columns", reading.mirrored ? "right-to-left" : "left-to-right");
    if (hasChannels) values.emplace_back("channels", reading.bgr ? "bgr" : "rgb");
    if (codingKey.empty()) return values;
    const CodingInfo& coding = codingInfo(reading.coding);
    values.emplace_back(codingKey, coding.key.empty() ? "own" : std::string(coding.value));
    return values;
}

void addOnce(std::vector<std::string>& values, const std::string& value) {
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
}

}  // namespace

std::string withStated(const std::string& text, const StatedByHand& byHand) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (!byHand.contains(keyOfLine(line))) out += line + '\n';
        at = end + 1;
    }
    for (const auto& [key, value] : byHand) out += key + " = \"" + value + "\"\n";
    return out;
}

std::vector<ConventionChoice> conventionChoices(const Report& report) {
    std::vector<ConventionChoice> choices;
    for (const ReadFile& file : report.conventions.files) {
        const auto readings = readingsOf(*file.file, report.reference->context);
        const bool isPicture = bufferInfo(file.file->name.buffer.id).domain == Domain::Pixel;
        const bool hasChannels = file.file->name.buffer.id == BufferId::Color;
        // Encodings, depths, normals: a file has codings of one key at most, beside the program's own.
        std::string codingKey;
        for (const Reading& reading : readings)
            if (const auto key = codingInfo(reading.coding).key; !key.empty()) codingKey = key;
        for (const auto& row : valuesOf(file.reading, isPicture, hasChannels, codingKey)) {
            const auto& key = row.first;
            const auto& now = row.second;
            auto choice = std::ranges::find(choices, key, &ConventionChoice::key);
            if (choice == choices.end()) choice = choices.insert(choice, {key, now, {}, {}, {}});
            for (const Reading& reading : readings)
                for (const auto& [otherKey, value] : valuesOf(reading, isPicture, hasChannels, codingKey))
                    if (otherKey == key) addOnce(choice->values, value);
            const auto said = std::ranges::find_if(report.conventions.said, [&](const Convention& one) {
                return one.key == key && one.buffer == file.file->name.text();
            });
            if (said == report.conventions.said.end()) continue;
            // Of several files the first that can tell is named with how clear it is.
            if (choice->certainty.empty() || said->certainty == Certainty::Clear) {
                if (choice->buffers.empty() || choice->value != now) choice->value = now;
                choice->certainty = certaintyText(*said);
            }
            choice->buffers += (choice->buffers.empty() ? "" : ", ") + said->buffer;
        }
    }
    std::erase_if(choices, [](const ConventionChoice& choice) { return choice.values.size() < 2; });
    std::stable_partition(choices.begin(), choices.end(),
                          [](const ConventionChoice& choice) { return !choice.certainty.empty(); });
    return choices;
}

}  // namespace pipeline::foreign
