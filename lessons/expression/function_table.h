#pragma once
#include <span>
#include <string_view>

#include "lessons/expression/expression.h"

namespace lessons {

// What a function is called with.
enum class Takes : std::uint8_t {
    Number,            // f(number)
    TwoNumbers,        // f(number, number)
    Vector,            // f(vector)
    TwoVectors,        // f(vector, vector), of the same length
    Choice,            // f(truth, a, b)
    Buffer,            // f(intensity), f(intensity, r)
    Element,           // f(normal, 268, 281), f(vertices.world, 4, z): a pixel's x and y, or the index of a vertex or
                       // polygon; then a channel r g b, x y z or 0 1 2, without which all are given
    ElementCondition,  // f(overdraw > 1), f(polygons.verdict = back-facing): over the elements of any one kind
    PixelCondition,    // f(n_dot_l.0 > 0.5): over the pixels where something was drawn
    PixelField,        // f(268, 281).polygon
    FragmentField,     // f(268, 281, 0).depth: a pixel and the index of a fragment, in the order of drawing
    Polygon,           // f(2): the index of a polygon over all objects
    Setting,           // f(material.0.n)
    Stage,             // f(shadow buffer)
    Changes,           // f(KEY=VALUE, …; expression)
    BufferChanges,     // f(BUFFER; KEY=VALUE, …)
    AllChanges,        // f(KEY=VALUE, …)
};

struct Function {
    std::string_view name;
    Takes takes;
    std::string_view meaning;
    // Of numbers and vectors alone: the result of one or two operands. The same for one value and at every element.
    void (*calculate)(std::span<const double> a, std::span<const double> b, std::span<double> result) = nullptr;
    // Of a frame. `operands` are the values of the call's operands that are numbers.
    pipeline::Result<Value> (*read)(const Node& call, std::span<const double> operands,
                                    const Context& context) = nullptr;
    Type gives = Type::Number;  // where it does not depend on what is read
};
std::span<const Function> functionTable();

// What is wrong with a call, at its place in the text.
inline pipeline::Error error(const Node& call, std::string found, std::string expected = {}) {
    return {call.where, std::move(found), std::move(expected)};
}

// What may stand behind the point; empty for functions without fields.
std::span<const std::string_view> fieldsOf(Takes takes);
// "(BUFFER, place, channel)", for the reference.
std::string_view callText(Takes takes);

}  // namespace lessons
