#include "pipeline/core/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace pipeline {
namespace {

unsigned char byteAt(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

// The character that a text begins with, and its length: 0 where it is no UTF-8.
struct Character {
    std::uint32_t code = 0;
    std::size_t length = 0;
};
Character first(std::string_view text) {
    const unsigned char lead = byteAt(text, 0);
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xC2 ? 0
                               : lead < 0xE0 ? 2
                               : lead < 0xF0 ? 3
                               : lead < 0xF5 ? 4
                                             : 0;
    if (length == 0 || length > text.size()) return {};
    std::uint32_t code = length == 1 ? lead : lead & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byteAt(text, i) & 0xC0) != 0x80) return {};
        code = code << 6 | (byteAt(text, i) & 0x3Fu);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool noCharacter = (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF;
    if (overlong || noCharacter) return {};
    return {code, length};
}

bool isControl(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

bool isInvisible(std::uint32_t code) {
    return (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF;
}

bool isShown(std::uint32_t code) { return !isControl(code) && !isInvisible(code); }

bool isPlainAscii(char c) { return c >= ' ' && c <= '~'; }

template <class Stays>
std::string escapedUnless(std::string_view text, std::string_view kept, Stays stays) {
    const auto isPlain = [&](char c) { return isPlainAscii(c) || kept.find(c) != kept.npos; };
    if (std::ranges::all_of(text, isPlain)) return std::string(text);  // nearly always
    std::string shown;
    while (!text.empty()) {
        const Character character = first(text);
        const std::size_t length = std::max<std::size_t>(character.length, 1);
        if (isPlain(text[0]) || (character.length > 0 && stays(character.code)))
            shown += text.substr(0, length);
        else if (character.length == 0 || character.code < 0x20)
            shown += fmt::format("\\x{:02x}", byteAt(text, 0));
        else
            shown += fmt::format("\\u{:04x}", character.code);
        text.remove_prefix(length);
    }
    return shown;
}

}  // namespace

std::size_t printableLength(std::string_view text) {
    const Character character = first(text);
    return isShown(character.code) ? character.length : 0;
}

std::string escaped(std::string_view text, std::string_view kept) { return escapedUnless(text, kept, isShown); }

std::string escapedControls(std::string_view prose) {
    return escapedUnless(prose, "\n\t\r", [](std::uint32_t code) { return !isControl(code); });
}

}  // namespace pipeline
