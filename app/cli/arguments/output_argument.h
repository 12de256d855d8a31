#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace app {

// The value of -o that is standard output, where a command writes one file.
inline constexpr std::string_view kStandardOutput = "-";

// Writes the whole file, or keeps the one before; the bytes to standard output as they are.
pipeline::Errors writeOutput(const std::string& file, std::string_view bytes);

// "lesson.html, 1.2 MB", on standard error.
void tellWritten(const std::string& file, std::size_t bytes);

// Several files cannot go to standard output: no folder "-" is made by mistake.
inline constexpr std::string_view kNoStandardOutput =
    "- is standard output, which takes one file: name a file or a folder, ./- for one of that name";
void refuseStandardOutput(CLI::Option& option);
// -o DIR of a command that writes a folder, and its --force.
CLI::Option* declareFolder(CLI::App& command, std::string& folder, const std::string& meaning);
CLI::Option* declareForce(CLI::App& command, bool& force);

// Whether these files may come into the folder, looked at before anything is computed. If not, the reason went to
// standard error: the folder cannot be written, the command has read one of them or, unless `force`, the program did not
// write it (whyNotReplaced()). index: as Staging::publish() has it.
bool mayWriteInto(const std::string& folder, const std::vector<std::string>& names, const std::string& index,
                  bool force);
// The same of one file, which may be standard output; an input alone is never replaced.
bool mayWriteTo(const std::string& file);

}  // namespace app
