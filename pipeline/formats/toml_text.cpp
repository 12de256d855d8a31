#include "pipeline/formats/toml_text.h"

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

}  // namespace

std::optional<TextPosition> strayCharacter(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    In in = In::Plain;
    TextPosition at{1, 1};
    for (std::size_t i = 0; i < text.size();) {
        if (in == In::Plain && static_cast<unsigned char>(text[i]) >= 0x80) return at;
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

}  // namespace pipeline
