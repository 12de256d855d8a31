#pragma once
#include <string>
#include <vector>

#include "pipeline/compare/verdict.h"
#include "pipeline/export/json/json.h"

namespace pipeline::foreign {

// A line for a terminal, with no line break.
struct TextLine {
    std::string text;
    bool bold = false;
};
// Verdict, a row a stage, worst, likely, conventions, files. plain: marks in ASCII. columns: of the terminal.
std::vector<TextLine> reportText(const Report& report, bool plain, std::size_t columns);

// One object; its members stand in the manual.
Json reportJson(const Report& report, int exitStatus);

// "28 × closer", "clear", "as color", "cannot tell", "by hand".
std::string certaintyText(const Convention& convention);
// Whether it belongs into mine.toml, which is read for all files: no file contradicts it, and either several files share it
// or the file that has it agrees. A wrong file alone gives no advice: the reading that suits it best may be wrong too.
bool isAdvised(const Report& report, const Convention& convention);
// The mark of a standing: "✓", "✗", "↯", "–", "?"; plain "ok", "XX", "->", "--", "??".
std::string_view mark(Standing standing, bool plain);

}  // namespace pipeline::foreign
