#include "lessons/lesson.h"

#include <cassert>
#include <cmath>

#include "pipeline/run/runner.h"

namespace lessons {

pipeline::FrameRequest requestFor(const Page& page) {
    pipeline::FrameRequest request;
    for (const pipeline::BufferName& buffer : page.state.buffers) request.wanted.set(index(buffer.id));
    request.wanted |= buffersOf(page.text);
    if (page.question) {
        const Question& question = *page.question;
        request.wanted |= question.answer.buffers;
        for (const Prose* prose : {&question.text, &question.hint, &question.right, &question.wrong})
            request.wanted |= buffersOf(*prose);
    }
    return request;
}

bool runPages(const Lesson& lesson, const std::stop_token& stop, const PageVisit& visit) {
    pipeline::FramePtr frame;  // what the next page has in common with it need not run again
    for (std::size_t number = 0; number < lesson.pages.size(); ++number) {
        const Page& page = lesson.pages[number];
        pipeline::FrameRequest request = requestFor(page);
        request.stop = stop;
        frame = runFrame(std::make_shared<const pipeline::Scene>(page.state.scene), request, frame);
        if (frame) visit(page, number, *frame);
        if (stop.stop_requested()) return false;
    }
    return true;
}

pipeline::Result<double> answerOf(const Page& page, const pipeline::Frame& frame) {
    assert(page.question);
    const Expression& answer = page.question->answer;
    const auto value = evaluate(answer, {.frame = frame});
    if (!value) return value.errors();
    if (answer.root.type != Type::Number)
        return pipeline::Error{answer.root.where, "found " + toText(*value), "one number"};
    return value->numbers.front();
}

bool isRight(double answer, std::string_view typed, double tolerance) {
    const auto number = numberIn(typed);
    return number && std::abs(*number - answer) <= tolerance;
}

}  // namespace lessons
