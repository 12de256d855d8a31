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
// the way of a step through their lines.

// What a line does. A line inside a loop or a branch is indented by two more spaces.
enum class LineKind : std::uint8_t {
    Do,
    Loop,       // repeats the lines below it
    If,         // runs the lines below it if its test is true
    Elsewhere,  // another stage does it
};
// The loops that the stage's steps make themselves: such a loop passes its line when it starts a new turn.
enum class Begins : std::uint8_t { Step, Row, Element, Phase };

struct AlgorithmLine {
    std::string_view text;  // {…} marks the name of a value; the braces are not shown
    LineKind kind = LineKind::Do;
    std::string_view of{};  // Loop inside a step: name of its list. If: name of its test. Elsewhere: the stage
    Begins begins = Begins::Step;
    // The settings for which the line exists, "shading=flat|gouraud interpolation!=scanline"; empty: any. The keys are
    // those of settings and of sceneFacts in algorithm.cpp.
    std::string_view when{};
    // The part of the plan, "shading/ambient term", or all parts with the same beginning, "shading/specular of light
    // *". If the part is left out, so is the line.
    std::string_view part{};
    std::string_view where{};  // a test of the step that must be true for the line to be passed; empty: always
};

// One row for each text. For a stage and a kind of element, the first row whose settings fit is used.
struct AlgorithmText {
    std::string_view name;   // "setpixel"
    std::string_view title;  // "Depth test: setpixel, lecture 2"
    StageId stage;
    std::string_view elements;  // "vertex", or several separated by |
    std::string_view when;      // as in AlgorithmLine
    std::string_view note;      // where the program's order differs from the lecture's; may be empty
    std::span<const AlgorithmLine> lines;
};
std::span<const AlgorithmText> algorithmTable();

// A value of a step, with the same bits as in its buffer.
struct AlgorithmValue {
    std::string name;             // as the text names it: "zbuffer(x, y)"
    std::string shown;            // with the indices filled in: "zbuffer(250, 270)"
    std::string text;             // "742.3430"
    std::vector<double> numbers;  // 1 to 3; empty for a word
    std::string from;             // "written by polygon 0"; may be empty
    // For a loop's variable: the first and last number of its range, and the current one.
    struct Range {
        std::string name;  // "x in row 270"
        std::int64_t first = 0, last = 0, at = 0;
        bool operator==(const Range&) const = default;
    };
    std::optional<Range> range{};
};

// A text for one scene, with the lines that its settings choose.
struct Algorithm {
    struct Line {
        const AlgorithmLine* row = nullptr;
        std::string text;     // without braces and indentation
        int indent = 0;       // levels
        std::string leftOut;  // the plan's reason; empty if it runs
        bool runs() const { return leftOut.empty() && row->kind != LineKind::Elsewhere; }
    };
    const AlgorithmText* row = nullptr;
    std::vector<Line> lines;
};
// Empty if the table has no text for it.
std::optional<Algorithm> algorithmOf(const Frame& frame, StageId stage, ElementKind kind);
// Whether the scene's settings fit a `when`.
bool holds(std::string_view when, const Scene& scene, ElementKind kind);

// A line that a step passes, with the values that it names.
struct Visit {
    std::size_t line = 0;  // of Algorithm::lines
    std::vector<AlgorithmValue> values;
    std::optional<bool> taken{};  // of an If
};
// All visits of a step, in order. A line inside a loop may come several times.
struct Walk {
    Algorithm algorithm;
    std::vector<Visit> visits;
    std::vector<Visit> around;  // lines of enclosing loops that an earlier step has passed

    // The line's number and the number of its visit, both from 1.
    std::array<int, 2> numbersOf(std::size_t visit) const;
    // The visit of that line, or the next later one if the step does not reach the line. Empty after the last.
    std::optional<std::size_t> visitOf(int line, int time) const;
};

// The place of a moment in a walk.
struct AlgorithmState {
    Walk walk;
    std::optional<std::size_t> visit;          // empty before the first step, and if the stage does not run
    bool over = false;                         // the step is over; otherwise the line of the visit is about to write
    std::vector<std::string> leftOut() const;  // one sentence for each reason: "Lines 1 and 7 to 9 are left out. …"
};

// The state of a line at that moment, for display.
enum class LineStatus : std::uint8_t {
    Now,
    Passed,
    Next,
    Ahead,
    NotTaken,   // in a branch that was not taken
    LeftOut,    // by the plan
    Elsewhere,  // in another stage
};
struct AlgorithmRow {
    int number = 1;
    std::string text;  // without indentation
    int indent = 0;    // levels of two spaces
    LineStatus status = LineStatus::Ahead;
    std::vector<AlgorithmValue> values;  // the values that the line has had so far
    std::string valuesText;              // "671.9340 < 742.3430"; for other lines than If "671.9340"
    std::string named;                   // "z = 671.9340 < zbuffer(250, 270) = 742.3430"
    std::optional<bool> taken{};         // for an If that has been passed
    std::string remark;  // "true, taken", "next", "left out", "in shading, once per pixel"; may be empty
};
std::vector<AlgorithmRow> rowsOf(const AlgorithmState& state);
// The variable of the innermost loop around the current line, or null.
const AlgorithmValue* innermostLoop(const std::vector<AlgorithmRow>& rows);

enum class AlgorithmFormat : std::uint8_t { Text, Latex };
inline constexpr std::array<std::string_view, 2> kAlgorithmFormats{"text", "latex"};
// The text with its values, one line each. LaTeX: a tabular in typewriter font.
std::string algorithmText(const AlgorithmState& state, AlgorithmFormat format);

}  // namespace pipeline
