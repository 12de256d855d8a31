#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/expression/value.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/settings_table.h"

// One language for the answers and holes of lessons, for conditions over all pixels and for buffers made of a formula.
//
//   numbers     2.5, pi; angles are degrees
//   operators   + - * / ^ and parentheses; 2^3^2 is 2^9
//   comparisons < <= > >= = != of numbers, = != of vectors and words; == is =
//   truth       not and or, also written ! && ||
//   vectors     [a, b, c], buffer(normal, 268, 281), .x .y .z (or .r .g .b, .0 .1 .2) for one of their numbers
//   functions   those of functionTable(): if(c, a, b), sqrt(x), count(overdraw > 1), with(shading=gouraud; …)
//   names       pick.x … where something was picked, and those that a lesson gives: let half = …
//
// A formula over elements also names buffers, which stand for their numbers at each element, and x and y, the
// column and row of a pixel. A light's index may be left away where the scene has one light.

namespace lessons {

struct Function;

enum class Type : std::uint8_t { Number, Vector, Truth, Words };

// What somebody has clicked. Indices count over all objects, as in the buffers.
struct Pick {
    std::optional<double> x{}, y{};  // pixels
    std::optional<double> polygon{}, vertex{}, object{}, light{};
};
struct PickField {
    std::string_view name;
    std::optional<double> Pick::*value;
};
std::span<const PickField> pickFields();

// A number, a word, an operator or a call in a parsed expression.
struct Node {
    enum class Kind : std::uint8_t {
        Number,
        Words,
        Column,   // x, of a pixel
        Row,      // y
        Element,  // a buffer's numbers at the element
        Picked,
        Vector,
        Component,
        Negate,
        Add,
        Subtract,
        Multiply,
        Divide,
        Power,
        Less,
        LessEqual,
        Greater,
        GreaterEqual,
        Equal,
        NotEqual,
        Not,
        And,
        Or,
        Call,
    };
    Kind kind = Kind::Number;
    Type type = Type::Number;
    int size = 1;         // numbers in it: of a vector 2 to 4, else 1
    bool varies = false;  // from element to element
    double number = 0;    // Number
    std::string word;     // Words; a field of pixel() or fragment()
    const PickField* picked = nullptr;
    const Function* function = nullptr;          // Call
    std::optional<pipeline::BufferName> buffer;  // what an element or a call reads
    std::optional<pipeline::SettingRef> setting;
    std::optional<pipeline::StageId> stage;
    std::optional<int> channel;        // of the buffer, or a component's
    std::vector<std::string> changes;  // "KEY=VALUE", of with() and differing()
    pipeline::BufferSet changed;       // that the frame with these changes must have been asked for
    std::vector<Node> operands;        // in the order of writing
    pipeline::SourceLocation where;
};

struct Expression {
    std::string text;
    Node root;
    pipeline::BufferSet buffers;  // that a frame must have been asked for
    int operators = 0;            // in it
};

// Names that a lesson gives to expressions.
using Names = std::map<std::string, Expression, std::less<>>;
// Why a name cannot be given, or empty.
std::string whyNoName(std::string_view name);

// What the names in an expression may refer to.
struct Scope {
    const pipeline::Scene& scene;
    const Names* names = nullptr;
    bool mayPick = false;
};

// Reads an expression that stands at `where` in a file, of any type. Names are checked against the tables and the
// scene, places against the picture and the meshes; an error names the nearest that exists. At most 4096 characters,
// 500 operators, 50 parentheses, signs and calls within one another.
pipeline::Result<Expression> parseExpression(std::string_view text, const pipeline::SourceLocation& where,
                                             const Scope& scope);
// The same of a formula that every pixel answers: with true or false, "n_dot_h.0 > 0.9 and shadow.0 = 0", or with a
// number, "2 * n_dot_l.0 - 1".
pipeline::Result<Expression> parseCondition(std::string_view text, const pipeline::SourceLocation& where,
                                            const Scope& scope);
pipeline::Result<Expression> parseNumbers(std::string_view text, const pipeline::SourceLocation& where,
                                          const Scope& scope);

class ChangedFrames;

// Values of calls that do not depend on what is picked, by call and frame: kept while many picks are tried on one frame,
// which lives as long as this.
struct KeptValues {
    std::map<std::pair<const Node*, const pipeline::Frame*>, Value> of;
};

// What an expression is evaluated with.
struct Context {
    const pipeline::Frame& frame;
    ChangedFrames* changed = nullptr;  // remembers the frames of with(); without it each call computes its own
    const Pick* pick = nullptr;
    pipeline::Stop stop{};
    KeptValues* kept = nullptr;
};

// The value in a frame. Errors name what the frame lacks, say that a result is not finite, or say "stopped".
pipeline::Result<Value> evaluate(const Expression& expression, const Context& context);

}  // namespace lessons
