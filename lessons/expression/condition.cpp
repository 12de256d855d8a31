#include "lessons/expression/condition.h"

#include <algorithm>

#include "lessons/expression/elements.h"

namespace lessons {

namespace {

using pipeline::AnyBuffer;
using pipeline::Error;

// take(i, number) for every pixel i, in reading order, where something was drawn, with the root's number there.
template <class Take>
std::optional<Error> goThroughDrawn(const Node& root, const Context& context, const AnyBuffer& polygons, Take take) {
    const auto ids = std::get<std::span<const std::int32_t>>(polygons.data);
    const auto layers = context.frame.buffer({pipeline::BufferId::Layers});
    const auto isDrawn = [&](std::size_t i) { return ids[i] >= 0 || (layers && layers->flat(i) > 0); };
    const auto values = ElementValues::of(root, context);
    if (!values) return values.errors().front();
    // Runs without a drawn pixel are left out: most of a picture may be empty.
    constexpr std::size_t kRun = 1024;
    for (std::size_t first = 0; first < ids.size(); first += kRun) {
        if (context.stop.stop_requested()) return Error{{}, "stopped"};
        const std::size_t end = std::min(first + kRun, ids.size());
        std::size_t i = first;
        while (i < end && !isDrawn(i)) ++i;
        if (i == end) continue;
        const std::vector<double> numbers = values->numbers(first, end - first);
        for (; i < end; ++i)
            if (isDrawn(i)) take(i, numbers[i - first]);
    }
    return {};
}

constexpr const char* kNoPolygons = "no polygon_id in this frame: the z-buffer has not run";

}  // namespace

pipeline::Result<ConditionMask> maskOf(const Node& condition, const Context& context) {
    const auto polygons = context.frame.buffer({pipeline::BufferId::PolygonId});
    if (!polygons) return Error{{}, kNoPolygons};
    ConditionMask mask{{int(polygons->columns()), int(polygons->rows())}, std::vector<bool>(polygons->count())};
    const auto error = goThroughDrawn(condition, context, *polygons, [&](std::size_t i, double truth) {
        ++mask.drawn;
        if (truth == 0) return;
        mask.holds[i] = true;
        ++mask.count;
    });
    if (error) return *error;
    return mask;
}

AnyBuffer bufferOf(const ConditionMask& mask) {
    const auto owner = std::make_shared<std::vector<std::uint8_t>>(mask.holds.begin(), mask.holds.end());
    return {{pipeline::BufferId::Condition},
            &bufferInfo(pipeline::BufferId::Condition),
            {std::size_t(mask.size.y), std::size_t(mask.size.x)},
            std::span<const std::uint8_t>(*owner),
            owner};
}

pipeline::Result<AnyBuffer> numbersOf(const Expression& expression, const Context& context) {
    const auto polygons = context.frame.buffer({pipeline::BufferId::PolygonId});
    if (!polygons) return Error{{}, kNoPolygons};
    const auto owner = std::make_shared<std::vector<double>>(polygons->count());
    const auto error = goThroughDrawn(expression.root, context, *polygons,
                                      [&](std::size_t i, double number) { (*owner)[i] = number; });
    if (error) return *error;
    return AnyBuffer{{pipeline::BufferId::Expression},
                     &bufferInfo(pipeline::BufferId::Expression),
                     {polygons->rows(), polygons->columns()},
                     std::span<const double>(*owner),
                     owner};
}

std::optional<glm::ivec2> nextHolding(const ConditionMask& mask, std::optional<glm::ivec2> from, bool forward) {
    const std::size_t n = mask.holds.size();
    if (mask.count == 0) return {};
    const auto width = std::size_t(mask.size.x);
    std::size_t at = forward ? n - 1 : 0;
    if (from) at = std::size_t(from->y) * width + std::size_t(from->x);
    for (std::size_t i = 0; i < n; ++i) {
        at = forward ? (at + 1) % n : (at + n - 1) % n;
        if (mask.holds[at]) return glm::ivec2(at % width, at / width);
    }
    return {};
}

}  // namespace lessons
