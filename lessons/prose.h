#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/expression/expression.h"

namespace lessons {

// Markdown with holes that a frame fills: "N·L is {buffer(n_dot_l.0, 268, 281) : 4}." So no number
// of the program is typed into a text, where it would go stale. `: 4` is the count of digits after
// the point; see toText(Value). A brace that is meant as such is written \{.
struct Prose {
    struct Hole {
        Expression expression;
        std::optional<int> digits;
    };
    std::vector<std::string> pieces;  // one more than there are holes: around and between them
    std::vector<Hole> holes;
    bool empty() const { return holes.empty() && (pieces.empty() || pieces.front().empty()); }
};

struct Line {
    std::string_view text;
    pipeline::SourceLocation where;  // of its first character
};

// Lines end with a newline but for the last. Up to kMaxErrors errors.
pipeline::Result<Prose> parseProse(std::span<const Line> lines, const Scope& scope);

// Errors name the hole that the frame cannot fill, or say "stopped".
pipeline::Result<std::string> filled(const Prose& prose, const Context& context);
pipeline::Result<std::string> filled(const Prose& prose, const pipeline::Frame& frame);
// For several texts: errors are added, and the text is empty then.
std::string filled(const Prose& prose, const Context& context, pipeline::Errors& errors);
// With an ellipsis in each hole: for the moment before the frame is there.
std::string withGaps(const Prose& prose);

pipeline::BufferSet buffersOf(const Prose& prose);

}  // namespace lessons
