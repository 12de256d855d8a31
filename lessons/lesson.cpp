#include "lessons/lesson.h"

#include <cassert>
#include <cmath>

namespace lessons {

pipeline::FrameRequest requestFor(const Page& page) {
    pipeline::FrameRequest request;
    for (const pipeline::BufferName& buffer : page.state.buffers) request.wanted.set(index(buffer.id));
    request.wanted |= buffersOf(page.text);
    if (page.question) {
        const Question& question = *page.question;
        request.wanted |= buffersOf(question.answer);
        for (const Prose* prose : {&question.text, &question.hint, &question.right, &question.wrong})
            request.wanted |= buffersOf(*prose);
    }
    return request;
}

pipeline::Result<double> answerOf(const Page& page, const pipeline::Frame& frame) {
    assert(page.question);
    const Expression& answer = page.question->answer;
    const auto value = evaluate(answer, frame);
    if (!value) return value.errors();
    if (value->numbers.size() != 1) return pipeline::Error{answer.root.where, "found " + toText(*value), "one number"};
    return value->numbers.front();
}

bool isRight(double answer, std::string_view typed, double tolerance) {
    const auto number = numberIn(typed);
    return number && std::abs(*number - answer) <= tolerance;
}

}  // namespace lessons
