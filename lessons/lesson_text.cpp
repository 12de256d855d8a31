#include "lessons/lesson_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/core/text.h"

namespace lessons {

using pipeline::inQuotes;
using pipeline::SourceLocation;

bool has(std::span<const std::string_view> words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

Line trimmed(Line line) {
    const auto first = std::min(line.text.find_first_not_of(" \t"), line.text.size());
    const SourceLocation where = advanced(line.where, line.text.substr(0, first));
    const std::string_view text = line.text.substr(first);
    return {text.substr(0, text.find_last_not_of(" \t") + 1), where};
}

bool isBlank(const Line& line) { return trimmed(line).text.empty(); }

std::vector<Line> linesOf(std::string_view text, const std::string& file) {
    std::vector<Line> lines;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back({line, {file, int(lines.size()) + 1, 1}});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::optional<Entry> entryIn(const Line& line) {
    const auto isKey = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto isId = [&](char c) { return isKey(c) || (c >= '0' && c <= '9') || c == '-'; };
    const std::string_view text = line.text;
    const std::size_t key = std::size_t(std::ranges::find_if_not(text, isKey) - text.begin());
    if (key == 0 || key == text.size()) return {};
    std::size_t end = key;
    if (text[key] == ' ') {
        const std::string_view id = text.substr(key + 1);
        const auto idEnd = std::ranges::find_if_not(id, isId);
        if (idEnd == id.begin()) return {};
        end = key + 1 + std::size_t(idEnd - id.begin());
    }
    if (end == text.size() || text[end] != ':') return {};
    return Entry{text.substr(0, key),
                 end > key ? text.substr(key + 1, end - key - 1) : std::string_view(),
                 line.where,
                 {trimmed({text.substr(end + 1), advanced(line.where, text.substr(0, end + 1))})}};
}

std::vector<Line> separated(const Line& line, std::string_view separator) {
    std::vector<Line> parts;
    for (Line rest = line;;) {
        const auto end = rest.text.find(separator);
        parts.push_back(trimmed({rest.text.substr(0, end), rest.where}));
        if (end == std::string_view::npos) return parts;
        const std::string_view taken = rest.text.substr(0, end + separator.size());
        rest = {rest.text.substr(taken.size()), advanced(rest.where, taken)};
    }
}

std::optional<std::pair<Line, Line>> splitAt(const Line& line, std::string_view separator) {
    const auto end = line.text.find(separator);
    if (end == std::string_view::npos) return {};
    const std::string_view taken = line.text.substr(0, end + separator.size());
    return std::pair{trimmed({line.text.substr(0, end), line.where}),
                     trimmed({line.text.substr(taken.size()), advanced(line.where, taken)})};
}

std::string listed(const std::vector<std::string>& words) {
    if (words.size() < 2) return words.empty() ? "none" : words.front();
    return fmt::format("{} and {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

const Entry* find(std::span<const Entry> entries, std::string_view key) {
    const auto found = std::ranges::find(entries, key, &Entry::key);
    return found == entries.end() ? nullptr : &*found;
}

void Complaints::add(const SourceLocation& where, std::string found, std::string expected) {
    m_errors.push_back({where, std::move(found), std::move(expected)});
}

void Complaints::add(const SourceLocation& where, pipeline::Errors errors) {
    for (pipeline::Error& error : errors) {
        if (error.where.line == 0) error.where = where;
        m_errors.push_back(std::move(error));
    }
}

void Complaints::addUnknown(const SourceLocation& where, std::string_view kind, std::string_view name,
                            std::vector<std::string> known) {
    add(where, "no " + std::string(kind) + ' ' + inQuotes(name) + "; " + pipeline::insteadOf(name, known));
}

pipeline::Errors Complaints::take() {
    if (m_errors.size() > pipeline::kMaxErrors) m_errors.resize(pipeline::kMaxErrors);
    return std::move(m_errors);
}

bool isKnown(const Entry& entry, const EntryKeys& known, std::span<const Entry> before, Complaints& complaints) {
    if (!has(known.keys, entry.key)) {
        complaints.addUnknown(entry.where, "key", entry.key, {known.keys.begin(), known.keys.end()});
        return false;
    }
    const std::string key = inQuotes(entry.key);
    if (!entry.id.empty() && !has(known.withId, entry.key))
        complaints.add(entry.where, "found " + inQuotes(entry.id) + " behind " + key, "a colon");
    if (!has(known.repeated, entry.key) && find(before, entry.key))
        complaints.add(entry.where, "found " + key + " a second time", "it once");
    if (!entry.line().text.empty() || has(known.blocks, entry.key)) return true;
    complaints.add(entry.line().where, "found nothing", "what " + key + " is");
    return false;
}

}  // namespace lessons
