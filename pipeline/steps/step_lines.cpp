// Stepping through the lines of a stage's algorithm.
#include <algorithm>

#include "pipeline/steps/bindings.h"
#include "pipeline/steps/steps.h"

namespace pipeline {

std::shared_ptr<const Walk> Steps::walk(StageId stage, std::int64_t tick) const {
    const Moment step{stage, tick};
    const std::lock_guard lock(m_walkMutex);
    if (m_walk && m_walked == step) return m_walk;
    const Spot spot = at(stage, tick);
    auto algorithm = algorithmOf(*m_frame, stage, spot.phase->kind);
    Walk walk;
    if (algorithm) {
        Bindings bindings;
        m_source->bind(stage, *spot.phase, spot.element, tick - spot.phase->first - spot.phase->begin(spot.element),
                       bindings);
        walk = walkThrough(*std::move(algorithm), bindings);
    }
    m_walked = step;
    return m_walk = std::make_shared<const Walk>(std::move(walk));
}

int Steps::lineCount(StageId stage, std::int64_t tick) const { return int(walk(stage, tick)->visits.size()); }

// From the last line of a step to the step's end: the result of the line is visible before the next step begins.
std::optional<Moment> Steps::nextLine(Moment moment) const {
    if (moment.done < total(moment.stage)) {
        if (moment.line < lineCount(moment.stage, moment.done))
            return Moment{moment.stage, moment.done, moment.line + 1};
        return Moment{moment.stage, moment.done + 1};
    }
    auto next = this->next(moment, StepLevel::Pixel);
    if (next && next->done > 0) *next = {next->stage, 0, std::min(1, lineCount(next->stage, 0))};
    if (next && next->done == 0 && next->line == 0 && total(next->stage) > 0) next->done = 1;  // a stage without a text
    return next;
}

std::optional<Moment> Steps::previousLine(Moment moment) const {
    if (moment.line > 1) return Moment{moment.stage, moment.done, moment.line - 1};
    if (moment.line == 0 && moment.done > 0)
        if (const int lines = lineCount(moment.stage, moment.done - 1); lines > 0)
            return Moment{moment.stage, moment.done - 1, lines};
    return previous(moment, StepLevel::Pixel);
}

Place Steps::placeOfStep(StageId stage, std::int64_t tick) const {
    const Spot spot = at(stage, tick);
    Place place{stage, Place::What::Element, spot.phase->light, spot.phase->kind, spot.phase->number(spot.element)};
    if (const auto pixel = pixelOf({stage, tick + 1})) place.row = pixel->y, place.x = pixel->x;
    return place;
}

Steps::Found Steps::findLine(const Place& place) const {
    const Found after = find(place);
    if (!place.line || after.moment.stage != place.stage || after.moment.done == 0) return after;
    if (!after.isThere) return after;
    const std::int64_t tick = after.moment.done - 1;
    const std::shared_ptr<const Walk> walk = this->walk(place.stage, tick);
    const auto visit = walk->visitOf(*place.line, place.time);
    if (!visit) return {after.moment, false};
    return {{place.stage, tick, int(*visit) + 1}, walk->numbersOf(*visit) == std::array{*place.line, place.time}};
}

std::optional<AlgorithmState> Steps::algorithmAt(Moment moment) const {
    moment = fitting(moment);
    if (moment.step() >= 0) {
        AlgorithmState state{*walk(moment.stage, moment.step()), {}, moment.line == 0};
        if (!state.walk.algorithm.row) return std::nullopt;
        if (!state.walk.visits.empty())
            state.visit = moment.line > 0 ? std::size_t(moment.line) - 1 : state.walk.visits.size() - 1;
        return state;
    }
    const std::vector<StepPhase>& all = phases(moment.stage);
    auto algorithm = algorithmOf(*m_frame, moment.stage, all.empty() ? ElementKind::Polygon : all.front().kind);
    if (!algorithm) return std::nullopt;
    return AlgorithmState{{*std::move(algorithm), {}, {}}, {}, false};
}

std::vector<Algorithm> Steps::algorithms() const {
    std::vector<Algorithm> all;
    const auto add = [&](StageId stage, ElementKind kind) {
        auto algorithm = algorithmOf(*m_frame, stage, kind);
        if (algorithm && (all.empty() || all.back().row != algorithm->row)) all.push_back(*std::move(algorithm));
    };
    for (const StageId stage : kStages) {
        if (phases(stage).empty()) add(stage, ElementKind::Polygon);
        for (const StepPhase& phase : phases(stage)) add(stage, phase.kind);
    }
    return all;
}

std::optional<Moment> Steps::beginOf(const Algorithm& algorithm) const {
    for (const StepPhase& phase : phases(algorithm.row->stage)) {
        const auto own = algorithmOf(*m_frame, algorithm.row->stage, phase.kind);
        if (own && own->row == algorithm.row) return Moment{algorithm.row->stage, phase.first};
    }
    return std::nullopt;
}

}  // namespace pipeline
