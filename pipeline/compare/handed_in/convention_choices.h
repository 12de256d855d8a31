#pragma once
#include <map>
#include <string>
#include <vector>

#include "pipeline/compare/verdict.h"

// Conventions that somebody states by hand, in a window or a page.

namespace pipeline::foreign {

// The text of mine.toml with other values for these keys.
using StatedByHand = std::map<std::string, std::string>;
std::string withStated(const std::string& text, const StatedByHand& byHand);

// One key of mine.toml that some of the files can be read by.
struct ConventionChoice {
    std::string key;
    std::string value;                // as the files are read now
    std::vector<std::string> values;  // all that there are
    std::string certainty;            // "28 × closer"; empty where the program's own reading is taken without a word
    std::string buffers;              // that are read so: "color, depth"
};
// Those that were found first.
std::vector<ConventionChoice> conventionChoices(const Report& report);

}  // namespace pipeline::foreign
