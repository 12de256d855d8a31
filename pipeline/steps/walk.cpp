// The way of a step through the lines of its algorithm.
#include <algorithm>

#include "pipeline/steps/bindings.h"

namespace pipeline {
namespace {

class Walker {
public:
    Walker(Walk& walk, const Bindings& step) : m_walk(walk), m_scopes{&step} {}

    // Goes through the lines [begin, end).
    void go(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end;) {
            const Algorithm::Line& line = m_walk.algorithm.lines[i];
            std::size_t inner = i + 1;
            while (inner < end && m_walk.algorithm.lines[inner].indent > line.indent) ++inner;
            if (line.runs()) pass(i, inner);
            i = inner;
        }
    }

private:
    void pass(std::size_t i, std::size_t end) {
        const AlgorithmLine& row = *m_walk.algorithm.lines[i].row;
        if (!row.where.empty() && !isTrue(row.where)) return;
        if (row.kind == LineKind::Loop && !row.of.empty()) {
            const auto turns = m_scopes.front()->loops.find(row.of);
            if (turns == m_scopes.front()->loops.end()) return;
            for (const Bindings& turn : turns->second) {
                m_scopes.push_back(&turn);
                visit(i, m_walk.visits);
                go(i + 1, end);
                m_scopes.pop_back();
            }
            return;
        }
        visit(i, m_scopes.front()->begins[std::size_t(row.begins)] ? m_walk.visits : m_walk.around);
        if (row.kind != LineKind::If || isTrue(row.of)) go(i + 1, end);
    }

    bool isTrue(std::string_view test) const {
        for (auto scope = m_scopes.rbegin(); scope != m_scopes.rend(); ++scope)
            if (const auto found = (*scope)->tests.find(test); found != (*scope)->tests.end()) return found->second;
        return false;
    }

    void visit(std::size_t i, std::vector<Visit>& passed) {
        const AlgorithmLine& row = *m_walk.algorithm.lines[i].row;
        Visit visit{i, {}, {}};
        if (row.kind == LineKind::If) visit.taken = isTrue(row.of);
        std::string_view text = row.text;
        for (std::size_t open; (open = text.find('{')) != std::string_view::npos;) {
            const std::size_t close = text.find('}');
            add(text.substr(open + 1, close - open - 1), visit);
            text.remove_prefix(close + 1);
        }
        passed.push_back(std::move(visit));
    }

    void add(std::string_view name, Visit& visit) const {
        for (auto scope = m_scopes.rbegin(); scope != m_scopes.rend(); ++scope) {
            const auto value = std::ranges::find((*scope)->values, name, &AlgorithmValue::name);
            if (value == (*scope)->values.end()) continue;
            return visit.values.push_back(*value);
        }
    }

    Walk& m_walk;
    std::vector<const Bindings*> m_scopes;  // those of the step, then those of the current loop's turn
};

}  // namespace

glm::ivec2 bindPixel(const std::vector<PixelSpan>& spans, std::int64_t within, Bindings& out) {
    std::int64_t before = 0;
    int row = -1, first = 0;
    for (const PixelSpan& span : spans) {
        if (span.y != row) row = span.y, first = span.first;
        if (within - before >= span.length()) {
            before += span.length();
            continue;
        }
        const glm::ivec2 pixel(span.first + int(within - before), span.y);
        int last = span.last;  // of the row, in which the element may have gaps
        for (const PixelSpan& other : spans)
            if (other.y == row) last = std::max(last, other.last);
        AlgorithmValue value{"x, y", "x, y", fmt::format("{}, {}", pixel.x, pixel.y), {}, {}};
        value.numbers = {double(pixel.x), double(pixel.y)};
        value.range = {fmt::format("x in row {}", pixel.y), first, last, pixel.x};
        out.values.push_back(std::move(value));
        out.begins[std::size_t(Begins::Row)] = pixel.x == first;
        return pixel;
    }
    return {-1, -1};
}

void bindElement(const BoundStep& step, std::string name, Bindings& out) {
    out.begins[std::size_t(Begins::Element)] = step.within == 0;
    out.begins[std::size_t(Begins::Phase)] = step.within == 0 && step.element == 0;
    AlgorithmValue& value =
        out.whole(name, step.number(), fmt::format("number {} of {}", step.element + 1, step.phase->count));
    // As the code counts: from its first element's number to the last one's.
    value.range = {std::move(name), step.phase->number(0), step.phase->number(step.phase->count - 1), step.number()};
}

Walk walkThrough(Algorithm algorithm, const Bindings& bindings) {
    Walk walk{std::move(algorithm), {}, {}};
    const std::size_t lines = walk.algorithm.lines.size();
    Walker(walk, bindings).go(0, lines);
    return walk;
}

}  // namespace pipeline
