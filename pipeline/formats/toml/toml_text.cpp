#include "pipeline/formats/toml/toml_text.h"

namespace pipeline {
namespace {

enum class In { Plain, Comment, Basic, Literal, BasicLines, LiteralLines };

// The state after the characters at the beginning of `rest`, and how many of them there are.
struct Step {
    In in;
    std::size_t length = 1;
};
Step step(In in, std::string_view rest) {
    const bool escapes = in == In::Basic || in == In::BasicLines;
    if (escapes && rest[0] == '\\' && rest.size() > 1 && rest[1] != '\n') return {in, 2};
    // Strings of one line and comments end with it, closed or not.
    if (rest[0] == '\n' && in != In::BasicLines && in != In::LiteralLines) return {In::Plain};
    switch (in) {
        case In::Comment: return {in};
        case In::Basic: return {rest[0] == '"' ? In::Plain : in};
        case In::Literal: return {rest[0] == '\'' ? In::Plain : in};
        case In::BasicLines: return rest.starts_with(R"(""")") ? Step{In::Plain, 3} : Step{in};
        case In::LiteralLines: return rest.starts_with("'''") ? Step{In::Plain, 3} : Step{in};
        case In::Plain: break;
    }
    if (rest.starts_with(R"(""")")) return {In::BasicLines, 3};
    if (rest.starts_with("'''")) return {In::LiteralLines, 3};
    return {rest[0] == '#' ? In::Comment : rest[0] == '"' ? In::Basic : rest[0] == '\'' ? In::Literal : in};
}

bool beginsCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

// Where the first character stands, outside comments, for which `is` says so; it is asked about each, in their order.
template <class Is>
std::optional<TextPosition> firstWhere(std::string_view text, const Stop& stop, Is is) {
    StopCheck check(stop);
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    In in = In::Plain;
    TextPosition at{1, 1};
    for (std::size_t i = 0; i < text.size() && !check.stopped();) {
        if (in != In::Comment && is(text[i], in)) return at;
        const Step next = step(in, text.substr(i));
        for (std::size_t k = i; k < i + next.length; ++k) {
            if (text[k] == '\n')
                at = {at.line + 1, 1};
            else if (beginsCharacter(text[k]))
                ++at.column;
        }
        in = next.in;
        i += next.length;
    }
    return {};
}

bool mayStandInKey(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-\"' \t").find(c) != std::string_view::npos;
}

}  // namespace

std::optional<TextPosition> strayCharacter(std::string_view text, const Stop& stop) {
    return firstWhere(text, stop,
                      [](char c, In in) { return in == In::Plain && static_cast<unsigned char>(c) >= 0x80; });
}

std::optional<TextPosition> deepKey(std::string_view text, const Stop& stop) {
    int dots = 0;
    return firstWhere(text, stop, [&](char c, In in) {
        if (in != In::Plain) return false;  // part of a quoted key, or of a text
        dots = c == '.' ? dots + 1 : mayStandInKey(c) ? dots : 0;
        return dots >= kMostKeyParts;
    });
}

}  // namespace pipeline
