#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {

// The longest word that a scene file may hold, in bytes.
inline constexpr std::size_t kMaxWord = 4096;

// A number written out in full: "-1.5", "+2", "1e-3". What is too small for a double is 0.
// Nothing for NaN, infinity, hexadecimal, what is too large, and anything after the number.
std::optional<double> parseNumber(std::string_view word);
// A whole number without exponent, 0 to 2^64 - 1.
std::optional<std::uint64_t> parseCount(std::string_view word);

// Whether a text is UTF-8 without control characters and the like, so that a message, a table
// or a JSON file can hold it.
bool isPrintable(std::string_view text);
// The same text with ? for what is no such character, for names that are taken from files' names.
std::string printableText(std::string_view text);
// Input in double quotes for a message: at most 40 characters, what cannot be printed escaped.
std::string quotedInput(std::string_view input);
// "4 294 967 295"
std::string groupedDigits(std::uint64_t value);

// Splits a text into words as lecture 1's files are written: white space, commas and
// parentheses stand between words, and // begins a comment that lasts to the end of the line.
// A UTF-8 byte order mark at the start is no part of the first word.
class TextScanner {
public:
    // Errors are appended to `errors` until there are kMaxErrors. `text` must outlive the scanner.
    TextScanner(std::string_view text, std::string file, Errors& errors);

    // The next word; empty at the end of the text.
    std::string_view next();

    // Of the word read last, or of the end of the text.
    TextPosition place();
    SourceLocation where();
    // Bytes of the text, and of what follows the word read last.
    std::size_t size() const { return m_text.size(); }
    std::size_t bytesLeft() const { return m_text.size() - m_end; }

    // Reports the word read last: found "x4", expected what. The end of the text is reported once.
    void refuse(std::string expected);
    // Reports something else at the word read last.
    void fail(std::string found, std::string expected = {});
    // False once the text has ended too early or there are enough errors: no use in reading on.
    bool good() const { return !m_endReported && m_errors.size() < kMaxErrors; }

private:
    void skipSeparators();

    std::string_view m_text;
    std::string m_file;
    Errors& m_errors;
    std::size_t m_begin = 0, m_end = 0;  // the word read last
    bool m_endReported = false;
    int m_line = 1;
    // Columns are counted on from the last place that was asked for, so that asking for many
    // places in one long line takes linear time.
    std::size_t m_counted = 0;
    int m_column = 1;
};

}  // namespace pipeline
