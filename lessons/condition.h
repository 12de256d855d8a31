#pragma once
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/expression.h"

namespace lessons {

// A node of a condition: a number, a vector of three, or true and false, at every pixel.
struct ConditionNode {
    enum class Kind : std::uint8_t {
        Number,
        Column,  // x
        Row,     // y
        Buffer,
        Negate,
        Add,
        Subtract,
        Multiply,
        Divide,
        Power,
        Call,    // a function of numbers
        Length,  // of a vector
        Dot,     // of two
        Less,
        LessEqual,
        Greater,
        GreaterEqual,
        Equal,
        NotEqual,
        Not,
        And,
        Or,
    };
    Kind kind = Kind::Number;
    int channels = 1;  // 1: a number; 3: a vector; 0: true or false
    double number = 0;
    std::optional<pipeline::BufferName> buffer{};
    int channel = -1;  // of the buffer, alone
    const Function* function = nullptr;
    std::vector<ConditionNode> operands{};
};

// A question that every pixel answers, such as "n_dot_h.0 > 0.9 && shadow.0 == 0".
//   names       buffers that stand on pixels, with .k for a light's index (left away where the scene
//               has one light) and .r .g .b, .x .y .z or .0 .1 .2 for one channel; x and y, the pixel's place
//   operators   + - * / ^, < <= > >= == !=, ! && ||, parentheses
//   functions   those of expressions that take numbers; length(vector), dot(vector, vector)
struct Condition {
    std::string text;
    ConditionNode root;
    pipeline::BufferSet buffers;  // that a frame must have been asked for
};

// Reads a condition that stands at `where`. Errors say in which column, and name the nearest that exists.
pipeline::Result<Condition> parseCondition(std::string_view text, const pipeline::SourceLocation& where,
                                           const pipeline::Scene& scene);

// As parseCondition, of an expression that gives a number at every pixel in place of true or false: "2 * n_dot_h.0 - 1".
pipeline::Result<Condition> parseNumbers(std::string_view text, const pipeline::SourceLocation& where,
                                         const pipeline::Scene& scene);

// Which pixels of a frame a condition holds for. Only those count where something was drawn.
struct ConditionMask {
    glm::ivec2 size{0};
    std::vector<bool> holds;  // row by row
    std::size_t count = 0, drawn = 0;
};
// Comparisons with NaN are false. An error names the buffer that the frame lacks, or says "stopped".
pipeline::Result<ConditionMask> evaluate(const Condition& condition, const pipeline::Frame& frame,
                                         const std::stop_token& stop = {});

// The buffer `condition`: {H, W} uint8, 1 where it holds, else 0.
pipeline::AnyBuffer bufferOf(const ConditionMask& mask);

// The buffer `expression` of what parseNumbers has read: {H, W} float64; 0 where nothing was drawn. Where the
// expression has no number, as 0/0 and 1/0, it holds NaN and infinity. Errors as those of evaluate.
pipeline::Result<pipeline::AnyBuffer> evaluateNumbers(const Condition& expression, const pipeline::Frame& frame,
                                                      const std::stop_token& stop = {});

// The pixel for which the condition holds after (or before) `from` in reading order, and from the
// other end on; nothing where it holds nowhere.
std::optional<glm::ivec2> nextHolding(const ConditionMask& mask, std::optional<glm::ivec2> from, bool forward = true);

}  // namespace lessons
