#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/run/frame.h"
#include "pipeline/steps/moment.h"

namespace pipeline {

// The algorithms as the lectures print them (L1: illumination and shadows, L2: visibility and local illumination), and
// how a step goes through their lines.

// What a line does. A line inside a loop or a branch is indented by two spaces more.
enum class LineKind : std::uint8_t {
    Do,
    Loop,       // repeats the lines below it
    If,         // carries out the lines below it where its test holds
    Elsewhere,  // is not carried out in this stage
};
// A loop that the stage's steps themselves make passes its line when it begins anew.
enum class Begins : std::uint8_t { Step, Row, Element, Phase };

struct AlgorithmLine {
    std::string_view text;  // {…} is the name of a value, and shown without its braces
    LineKind kind = LineKind::Do;
    std::string_view of{};  // Loop inside a step: the name of its list. If: of its test. Elsewhere: where it is done
    Begins begins = Begins::Step;
    // The settings that the line is for, "shading=flat|gouraud interpolation!=scanline"; empty: any. Beside the settings'
    // keys there are those of sceneFacts in algorithm.cpp.
    std::string_view when{};
    // Of the plan, "shading/ambient term", or all parts that begin alike, "shading/specular of light *": where it is left
    // out, so is the line.
    std::string_view part{};
    std::string_view where{};  // a test of the step that has to hold for the line to be passed; empty: always
};

// A row per text. Of the rows for a stage and a kind of element the first whose settings hold is the one.
struct AlgorithmText {
    std::string_view name;   // "setpixel"
    std::string_view title;  // "Depth test: setpixel, lecture 2"
    StageId stage;
    std::string_view elements;  // "vertex", or several between |
    std::string_view when;      // as of a line
    std::string_view note;      // where the program's order differs from the lecture's; may be empty
    std::span<const AlgorithmLine> lines;
};
std::span<const AlgorithmText> algorithmTable();

// A value of a step, bit for bit what its buffer holds.
struct AlgorithmValue {
    std::string name;             // as the text names it: "zbuffer(x, y)"
    std::string shown;            // with its indices: "zbuffer(250, 270)"
    std::string text;             // "742.3430"
    std::vector<double> numbers;  // 1 to 3; empty for a word
    std::string from;             // "written by polygon 0"; may be empty
    // Of a loop's variable: the first and last of what it goes through, and where it is.
    struct Range {
        std::string name;  // "x in row 270"
        std::int64_t first = 0, last = 0, at = 0;
        bool operator==(const Range&) const = default;
    };
    std::optional<Range> range{};
};

// A text as it is for one scene: the lines that its settings choose.
struct Algorithm {
    struct Line {
        const AlgorithmLine* row = nullptr;
        std::string text;     // without braces and indentation
        int indent = 0;       // levels
        std::string leftOut;  // the plan's reason; empty where it is carried out
        bool runs() const { return leftOut.empty() && row->kind != LineKind::Elsewhere; }
    };
    const AlgorithmText* row = nullptr;
    std::vector<Line> lines;
};
// Nothing where the table has none for it.
std::optional<Algorithm> algorithmOf(const Frame& frame, StageId stage, ElementKind kind);
// Whether settings are those of a `when`.
bool holds(std::string_view when, const Scene& scene, ElementKind kind);

// A line that a step passes, with the values that it names.
struct Visit {
    std::size_t line = 0;  // of Algorithm::lines
    std::vector<AlgorithmValue> values;
    std::optional<bool> taken{};  // of an If
};
// All of a step's, in order. A line inside a loop may come several times.
struct Walk {
    Algorithm algorithm;
    std::vector<Visit> visits;
    std::vector<Visit> around;  // lines of loops that an earlier step has passed and this one is inside of

    // The line's number from 1 and which of its visits it is, from 1.
    std::array<int, 2> numbersOf(std::size_t visit) const;
    // The visit of that line; the first after it where the step does not come to the line. Nothing after the last.
    std::optional<std::size_t> visitOf(int line, int time) const;
};

// Where a moment is in it.
struct AlgorithmState {
    Walk walk;
    std::optional<std::size_t> visit;          // nothing before the first step, and where the stage does not run
    bool over = false;                         // the step is over; else the visit's line is about to write
    std::vector<std::string> leftOut() const;  // a sentence per reason: "Lines 1 and 7 to 9 are left out. …"
};

// What a line of the text is at that moment, for whoever shows it.
enum class LineStatus : std::uint8_t {
    Now,
    Passed,
    Next,
    Ahead,
    NotTaken,   // of a branch that was not taken
    LeftOut,    // by the plan
    Elsewhere,  // in another stage
};
struct AlgorithmRow {
    int number = 1;
    std::string text;  // without indentation
    int indent = 0;    // levels of two spaces
    LineStatus status = LineStatus::Ahead;
    std::vector<AlgorithmValue> values;  // those that the line has had so far
    std::string valuesText;              // "671.9340 < 742.3430", of a line that is no If "671.9340"
    std::string named;                   // "z = 671.9340 < zbuffer(250, 270) = 742.3430"
    std::optional<bool> taken{};         // of an If that has been passed
    std::string remark;  // "true, taken", "next", "left out", "in shading, once per pixel"; may be empty
};
std::vector<AlgorithmRow> rowsOf(const AlgorithmState& state);
// The variable of the innermost loop that the lit line is in; null where there is none.
const AlgorithmValue* innermostLoop(const std::vector<AlgorithmRow>& rows);

enum class AlgorithmFormat : std::uint8_t { Text, Latex };
inline constexpr std::array<std::string_view, 2> kAlgorithmFormats{"text", "latex"};
// The text with its values, a line each. LaTeX: a tabular in typewriter letters.
std::string algorithmText(const AlgorithmState& state, AlgorithmFormat format);

}  // namespace pipeline
