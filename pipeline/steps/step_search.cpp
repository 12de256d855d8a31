// Looking ahead for the next step that has to do with something.
#include <algorithm>

#include "pipeline/steps/step_source.h"
#include "pipeline/steps/steps.h"

namespace pipeline {

template <class EndIn>
std::optional<Moment> Steps::search(Moment moment, EndIn endIn) const {
    moment = fitting(moment);
    for (std::size_t stage = index(moment.stage); stage < kStageCount; ++stage) {
        const StageId id = kStages[stage];
        const std::int64_t done = id == moment.stage ? moment.done : 0;
        for (const StepPhase& phase : phases(id)) {
            if (done >= phase.first + phase.total()) continue;
            const std::int64_t within = std::max<std::int64_t>(0, done - phase.first);
            for (std::size_t i = at(id, phase.first + within).element; i < phase.count; ++i) {
                const std::int64_t over = std::max<std::int64_t>(0, within - phase.begin(i));
                if (const std::int64_t end = endIn(Spot{id, &phase, i}, over); end > over)
                    return Moment{id, phase.first + phase.begin(i) + end};
            }
        }
    }
    return std::nullopt;
}

std::optional<Moment> Steps::nextAt(Moment moment, glm::ivec2 pixel) const {
    return search(moment, [&](const Spot& spot, std::int64_t) {
        std::int64_t before = 0;
        if (spot.phase->rows.empty()) return before;
        for (const PixelSpan& span : m_source->spans(spot.stage, spot.element)) {
            if (span.y == pixel.y && span.first <= pixel.x && pixel.x <= span.last)
                return before + pixel.x - span.first + 1;
            before += span.length();
        }
        return std::int64_t(0);
    });
}

std::optional<Moment> Steps::nextAt(Moment moment, Thing thing, std::uint32_t number) const {
    return search(moment, [&](const Spot& spot, std::int64_t) -> std::int64_t {
        const ElementKind kind = spot.phase->kind;
        if (kind == ElementKind::Layers || kind == ElementKind::Samples) return 0;
        const bool vertex = kind == ElementKind::Vertex || kind == ElementKind::VertexTerms;
        const bool here = thing == Thing::Object    ? objectOf(spot) == number
                          : thing == Thing::Polygon ? polygonOf(spot) == number
                                                    : vertex && spot.phase->number(spot.element) == number;
        return here ? spot.phase->end(spot.element) - spot.phase->begin(spot.element) : 0;
    });
}

}  // namespace pipeline
