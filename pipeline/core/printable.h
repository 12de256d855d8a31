#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace pipeline {

// The length of the UTF-8 character that `text` begins with, in bytes; 0 where it begins with none that can be shown:
// control characters, invisible ones, marks that turn the direction of writing, broken sequences. `text` is not empty.
std::size_t printableLength(std::string_view text);

// The text with what cannot be shown escaped, but for the ASCII characters in `kept`: bytes that are no character and
// control characters of ASCII as \x1b, other characters as \u202e. A message, a terminal and a JSON string that has been
// written can hold it.
std::string escaped(std::string_view text, std::string_view kept = {});

// Of several lines: these and tabulators are kept.
inline std::string escapedLines(std::string_view text) { return escaped(text, "\n\t"); }

// Of prose: control characters and broken sequences are escaped, but for lines, tabulators and carriage returns. Invisible
// characters and marks of direction stay: many languages are written with them.
std::string escapedControls(std::string_view prose);

}  // namespace pipeline
