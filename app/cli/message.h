#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace app {

// All that the program prints goes through here. What no terminal should get (control characters and what turns the
// direction of writing; names, paths and the words of libraries may hold it) is escaped, see pipeline/core/printable.h.
void writeEscaped(std::string_view text, std::FILE* to);  // a failed write is left to std::ferror

// A message for standard error. One that cannot be written changes nothing: the exit status has been decided by what
// happened, not by who could be told.
template <class... Args>
void tell(fmt::format_string<Args...> text, Args&&... args) {
    writeEscaped(fmt::format(text, std::forward<Args>(args)...), stderr);
}

// What was asked for, on standard output. Throws std::system_error where it cannot be written.
void sayText(std::string_view text);
template <class... Args>
void say(fmt::format_string<Args...> text, Args&&... args) {
    sayText(fmt::format(text, std::forward<Args>(args)...));
}

// The same in bold, for a terminal.
void sayBold(std::string_view text);

// Empties the line of a terminal that the cursor is in.
void clearLine();

// Opens a dummy file for each standard stream that the caller closed. Otherwise the next opened file would become
// descriptor 0, 1 or 2, and messages would be written into it.
void keepStandardFiles();

// A file that may not grow further (ulimit -f) is one that could not be written, as on a full disk, and not the end of
// the program.
void tellOfFullFiles();

}  // namespace app
