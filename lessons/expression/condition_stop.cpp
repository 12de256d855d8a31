#include "lessons/expression/condition_stop.h"

#include <algorithm>

namespace lessons {
namespace {

using pipeline::Moment;
using pipeline::StageId;
using pipeline::Steps;

bool readsShading(const Node& node) {
    return (node.buffer && bufferInfo(node.buffer->id).stage == StageId::Shading) ||
           std::ranges::any_of(node.operands, readsShading);
}

ConditionMask maskAt(const Steps& steps, Moment moment, const Expression& condition, const pipeline::Stop& stop) {
    const pipeline::FramePtr frame = steps.frameAt(moment, 0, stop);
    if (!frame) return {};
    const auto mask = maskOf(condition, {.frame = *frame, .stop = stop});
    return mask ? *mask : ConditionMask{};
}

// The first step in (begin, end] after which isIt(pixel) of the pixel that it drew.
template <class IsIt>
std::optional<ConditionStop> firstStep(const Steps& steps, Moment begin, std::int64_t end, const pipeline::Stop& stop,
                                       IsIt isIt) {
    while (begin.done < end && !stop.stop_requested()) {
        Moment at = begin;
        for (const glm::ivec2 pixel : steps.pixelsToCome(begin))
            if (++at.done <= end && isIt(pixel)) return ConditionStop{at, pixel};
        begin = steps.next(begin, pipeline::StepLevel::Polygon).value_or(Moment{begin.stage, end});
    }
    return std::nullopt;
}

bool holdsAt(const ConditionMask& mask, glm::ivec2 pixel) {
    const std::size_t i = std::size_t(pixel.y) * std::size_t(mask.size.x) + std::size_t(pixel.x);
    return i < mask.holds.size() && mask.holds[i];
}

std::optional<ConditionStop> inZBuffer(const Steps& steps, Moment from, const Expression& condition,
                                       const pipeline::Stop& stop, const StopProgress& progress) {
    const Moment end{StageId::ZBuffer, steps.total(StageId::ZBuffer)};
    ConditionMask before = maskAt(steps, from, condition, stop);
    while (from < end && !stop.stop_requested()) {
        const Moment next = std::min(steps.next(from, pipeline::StepLevel::Polygon).value_or(end), end);
        ConditionMask after = maskAt(steps, next, condition, stop);
        const auto found = firstStep(steps, from, next.done, stop, [&](glm::ivec2 pixel) {
            return holdsAt(after, pixel) && !holdsAt(before, pixel);
        });
        if (found) return found;
        from = next;
        before = std::move(after);
        if (progress) progress(0.9 * double(from.done) / double(std::max<std::int64_t>(1, end.done)));
    }
    return std::nullopt;
}

}  // namespace

std::optional<ConditionStop> nextStop(const Steps& steps, Moment from, const Expression& condition,
                                      const pipeline::Stop& stop, const StopProgress& progress) {
    const Moment zEnd{StageId::ZBuffer, steps.total(StageId::ZBuffer)};
    if (!readsShading(condition.root) && steps.runs(StageId::ZBuffer) && from < zEnd) {
        const Moment begin = std::max(from, Moment{StageId::ZBuffer, 0});
        if (const auto found = inZBuffer(steps, begin, condition, stop, progress)) return found;
    }
    if (stop.stop_requested() || !steps.runs(StageId::Shading)) return std::nullopt;
    const auto mask = maskOf(condition, {.frame = *steps.frame(), .stop = stop});
    if (!mask || mask->count == 0) return std::nullopt;
    return firstStep(steps, std::max(from, Moment{StageId::Shading, 0}), steps.total(StageId::Shading), stop,
                     [&](glm::ivec2 pixel) { return holdsAt(*mask, pixel); });
}

}  // namespace lessons
