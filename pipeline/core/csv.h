#pragma once
#include <string>
#include <string_view>

namespace pipeline {

// A field of a line of comma-separated values (RFC 4180), in quotes where it has to be. A text that a spreadsheet would
// take for a formula, for it begins with = + - @ or a tabulator and is no number, gets an apostrophe before it.
std::string csvField(std::string_view text);

}  // namespace pipeline
