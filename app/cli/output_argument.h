#pragma once
#include <string>
#include <string_view>

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
// -o DIR of a command that writes a folder.
CLI::Option* declareFolder(CLI::App& command, std::string& folder, const std::string& meaning);

}  // namespace app
