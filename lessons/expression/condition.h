#pragma once
#include "lessons/expression/expression.h"
#include "pipeline/buffers/any_buffer.h"

// What parseCondition and parseNumbers have read, at all pixels.

namespace lessons {

// Which pixels of a frame a condition holds for. Only those count where something was drawn.
struct ConditionMask {
    glm::ivec2 size{0};
    std::vector<bool> holds;  // row by row
    std::size_t count = 0, drawn = 0;
};
// Comparisons with NaN are false. An error names the buffer that the frame lacks, or says "stopped".
pipeline::Result<ConditionMask> maskOf(const Node& condition, const Context& context);
inline pipeline::Result<ConditionMask> maskOf(const Expression& condition, const Context& context) {
    return maskOf(condition.root, context);
}

// The buffer `condition`: {H, W} uint8, 1 where it holds, else 0.
pipeline::AnyBuffer bufferOf(const ConditionMask& mask);

// The buffer `expression` of what parseNumbers has read: {H, W} float64; 0 where nothing was drawn. Where the
// expression has no number, as 0/0 and 1/0, it holds NaN and infinity. Errors as those of maskOf.
pipeline::Result<pipeline::AnyBuffer> numbersOf(const Expression& expression, const Context& context);

// The pixel for which the condition holds after (or before) `from` in reading order, and from the
// other end on; nothing where it holds nowhere.
std::optional<glm::ivec2> nextHolding(const ConditionMask& mask, std::optional<glm::ivec2> from, bool forward = true);

}  // namespace lessons
