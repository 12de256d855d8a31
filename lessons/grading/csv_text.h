#pragma once
#include <string>
#include <string_view>

namespace lessons {

// A cell of a CSV table (RFC 4180) with a stranger's text: on one line, quoted where it has to be, and with an apostrophe
// before what a spreadsheet would take for a formula.
std::string csvCell(std::string_view text);

}  // namespace lessons
