#pragma once
#include <string>
#include <vector>

namespace pipeline {

// A text cut to a width in points, with "…" at its end where something is missing.
std::string elided(const std::string& text, double size, double width);
// A text broken between words into lines of at most this width, the last of at most `most` lines
// cut. A word that is too long alone is cut too.
std::vector<std::string> wrapped(const std::string& text, double size, double width, std::size_t most);

}  // namespace pipeline
