#include "lessons/state/toml_lines.h"

#include <algorithm>

namespace lessons {
namespace {

std::string_view trimmed(std::string_view words) {
    const auto begin = words.find_first_not_of(" \t\r");
    if (begin == words.npos) return {};
    return words.substr(begin, words.find_last_not_of(" \t\r") - begin + 1);
}

class Scanner {
public:
    explicit Scanner(std::string_view file) : m_file(file) {}

    bool atEnd() const { return m_at >= m_file.size(); }
    TomlItem next() {
        const std::size_t begin = m_at;
        TomlItem item;
        skipSpaces();
        if (atEnd() || peek() == '\n') {
            item.kind = TomlItem::Kind::Blank;
        } else if (peek() == '#') {
            item.kind = TomlItem::Kind::Comment;
            item.comments = comment();
        } else if (peek() == '[') {
            item.kind = TomlItem::Kind::Header;
            while (!atEnd() && peek() != '\n' && peek() != '#') header(item.name);
            if (!atEnd() && peek() == '#') item.comments = comment();
        } else {
            item.kind = TomlItem::Kind::Entry;
            entry(begin, item);
        }
        skipLine();
        item.text = std::string(m_file.substr(begin, m_at - begin));
        if (item.text.empty() || item.text.back() != '\n') item.text += '\n';
        return item;
    }

private:
    char peek() const { return m_file[m_at]; }
    void skipSpaces() {
        while (!atEnd() && (peek() == ' ' || peek() == '\t' || peek() == '\r')) ++m_at;
    }
    void skipLine() {
        while (!atEnd() && peek() != '\n') ++m_at;
        if (!atEnd()) ++m_at;
    }
    // To the end of the line, its end with it.
    std::string comment() {
        const std::size_t begin = m_at;
        while (!atEnd() && peek() != '\n') ++m_at;
        return std::string(trimmed(m_file.substr(begin, m_at - begin))) + '\n';
    }
    void header(std::string& name) {
        const std::size_t begin = m_at;
        if (peek() == '"' || peek() == '\'')
            string();
        else
            ++m_at;
        const std::string_view part = m_file.substr(begin, m_at - begin);
        if (part != " " && part != "\t" && part != "\r") name += part;
    }
    void string() {
        const char quote = peek();
        const std::string three(3, quote);
        const bool isLong = m_file.substr(m_at, 3) == three;
        m_at += isLong ? 3 : 1;
        while (!atEnd()) {
            if (quote == '"' && peek() == '\\') {
                m_at = std::min(m_at + 2, m_file.size());
            } else if (isLong ? m_file.substr(m_at, 3) == three : peek() == quote) {
                m_at += isLong ? 3 : 1;
                while (isLong && !atEnd() && peek() == quote) ++m_at;  // quotes at its very end belong to it
                return;
            } else if (!isLong && peek() == '\n') {
                return;
            } else {
                ++m_at;
            }
        }
    }
    void entry(std::size_t begin, TomlItem& item) {
        const std::size_t key = m_at;
        while (!atEnd() && peek() != '=' && peek() != '\n') peek() == '"' || peek() == '\'' ? string() : void(++m_at);
        item.name = std::string(trimmed(m_file.substr(key, m_at - key)));
        if (!atEnd() && peek() == '=') ++m_at;
        skipSpaces();
        item.before = std::string(m_file.substr(begin, m_at - begin));
        const std::size_t value = m_at;
        std::size_t end = m_at;
        for (int depth = 0; !atEnd() && (depth > 0 || peek() != '\n');) {
            const char c = peek();
            if (c == '#') {
                item.comments += comment();
                if (depth == 0) break;
                continue;
            }
            if (c == '"' || c == '\'')
                string();
            else
                depth += int(c == '[' || c == '{') - int(c == ']' || c == '}'), ++m_at;
            end = m_at;
        }
        item.value = std::string(trimmed(m_file.substr(value, end - value)));
    }

    std::string_view m_file;
    std::size_t m_at = 0;
};

}  // namespace

std::vector<TomlItem> tomlItems(std::string_view file) {
    std::vector<TomlItem> items;
    for (Scanner scanner(file); !scanner.atEnd();) items.push_back(scanner.next());
    return items;
}

TomlItem withValue(const TomlItem& entry, const std::string& value) {
    TomlItem changed = entry;
    changed.value = value;
    const bool isOneLine = std::count(entry.text.begin(), entry.text.end(), '\n') == 1;
    std::string behind = "\n", above;
    if (!entry.comments.empty() && isOneLine) behind = "  " + entry.comments;
    if (!entry.comments.empty() && !isOneLine) above = entry.comments;
    changed.text = above + entry.before + value + behind;
    return changed;
}

}  // namespace lessons
