#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

#include "tests/architecture/rules.h"

namespace architecture {
namespace {

constexpr int kMostWords = 25;  // of a sentence

// A word, as a regular expression without its boundaries, and a better one.
constexpr std::array<std::pair<std::string_view, std::string_view>, 19> kReplaced{{
    {"foot", "bottom"},
    {"processors?", "CPU or core"},
    {"processor's time", "CPU time"},
    {"numbers that should not be there", "NaN, infinite and negative values"},
    {"(size of the|bigger|larger) letters", "text size"},
    {"once a pixel", "once per pixel"},
    {"frames a point", "frames per point"},
    {"in vectors", "with SIMD"},
    {"in turns", "interleaved"},
    {"given back", "freed"},
    {"one after the other", "sequentially"},
    {"one by one", "one at a time"},
    {"pick nothing", "clear selection"},
    {"called so", "no match"},
    {"beside the window", "in the background"},
    {"all the same", "still"},
    {"anew", "again"},
    {"(stands?|lies?)", "is"},
    {"told", "the message, the table or the inspector shows it"},
}};

bool isPage(std::string_view path) {
    if (path == "README.md" || path == "CONTRIBUTING.md") return true;
    return path.starts_with("resources/manual/") && path.ends_with(".md") && path != "resources/manual/reference.md";
}

// The lines of a page that are not within a block of code, with their numbers from 1.
std::vector<std::pair<std::size_t, std::string>> linesWithoutCode(const SourceFile& page) {
    std::vector<std::pair<std::size_t, std::string>> lines;
    bool isCode = false;
    for (std::size_t i = 0; i < page.lines.size(); ++i) {
        const std::string& line = page.lines[i];
        const std::size_t begin = line.find_first_not_of(" \t");
        const std::string text = begin == line.npos ? "" : line.substr(begin);
        const bool isFence = text.starts_with("```");
        if (isFence) isCode = !isCode;
        lines.emplace_back(i + 1, isFence || isCode ? "" : text);
    }
    return lines;
}

struct Paragraph {
    std::size_t line;  // of its beginning, from 1
    std::string text;
};

// Paragraphs and items of lists; no headings, tables, pictures or HTML.
std::vector<Paragraph> paragraphsOf(const SourceFile& page) {
    static const std::regex item(R"(^([-*]|[0-9]+\.) +)");
    std::vector<Paragraph> paragraphs;
    bool isOpen = false;
    for (auto& [number, line] : linesWithoutCode(page)) {
        if (line.empty() || std::string_view("|#<").find(line[0]) != std::string_view::npos || line.starts_with("![")) {
            isOpen = false;
            continue;
        }
        if (std::regex_search(line, item)) isOpen = false;
        if (!isOpen) paragraphs.push_back({number, ""});
        paragraphs.back().text += std::regex_replace(line, item, "") + " ";
        isOpen = true;
    }
    return paragraphs;
}

// As a reader sees it: pictures gone, links their text, code one word.
std::string readText(std::string text) {
    static const std::regex picture(R"(!\[[^\]]*\]\([^)]*\))"), link(R"(\[([^\]]*)\]\([^)]*\))"), code("`[^`]*`");
    text = std::regex_replace(std::regex_replace(text, picture, ""), link, "$1");
    return std::regex_replace(text, code, "code");
}

// Has a Latin or a Greek letter, or a digit: not "=", "·" or "→".
bool isWord(const std::string& token) {
    return std::ranges::any_of(token, [](unsigned char c) { return std::isalnum(c) || c == 0xce || c == 0xcf; });
}

bool endsSentence(const std::string& token) {
    const std::size_t last = token.find_last_not_of("\")*_]");
    return last != token.npos && std::string_view(".!?").find(token[last]) != std::string_view::npos;
}

// Hands the number of words of each sentence to `visit`, and how it begins.
template <class Visit>
void forEachSentence(const std::string& text, Visit visit) {
    std::istringstream stream(text);
    int words = 0;
    std::string beginning;
    for (std::string token; stream >> token;) {
        if (words < 5) beginning += (beginning.empty() ? "" : " ") + token;
        words += isWord(token);
        if (!endsSentence(token)) continue;
        visit(words, beginning);
        words = 0, beginning.clear();
    }
    visit(words, beginning);
}

std::string at(const SourceFile& page, std::size_t line) { return page.path + ":" + std::to_string(line) + ": "; }

}  // namespace

Breaches longSentences(const SourceTree& tree) {
    Breaches breaches;
    for (const SourceFile& page : tree) {
        if (!isPage(page.path)) continue;
        for (const Paragraph& paragraph : paragraphsOf(page))
            forEachSentence(readText(paragraph.text), [&](int words, const std::string& beginning) {
                if (words > kMostWords)
                    breaches.push_back(at(page, paragraph.line) + "\"" + beginning + " …\" has " +
                                       std::to_string(words) + " words; a sentence has at most " +
                                       std::to_string(kMostWords));
            });
    }
    return breaches;
}

Breaches replacedWords(const SourceTree& tree) {
    static const std::vector<std::pair<std::regex, std::string_view>> words = [] {
        std::vector<std::pair<std::regex, std::string_view>> all;
        for (const auto& [word, better] : kReplaced)
            all.emplace_back(std::regex("\\b" + std::string(word) + "\\b", std::regex::icase), better);
        return all;
    }();
    static const std::regex bold(R"(\*\*)"), label(R"(\*[^*]+\*)");
    Breaches breaches;
    for (const SourceFile& page : tree) {
        if (!isPage(page.path)) continue;
        for (const auto& [number, line] : linesWithoutCode(page)) {
            const std::string text = std::regex_replace(std::regex_replace(readText(line), bold, ""), label, "");
            std::smatch found;
            for (const auto& [word, better] : words)
                if (std::regex_search(text, found, word))
                    breaches.push_back(at(page, number) + "has \"" + found.str() +
                                       "\"; better: " + std::string(better));
        }
    }
    return breaches;
}

}  // namespace architecture
