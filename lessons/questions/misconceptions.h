#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"

namespace lessons {

// A row of lessons/misconceptions.md, the one table of what people get wrong: for feedback, results, planted defects and
// the comparison of one's own renderer.
struct Misconception {
    std::string id;      // letters a to z, digits and -
    std::string name;    // a few words, for a heading: "rows counted from the bottom"
    std::string stage;   // the stage that it is about, or "lesson", "scene"
    std::string defect;  // id of the defect that plants it; may be empty
    std::string source;  // of the claim that people believe it
};

struct Misconceptions {
    std::vector<Misconception> rows;
    pipeline::Errors errors;  // of lines that are no rows; empty for the file that comes with the program
};

// Read once. Empty with an error where the file is missing.
const Misconceptions& misconceptions();
Misconceptions parseMisconceptions(std::string_view text, const std::string& file);

// Null where no row has this id.
const Misconception* findMisconception(std::string_view id);

}  // namespace lessons
