#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/prose.h"
#include "lessons/text_position.h"

// The lines of a lesson's file and what is wrong with them, for its reader.

namespace lessons {

// "key: value", or "key id: value", with the lines that carry it on.
struct Entry {
    std::string_view key;
    std::string_view id;  // empty where the key has none
    pipeline::SourceLocation where;
    std::vector<Line> value;  // at least one
    const Line& line() const { return value.front(); }
};

Line trimmed(Line line);
bool isBlank(const Line& line);
// They look into the text, which must last as long as they do.
std::vector<Line> linesOf(std::string_view text, const std::string& file);
std::vector<Line> linesOf(std::string&& text, const std::string& file) = delete;
// A line of the form "word: value" or "word id: value", or nothing. Keys have letters a to z, ids also digits and -.
std::optional<Entry> entryIn(const Line& line);
// The parts between separators, trimmed; at least one.
std::vector<Line> separated(const Line& line, std::string_view separator = ",");
// The text before the first separator, and what is behind it; both trimmed. Nothing where there is none.
std::optional<std::pair<Line, Line>> splitAt(const Line& line, std::string_view separator);

// "a, b and c"; "none" of nothing.
std::string listed(const std::vector<std::string>& words);

bool has(std::span<const std::string_view> words, std::string_view word);

// The first entry with this key, or null.
const Entry* find(std::span<const Entry> entries, std::string_view key);

// Collects what is wrong with a file.
class Complaints {
public:
    void add(const pipeline::SourceLocation& where, std::string found, std::string expected = {});
    // Errors of the pipeline know no place in this file; those of a scene file know their own.
    void add(const pipeline::SourceLocation& where, pipeline::Errors errors);
    void addUnknown(const pipeline::SourceLocation& where, std::string_view kind, std::string_view name,
                    std::vector<std::string> known);
    bool empty() const { return m_errors.empty(); }
    pipeline::Errors take();  // at most kMaxErrors

    // What a parser has read, or an empty T and its errors.
    template <class T>
    T valueOf(pipeline::Result<T> result) {
        if (result) return std::move(result).value();
        add({}, result.errors());
        return {};
    }

private:
    pipeline::Errors m_errors;
};

// Where entries are gathered that have to be among `keys`; false and a complaint where one is not. Of keys that are not
// in `repeated` there may be one. What a key of `blocks` is may begin on its next line.
struct EntryKeys {
    std::span<const std::string_view> keys, repeated, withId, blocks;
};
bool isKnown(const Entry& entry, const EntryKeys& known, std::span<const Entry> before, Complaints& complaints);

}  // namespace lessons
