#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace app {

// A message for standard error. One that cannot be written changes nothing: the exit status has been decided by what
// happened, not by who could be told. (fmt::print throws there.)
template <class... Args>
void tell(fmt::format_string<Args...> text, Args&&... args) {
    const std::string line = fmt::format(text, std::forward<Args>(args)...);
    std::fwrite(line.data(), 1, line.size(), stderr);
}

// What the caller has closed of standard input, output and error stays taken by a file that can be neither read nor
// written as it should: else the next file that is opened would get its number, and what is said its bytes.
void keepStandardFiles();

// A file that may not grow further (ulimit -f) is one that could not be written, as on a full disk, and not the end of
// the program.
void tellOfFullFiles();

}  // namespace app
