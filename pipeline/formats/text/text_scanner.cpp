#include "pipeline/formats/text/text_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "pipeline/core/number.h"
#include "pipeline/core/printable.h"

namespace pipeline {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

constexpr std::array<bool, 256> kSeparators = [] {
    std::array<bool, 256> separators{};
    for (const char c : {' ', '\t', '\n', '\v', '\f', '\r', ',', '(', ')'})
        separators[static_cast<unsigned char>(c)] = true;
    return separators;
}();

bool isSeparator(char c) { return kSeparators[static_cast<unsigned char>(c)]; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// Whether a number that does not fit a double is too small rather than too large: the decimal
// exponent of its first digit that is not 0.
bool isTiny(std::string_view number) {
    const std::size_t mark = number.find_first_of("eE");
    const std::string_view digits = number.substr(0, mark);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::size_t first = std::min(digits.find_first_of("123456789"), digits.size());
    const double position = first < point ? double(point - first) - 1 : double(point) - double(first);
    int exponent = 0;
    if (mark != std::string_view::npos) {
        const std::string_view text = number.substr(mark + 1);
        const bool negative = text.starts_with('-');
        const char* begin = text.data() + (negative || text.starts_with('+'));
        if (std::from_chars(begin, text.data() + text.size(), exponent).ec != std::errc{}) return negative;
        if (negative) exponent = -exponent;
    }
    return exponent + position < 0;
}

}  // namespace

std::optional<double> parseNumber(std::string_view word) {
    if (word.size() > kMaxWord) return {};
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    const std::string_view digits = word.substr(word.starts_with('-'));
    if (digits.empty() || (!isDigit(digits[0]) && digits[0] != '.')) return {};
    const LeadingNumber number = leadingNumber(word);
    if (number.length != word.size()) return {};
    if (!number.fits) return isTiny(digits) ? std::optional(0.0) : std::nullopt;
    return number.value;
}

std::optional<std::uint64_t> parseCount(std::string_view word) {
    if (word.size() > kMaxWord) return {};
    if (word.starts_with('+')) word.remove_prefix(1);
    std::uint64_t value = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, status] = std::from_chars(word.data(), end, value);
    if (status != std::errc{} || stop != end) return {};
    return value;
}

bool isPrintable(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = printableLength(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

std::string printableText(std::string_view text) {
    std::string printable;
    while (!text.empty()) {
        const std::size_t length = printableLength(text);
        printable += length > 0 ? text.substr(0, length) : "?";
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return printable;
}

std::string quotedInput(std::string_view input) {
    constexpr int kMostCharacters = 40;
    std::string text = "\"";
    int characters = 0;
    while (!input.empty()) {
        if (characters++ == kMostCharacters) {
            text += "…";
            break;
        }
        const std::size_t length = printableLength(input);
        if (length > 0) {
            if (input[0] == '"' || input[0] == '\\') text += '\\';
            text += input.substr(0, length);
        } else {
            constexpr std::string_view kHexadecimal = "0123456789ABCDEF";
            const auto byte = static_cast<unsigned char>(input[0]);
            text += {'\\', 'x', kHexadecimal[byte >> 4], kHexadecimal[byte & 15]};
        }
        input.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return text + '"';
}

std::string groupedDigits(std::uint64_t value) {
    std::string text = std::to_string(value);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ' ');
    return text;
}

TextScanner::TextScanner(std::string_view text, std::string file, Errors& errors)
    : m_text(text), m_file(std::move(file)), m_errors(errors) {
    if (text.starts_with(kByteOrderMark)) m_begin = m_end = m_counted = kByteOrderMark.size();
}

void TextScanner::skipSeparators() {
    while (m_end < m_text.size()) {
        const char c = m_text[m_end];
        if (isSeparator(c)) {
            ++m_end;
            // A carriage return ends a line of its own unless a line feed follows.
            if (c == '\n' || (c == '\r' && (m_end == m_text.size() || m_text[m_end] != '\n'))) {
                ++m_line;
                m_counted = m_end;
                m_column = 1;
            }
        } else if (c == '/' && m_text.substr(m_end, 2) == "//") {
            m_end = std::min(m_text.find_first_of("\r\n", m_end), m_text.size());
        } else {
            return;
        }
    }
}

std::string_view TextScanner::next() {
    skipSeparators();
    m_begin = m_end;
    while (m_end < m_text.size() && !isSeparator(m_text[m_end])) {
        if (m_text[m_end] == '/' && m_text.substr(m_end, 2) == "//") break;
        ++m_end;
    }
    return m_text.substr(m_begin, m_end - m_begin);
}

TextPosition TextScanner::place() {
    for (; m_counted < m_begin; ++m_counted) m_column += !continuesCharacter(m_text[m_counted]);
    return {m_line, m_column};
}

SourceLocation TextScanner::where() {
    const TextPosition at = place();
    return {m_file, at.line, at.column};
}

void TextScanner::refuse(std::string expected) {
    const std::string_view word = m_text.substr(m_begin, m_end - m_begin);
    if (word.empty()) {
        if (!m_endReported) fail("found the end of the file", std::move(expected));
        m_endReported = true;
    } else if (word.size() > kMaxWord) {
        fail("found a word of " + groupedDigits(word.size()) + " bytes", std::move(expected));
    } else {
        fail("found " + quotedInput(word), std::move(expected));
    }
}

void TextScanner::fail(std::string found, std::string expected) {
    if (m_errors.size() >= kMaxErrors) return;
    m_errors.push_back({where(), std::move(found), std::move(expected)});
}

}  // namespace pipeline
