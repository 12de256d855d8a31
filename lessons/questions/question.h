#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "lessons/prose.h"
#include "pipeline/defects/own.h"
#include "pipeline/scene/scene.h"

// The questions of a lesson as data. lessons/questions/attempt.h asks them, resources/manual/write-a-lesson.md has their syntax.

namespace lessons {

// A wrong answer that a known misconception gives.
struct Mistake {
    std::string id;    // a row of lessons/misconceptions.md
    Expression value;  // of a number: what somebody answers then; of a click: true for what somebody picks then
    Prose said;        // what happens instead; never the answer
    pipeline::SourceLocation where;
};

// Something that can be clicked.
enum class ThingKind : std::uint8_t { Pixel, Polygon, Vertex, Object, Light };
std::string_view name(ThingKind kind);
std::optional<ThingKind> thingNamed(std::string_view word);
// How many a scene has; of pixels none.
std::size_t countOf(ThingKind kind, const pipeline::Scene& scene);
struct Thing {
    ThingKind kind = ThingKind::Polygon;
    std::size_t index = 0;  // over all objects; of a light its number; of a pixel not used
    bool operator==(const Thing&) const = default;
};

struct NumberQuestion {
    Expression answer;  // one number
    // How far off an answer may be: absolute, or relative to the answer's magnitude.
    double tolerance = 0;
    bool relative = false;
    std::string unit;  // "px", "°"; may be empty
    std::vector<Mistake> mistakes;
};

struct Option {
    Prose text;
    Expression holds;            // a condition
    Prose said;                  // to somebody who has chosen it; may be empty
    std::string mistake;         // id of the misconception behind a wrong option; may be empty
    std::optional<Thing> thing;  // of the scene: a click on it toggles the option
    pipeline::SourceLocation where;
};

// One option holds.
struct ChoiceQuestion {
    std::vector<Option> options;  // 2 to 9
    bool ofStages = false;        // the six stages in their order: the first that differs is right
};

// Any number of options hold, at least one and not all.
struct SeveralQuestion {
    std::vector<Option> options;      // 2 to 9
    std::optional<Mistake> opposite;  // said where exactly the others were chosen; its value is not used
};

struct ClickQuestion {
    ThingKind kind = ThingKind::Pixel;
    Expression holds;  // a condition over pick.x, pick.polygon, …
    // Of a pixel where the question names a place: x and y of it, pixels, and how far off a click may be.
    std::optional<Expression> near;
    double within = 0;  // px
    std::vector<Mistake> mistakes;
};

// The reader changes settings until a condition holds in the reader's own frame.
struct UntilQuestion {
    Expression holds;
    std::vector<std::string> free;  // keys of the settings that may be changed
    // Values with which the condition holds, one for each of these keys: for Show me, for paper, for the check.
    struct Setting {
        std::string key;
        std::string word;                  // of a choice or a switch
        std::optional<Expression> number;  // of any other setting
    };
    std::vector<Setting> answer;
    std::vector<Mistake> mistakes;  // conditions on the reader's frame, judged where the hand stands
};

struct OrderItem {
    Prose text;
    Expression key;                          // a number; smaller ones come first
    std::optional<pipeline::StageId> stage;  // that the item stands for; its key is the stage's place
    pipeline::SourceLocation where;
};

// The reader puts items into the order of their keys.
struct OrderQuestion {
    std::vector<OrderItem> items;  // 2 to 9, as they stand in the beginning
    std::string first, last;       // what the two ends are called, "nearest", "farthest"; may be empty
    struct Wrong {
        Mistake mistake;                 // its value is not used
        std::vector<std::size_t> order;  // of the items; empty: the opposite of the right one
    };
    std::vector<Wrong> mistakes;
};

// The reader writes a function of the pipeline, in JavaScript.
struct WriteQuestion {
    pipeline::OwnContract contract;  // with the question's own tolerance
    std::string start, answer;       // whole functions; the start is what the editor has first
    std::vector<Mistake> mistakes;   // of the contract; their value is not used
    struct Trial {
        std::string name;  // as the lesson has it
        pipeline::Scene scene;
    };
    std::vector<Trial> trials;  // judged after the page's scene, at most 4
    std::size_t lines = 0;      // empty ones, on paper
};

struct Question {
    Prose text;
    Prose paper;                // the question as paper asks it; empty: as text
    std::vector<Prose> hints;   // each says more; the last one has all operands
    Prose works;                // the way of working, a step a line; may be empty
    Prose right, wrong;         // may be empty
    double points = 1;          // of a right first answer without a hint
    bool isPrediction = false;  // a wrong first answer costs nothing
    std::variant<NumberQuestion, ChoiceQuestion, SeveralQuestion, ClickQuestion, UntilQuestion, OrderQuestion,
                 WriteQuestion>
        kind;
    pipeline::SourceLocation where;
};

// "number", "choice", "several", "click", "until", "order", "write".
std::string_view kindName(const Question& question);
// The options of a choice or several, else none.
std::span<const Option> optionsOf(const Question& question);
// The texts of its options, or of the items to be put in order; else none.
std::vector<const Prose*> rowsOf(const Question& question);
// The named mistakes of a number, click, until or write, else none.
std::span<const Mistake> mistakesOf(const Question& question);

// The ids of the misconceptions that its wrong answers name.
std::set<std::string> mistakeIds(const Question& question);
// Whether each of 0 to count − 1 is in it once.
bool isOrderOf(std::vector<std::size_t> order, std::size_t count);

// All texts of a question, those of its options and mistakes too.
std::vector<const Prose*> textsOf(const Question& question);
// The expressions that give the answer away in the page's own frame. None of until: there the reader's frame is the answer.
std::vector<const Expression*> answersOf(const Question& question);
// All expressions that are evaluated to judge an answer.
std::vector<const Expression*> expressionsOf(const Question& question);

}  // namespace lessons
