#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/value.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/settings_table.h"

namespace lessons {

struct Function;

// A number, an operator or a call in a parsed expression.
struct Node {
    enum class Kind : std::uint8_t { Number, Negate, Add, Subtract, Multiply, Divide, Power, Call };
    Kind kind = Kind::Number;
    double number = 0;                           // Number
    const Function* function = nullptr;          // Call
    std::optional<pipeline::BufferName> buffer;  // what the call's arguments name
    std::optional<pipeline::SettingRef> setting;
    std::optional<pipeline::StageId> stage;
    std::string word;  // a field of pixel() or fragment(), a comparison of count()
    std::optional<int> channel;
    std::vector<Node> operands;  // in the order of writing
    pipeline::SourceLocation where;
};

// A formula over the results of the program, such as "buffer(n_dot_l.0, 268, 281)" or
// "count(polygons.verdict = back-facing)". Its value is that of a frame, so it follows the program.
// Operators + - * / ^ and parentheses; angles are degrees; the functions are in functionTable().
struct Expression {
    std::string text;
    Node root;
};

// What a function is called with.
enum class Takes : std::uint8_t {
    Number,         // f(number)
    TwoNumbers,     // f(number, number)
    Buffer,         // f(depth)
    Element,        // f(normal, 268, 281), f(vertices.world, 4, z): a pixel's x and y, or the index of a
                    // vertex or polygon; then a channel r g b, x y z or 0 1 2, without which all are given
    Comparison,     // f(overdraw > 1), f(polygons.verdict = back-facing); = != < <= > >=
    PixelField,     // f(268, 281).polygon
    FragmentField,  // f(268, 281, 0).depth: a pixel and the index of a fragment, in the order of drawing
    Polygon,        // f(2): the index of a polygon over all objects
    Setting,        // f(material.0.n)
    Stage,          // f(shadow buffer)
};

struct Function {
    std::string_view name;
    Takes takes;
    std::string_view meaning;
    pipeline::Result<Value> (*evaluate)(const Node& call, std::span<const double> operands,
                                        const pipeline::Frame& frame);
};
std::span<const Function> functionTable();
// What may stand behind the point; empty for functions without fields.
std::span<const std::string_view> fieldsOf(Takes takes);

// Reads an expression that stands at `where` in a file. Names are checked against the tables and
// the scene, places against the picture and the meshes; what does not exist is answered with
// the nearest that does.
pipeline::Result<Expression> parseExpression(std::string_view text, const pipeline::SourceLocation& where,
                                             const pipeline::Scene& scene);

// The buffers that an expression reads: a frame must have been asked for them.
pipeline::BufferSet buffersOf(const Expression& expression);

// The value in a frame. Errors name what the frame lacks, or say that a result is not finite.
pipeline::Result<Value> evaluate(const Expression& expression, const pipeline::Frame& frame);

}  // namespace lessons
