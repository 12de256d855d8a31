#pragma once
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "lessons/questions/question.h"
#include "pipeline/defects/own_judge.h"

namespace lessons {

// What somebody answers. To a question of kind until: nothing, the reader's frame is the answer.
struct Typed {
    std::string text;
};
struct Chosen {
    std::vector<std::size_t> options;  // indices, each once
};
struct Reached {};
struct Ordered {
    std::vector<std::size_t> items;  // indices in the reader's order, each once
};
// To a question of kind write: the text, and what its results in a scene were judged to be.
struct Written {
    std::string text;
    std::string trial;  // the name of the trial; empty: the page's own scene, or all of them where the verdict is right
    pipeline::OwnVerdict verdict;
};
using Given = std::variant<Typed, Chosen, Pick, Reached, Ordered, Written>;

enum class Mark : std::uint8_t {
    Right,
    Known,   // a mistake that has a name
    NotYet,  // another wrong answer
    Again,   // nothing to be judged: no number, too few digits, nothing chosen; costs nothing
};

struct Verdict {
    Mark mark = Mark::Again;
    std::string mistake;  // of Known: its id
    std::string name;     // of Known: what the table of misconceptions calls it
    std::string said;     // Markdown
};

// Judges an answer and speaks about it by one frame: the page's own (of requestFor(page)), for a question of kind until
// the reader's. Errors: what this frame cannot evaluate or fill in, or "stopped". hinted: a hint was seen, so that the way
// to a place may be said.
pipeline::Result<Verdict> judge(const Question& question, const Given& given, const Context& context,
                                bool hinted = false);

// What stands in the answer's place: "310", "35.376 ± 0.06 °", "B: A wider highlight", "polygons 0 and 4", "n = 4",
// "B, A: the near pane; the far pane". Markdown.
pipeline::Result<std::string> answerText(const Question& question, const Context& context);

// What has been picked when this thing has, which is no pixel.
Pick pickOf(const Thing& thing);

// Indices of the options that hold.
pipeline::Result<std::vector<std::size_t>> holdingOptions(std::span<const Option> options, const Context& context);

// The right order of the items. An error where two have the same key.
pipeline::Result<std::vector<std::size_t>> rightOrder(const OrderQuestion& order, const Context& context);

// What an order is worth where it may be handed in once: the share of pairs that stand the right way round less the share
// of those that do not (Kendall's τ), at least 0. Both have the same items, at least two. 1: all of them; what is drawn by
// lot has a τ of 0 on average.
double shareInOrder(std::span<const std::size_t> right, std::span<const std::size_t> given);

// How far a question of kind until is from its condition, where that compares two numbers.
struct Gauge {
    double value = 0, needed = 0;  // left and right side
    std::string comparison;        // "≥"
    bool holds = false;
    std::string said;  // "0.158, needed ≥ 0.686"
};
pipeline::Result<std::optional<Gauge>> gaugeOf(const UntilQuestion& until, const Context& context);

// How far off an answer to a number may be.
double toleranceOf(const NumberQuestion& number, double answer);

}  // namespace lessons
