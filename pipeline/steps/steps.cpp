#include "pipeline/steps/steps.h"

#include <algorithm>

#include "pipeline/scene/mesh/topology.h"
#include "pipeline/steps/step_source.h"

namespace pipeline {

Steps::Steps(FramePtr whole) : m_frame(std::move(whole)), m_source(makeStepSource(m_frame)) {}

const std::vector<StepPhase>& Steps::phases(StageId stage) const { return m_source->phases[index(stage)]; }

bool Steps::runs(StageId stage) const { return m_source->runs[index(stage)]; }

std::int64_t Steps::total(StageId stage) const {
    const std::vector<StepPhase>& all = phases(stage);
    return all.empty() ? 0 : all.back().first + all.back().total();
}

Moment Steps::fitting(Moment moment) const {
    if (runs(moment.stage)) {
        const Moment within{moment.stage, std::clamp<std::int64_t>(moment.done, 0, total(moment.stage)), moment.line};
        if (moment.line == 0 || within.done != moment.done || moment.done == total(moment.stage))
            return {within.stage, within.done};
        return {within.stage, within.done, std::clamp(moment.line, 0, lineCount(within.stage, within.done))};
    }
    std::size_t stage = index(moment.stage);
    while (stage > 0 && !m_source->runs[stage]) --stage;
    return {kStages[stage], total(kStages[stage])};
}

Steps::Spot Steps::at(StageId stage, std::int64_t tick) const {
    const std::vector<StepPhase>& all = phases(stage);
    const auto phase = std::ranges::upper_bound(all, tick, {}, &StepPhase::first) - 1;
    const std::int64_t within = tick - phase->first;
    if (phase->ends.empty()) return {stage, &*phase, std::size_t(within)};
    return {stage, &*phase, std::size_t(std::ranges::upper_bound(phase->ends, within) - phase->ends.begin())};
}

std::optional<std::uint32_t> Steps::polygonOf(const Spot& spot) const {
    switch (spot.phase->kind) {
        case ElementKind::Polygon:
        case ElementKind::PolygonTerms: return spot.phase->number(spot.element);
        case ElementKind::Piece: return spot.phase->polygons[spot.element];
        default: return std::nullopt;
    }
}

std::uint32_t Steps::objectOf(const Spot& spot) const {
    const Topology& topology = m_frame->topology();
    if (const auto polygon = polygonOf(spot)) return topology.objectOfPolygon(*polygon);
    if (spot.phase->kind == ElementKind::Vertex || spot.phase->kind == ElementKind::VertexTerms)
        return std::uint32_t(topology.objectOfVertex(spot.phase->number(spot.element)));
    return 0;
}

// The element's smallest steps up to the end of each of its rows.
std::vector<std::int64_t> Steps::rowEnds(const Spot& spot) const {
    std::vector<std::int64_t> ends;
    std::int64_t end = 0;
    int row = -1;
    for (const PixelSpan& span : m_source->spans(spot.stage, spot.element)) {
        end += span.length();
        if (span.y == row)
            ends.back() = end;
        else
            ends.push_back(end);
        row = span.y;
    }
    return ends;
}

// The end of the step of this level that contains step number `tick`.
std::int64_t Steps::end(StageId stage, std::int64_t tick, StepLevel level) const {
    if (level == StepLevel::Stage) return total(stage);
    Spot spot = at(stage, tick);
    const StepPhase& phase = *spot.phase;
    if (level == StepLevel::Object) {
        const std::uint32_t object = objectOf(spot);
        while (spot.element + 1 < phase.count && objectOf({stage, &phase, spot.element + 1}) == object) ++spot.element;
    }
    const bool rows = !phase.rows.empty();
    if (level >= StepLevel::Pixel && rows) return tick + 1;
    if (level == StepLevel::Scanline && rows) {
        const std::int64_t first = phase.first + phase.begin(spot.element);
        const std::vector<std::int64_t> ends = rowEnds(spot);
        return first + *std::ranges::upper_bound(ends, tick - first);
    }
    return phase.first + phase.end(spot.element);
}

// The beginning of that step.
std::int64_t Steps::begin(StageId stage, std::int64_t tick, StepLevel level) const {
    if (level == StepLevel::Stage) return 0;
    Spot spot = at(stage, tick);
    const StepPhase& phase = *spot.phase;
    if (level == StepLevel::Object) {
        const std::uint32_t object = objectOf(spot);
        while (spot.element > 0 && objectOf({stage, &phase, spot.element - 1}) == object) --spot.element;
    }
    const bool rows = !phase.rows.empty();
    const std::int64_t first = phase.first + phase.begin(spot.element);
    if (level >= StepLevel::Pixel && rows) return tick;
    if (level == StepLevel::Scanline && rows) {
        const std::vector<std::int64_t> ends = rowEnds(spot);
        const auto row = std::ranges::upper_bound(ends, tick - first);
        return row == ends.begin() ? first : first + *(row - 1);
    }
    return first;
}

std::optional<Moment> Steps::next(Moment moment, StepLevel level) const {
    moment = fitting(moment);
    if (level == StepLevel::Line) return nextLine(moment);
    if (moment.done < total(moment.stage)) return Moment{moment.stage, end(moment.stage, moment.done, level)};
    for (std::size_t stage = index(moment.stage) + 1; stage < kStageCount; ++stage) {
        if (!m_source->runs[stage]) continue;
        const StageId id = kStages[stage];
        return Moment{id, total(id) == 0 ? 0 : end(id, 0, level)};
    }
    return std::nullopt;
}

std::optional<Moment> Steps::previous(Moment moment, StepLevel level) const {
    moment = fitting(moment);
    if (level == StepLevel::Line) return previousLine(moment);
    if (moment.step() >= 0) {
        const std::int64_t before = begin(moment.stage, moment.step(), level);
        if (before > 0) return Moment{moment.stage, before};
    }
    for (std::size_t stage = index(moment.stage); stage-- > 0;)
        if (m_source->runs[stage]) return Moment{kStages[stage], total(kStages[stage])};
    return moment == first() ? std::nullopt : std::optional(first());
}

std::int64_t Steps::count(StageId stage, StepLevel level) const {
    return runs(stage) ? made({stage, total(stage)}, level) : 0;
}

std::int64_t Steps::made(Moment moment, StepLevel level) const {
    const std::int64_t done = moment.done;
    if (level == StepLevel::Stage) return done == total(moment.stage);
    if (done == 0) return 0;
    std::int64_t steps = 0;
    for (const StepPhase& phase : phases(moment.stage)) {
        if (done <= phase.first) break;
        const Spot last = at(moment.stage, std::min(done, phase.first + phase.total()) - 1);
        const std::int64_t first = phase.first + phase.begin(last.element);
        const bool over = done >= phase.first + phase.end(last.element);
        if (level == StepLevel::Object) {
            for (std::size_t i = 0; i + 1 < phase.count && i <= last.element; ++i)
                steps += (i < last.element || over) &&
                         objectOf({moment.stage, &phase, i}) != objectOf({moment.stage, &phase, i + 1});
            steps += over && last.element + 1 == phase.count;
        } else if (phase.rows.empty() || level == StepLevel::Polygon) {
            steps += std::int64_t(last.element) + over;
        } else if (level >= StepLevel::Pixel) {
            steps += std::min(done - phase.first, phase.total());
        } else {
            steps += last.element == 0 ? 0 : phase.rows[last.element - 1];
            for (const std::int64_t row : rowEnds(last)) steps += first + row <= done;
        }
    }
    return steps;
}

std::vector<std::int64_t> Steps::ends(StageId stage, StepLevel level, std::int64_t atMost) const {
    std::vector<std::int64_t> all;
    const std::int64_t last = total(stage);
    if (!runs(stage) || last == 0 || count(stage, level) > atMost) return all;
    if (level != StepLevel::Scanline) {
        for (std::int64_t tick = 0; tick < last; tick = all.back()) all.push_back(end(stage, tick, level));
        return all;
    }
    // Finding the rows of an element means going through its pixels, so all rows are found at once.
    for (const StepPhase& phase : phases(stage)) {
        for (std::size_t i = 0; i < phase.count; ++i) {
            const std::int64_t first = phase.first + phase.begin(i);
            if (phase.rows.empty())
                all.push_back(phase.first + phase.end(i));
            else
                for (const std::int64_t row : rowEnds({stage, &phase, i})) all.push_back(first + row);
        }
    }
    return all;
}

Place Steps::placeOf(Moment moment) const {
    moment = fitting(moment);
    if (moment.line > 0) {
        Place place = placeOfStep(moment.stage, moment.done);
        const auto numbers = walk(moment.stage, moment.done)->numbersOf(std::size_t(moment.line) - 1);
        place.line = numbers[0], place.time = numbers[1];
        return place;
    }
    Place place;
    place.stage = moment.stage;
    if (moment.done == total(moment.stage)) return place;
    place.what = Place::What::Start;
    if (moment.done == 0) return place;
    const Spot spot = at(moment.stage, moment.done - 1);
    const StepPhase& phase = *spot.phase;
    place.what = Place::What::Element;
    place.light = phase.light;
    place.kind = phase.kind;
    place.number = phase.number(spot.element);
    const std::int64_t done = moment.done - phase.first - phase.begin(spot.element);
    if (phase.rows.empty() || moment.done == phase.first + phase.end(spot.element)) return place;
    const std::vector<PixelSpan> spans = m_source->spans(moment.stage, spot.element);
    const Reach reach = reachOf(spans, done);
    place.row = reach.row;
    if (!std::ranges::binary_search(rowEnds(spot), done)) place.x = reach.x - 1;
    return place;
}

Moment Steps::momentOf(const Place& place) const { return findLine(place).moment; }

bool Steps::comesTo(const Place& place) const { return findLine(place).isThere; }

Steps::Found Steps::find(const Place& place) const {
    const StageId stage = place.stage;
    const Moment end = fitting({stage, total(stage)});
    if (end.stage != stage || place.what == Place::What::End) return {end, end.stage == stage};
    if (place.what == Place::What::Start) return {{stage, 0}, true};
    const bool object = place.what == Place::What::Object;
    const StepPhase* found = nullptr;
    for (const StepPhase& phase : phases(stage)) {
        const bool sameLight = place.light < 0 ? !found || phase.light < 0 : phase.light == place.light;
        const bool painted = phase.kind == ElementKind::Piece && place.kind == ElementKind::Polygon;
        if (sameLight && (object ? phase.kind != ElementKind::Layers && phase.kind != ElementKind::Samples
                                 : phase.kind == place.kind || painted))
            found = &phase;
    }
    if (!found) return {end, false};
    const auto numberOf = [&](std::size_t i) {
        const Spot spot{stage, found, i};
        if (object) return std::int64_t(objectOf(spot));
        return std::int64_t(found->kind == place.kind ? found->number(i) : *polygonOf(spot));
    };
    // The painter visits polygons and objects in no order, so this is the last time that it is at this one.
    const bool ordered = found->kind != ElementKind::Piece || place.kind == ElementKind::Piece;
    std::size_t after = found->count;
    if (ordered) {
        for (std::size_t low = 0; low < after;) {
            const std::size_t middle = low + (after - low) / 2;
            numberOf(middle) > place.number ? after = middle : low = middle + 1;
        }
    } else {
        while (after > 0 && numberOf(after - 1) != place.number) --after;
    }
    if (after == 0) return {{stage, found->first}, false};
    const std::size_t element = after - 1;
    const bool isThis = numberOf(element) == place.number;
    if (object || !place.row || found->rows.empty() || !isThis)
        return {{stage, found->first + found->end(element)}, isThis && !place.row};
    std::int64_t pixels = 0;
    bool isThere = false;
    for (const PixelSpan& span : m_source->spans(stage, element)) {
        isThere = isThere || (span.y == *place.row && (!place.x || (span.first <= *place.x && *place.x <= span.last)));
        if (span.y < *place.row || (span.y == *place.row && (!place.x || span.last <= *place.x)))
            pixels += span.length();
        else if (span.y == *place.row)
            pixels += std::max(0, *place.x - span.first + 1);
    }
    return {{stage, found->first + found->begin(element) + pixels}, isThere};
}

std::optional<glm::ivec2> Steps::pixelOf(Moment moment) const {
    moment = fitting(moment);
    if (moment.step() < 0) return std::nullopt;
    const Spot spot = at(moment.stage, moment.step());
    if (spot.phase->rows.empty()) return std::nullopt;
    const Reach reach = reachOf(m_source->spans(moment.stage, spot.element),
                                moment.step() + 1 - spot.phase->first - spot.phase->begin(spot.element));
    return glm::ivec2(reach.x - 1, reach.row);
}

std::vector<glm::ivec2> Steps::pixelsToCome(Moment moment) const {
    moment = fitting(moment);
    if (moment.done == total(moment.stage)) return {};
    const Spot spot = at(moment.stage, moment.done);
    if (spot.phase->rows.empty()) return {};
    std::int64_t over = moment.done - spot.phase->first - spot.phase->begin(spot.element);
    std::vector<glm::ivec2> pixels;
    for (const PixelSpan& span : m_source->spans(moment.stage, spot.element)) {
        const int past = int(std::min<std::int64_t>(over, span.length()));
        for (int x = span.first + past; x <= span.last; ++x) pixels.emplace_back(x, span.y);
        over -= past;
    }
    return pixels;
}

std::optional<std::uint32_t> Steps::polygonOf(Moment moment) const {
    moment = fitting(moment);
    if (moment.step() < 0) return std::nullopt;
    return polygonOf(at(moment.stage, moment.step()));
}

FramePtr Steps::frameAt(Moment moment, int threads, Stop stop) const {
    return m_source->at(fitting(moment), threads, std::move(stop));
}

}  // namespace pipeline
