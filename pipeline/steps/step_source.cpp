#include "pipeline/steps/step_source.h"

#include <algorithm>
#include <mutex>

#include "pipeline/run/runner.h"
#include "pipeline/steps/bindings.h"
#include "pipeline/steps/stage_states.h"

namespace pipeline {
namespace {

// For each polygon: the number of pixels and rows in which it is visible, and the first and last row.
struct Seen {
    std::vector<std::int64_t> pixels, rows;
    std::vector<int> first, last;
};
template <class Real>
Seen countSeen(const FrameData<Real>& data) {
    const Topology& topology = *data.transform->topology;
    const Buffer2D<std::uint32_t>& triangles = *data.zBuffer->triangle;
    const std::size_t count = topology.polygonCount();
    Seen seen{std::vector<std::int64_t>(count), std::vector<std::int64_t>(count), std::vector<int>(count, -1),
              std::vector<int>(count, -1)};
    for (std::size_t i = 0; i < triangles.pixels.size(); ++i) {
        if (triangles.pixels[i] == kNoTriangle) continue;
        const std::uint32_t polygon = topology.polygonOf(triangles.pixels[i]);
        const int y = int(i / std::size_t(triangles.size.x));
        ++seen.pixels[polygon];
        seen.rows[polygon] += seen.last[polygon] != y;
        if (seen.first[polygon] < 0) seen.first[polygon] = y;
        seen.last[polygon] = y;
    }
    return seen;
}

template <class Real>
class Source : public StepSource {
public:
    explicit Source(FramePtr whole) : m_frame(std::move(whole)), m_data(*dataOf<Real>(*m_frame)) {
        m_data.keys.shading.parts.whole.set(Part::ShadedInVectors, false);  // single pixels are shaded exactly
        const Topology& topology = *m_data.transform->topology;
        for (const StageId stage : kStages) runs[index(stage)] = m_data.has(stage);
        using enum ElementKind;
        add(StageId::Transform, {.kind = Vertex, .count = topology.vertexCount()});
        if (m_data.cull) add(StageId::Cull, {.kind = Polygon, .count = topology.polygonCount()});
        if (m_data.normals) {
            add(StageId::Normals, {.kind = Polygon, .count = m_data.normals->polygon.size()});
            add(StageId::Normals, {.kind = Vertex, .count = m_data.normals->vertex.size()});
        }
        addLights();
        if (m_data.zBuffer) addDrawing();
        if (m_data.shading) addShading();
    }

    std::vector<PixelSpan> spans(StageId stage, std::size_t element) const override {
        if (stage == StageId::ZBuffer) return spansOf(m_drawing, element);
        const Buffer2D<std::uint32_t>& seen = *m_data.zBuffer->triangle;
        const std::uint32_t polygon = m_pixelPhase->number(element);
        std::vector<PixelSpan> spans;
        for (int y = m_seen.first[polygon]; y <= m_seen.last[polygon]; ++y)
            for (int x = 0; x < seen.size.x; ++x) {
                const std::uint32_t triangle = seen.at({x, y});
                if (triangle == kNoTriangle || m_data.transform->topology->polygonOf(triangle) != polygon) continue;
                if (!spans.empty() && spans.back().y == y && spans.back().last + 1 == x)
                    ++spans.back().last;
                else
                    spans.push_back({y, x, x});
            }
        return spans;
    }

    void bind(StageId stage, const StepPhase& phase, std::size_t element, std::int64_t within,
              Bindings& out) const override {
        const BoundStep step{&phase, element, within};
        if (stage == StageId::ZBuffer)
            bindDrawing(m_data, m_drawing, step, out);
        else if (stage == StageId::Shading)
            bindShading(*m_frame, m_data, phase.rows.empty() ? std::vector<PixelSpan>() : spans(stage, element), step,
                        out);
        else
            bindGeometry(*m_frame, m_data, stage, step, out);
    }

    FramePtr at(Moment moment, int count, Stop stop) const override {
        Threads threads(count, stop);
        auto stages = std::make_shared<FrameStages>();
        FrameData<Real>& out = stages->data.template emplace<FrameData<Real>>(m_data);
        using enum StageId;
        // In reverse: each case drops the output of its stage and of all later ones.
        if (moment.stage <= ZBuffer) out.shading.reset();
        if (moment.stage <= StageId::ShadowBuffer) out.zBuffer.reset();
        if (moment.stage <= Normals) out.shadowBuffer.reset();
        if (moment.stage <= Cull) out.normals.reset();
        if (moment.stage <= Transform) out.cull.reset();
        setStage(moment, out, threads);
        if (threads.stopped()) return nullptr;
        return unfinishedFrame(*m_frame, std::move(stages), moment.stage);
    }

private:
    void add(StageId stage, StepPhase phase) {
        if (phase.count == 0) return;
        std::vector<StepPhase>& all = phases[index(stage)];
        phase.first = all.empty() ? 0 : all.back().first + all.back().total();
        all.push_back(std::move(phase));
    }

    // The picture under layers or samples is shaded again pixel by pixel, with the weights that the SIMD kernels leave
    // out.
    void completeZBuffer() {
        const ShadingInputs& inputs = m_data.keys.shading;
        if (!m_data.shading || !m_data.zBuffer->barycentric.empty()) return;
        if (!inputs.layers.drawn && inputs.samples == 1) return;
        Threads threads(0, {});
        m_data.zBuffer = std::make_shared<ZBufferOutput<Real>>(
            drawnSoFar(m_data, m_drawing, m_drawing.ranges.size(), Reach{}, threads));
    }

    void addLights() {
        if (!m_data.shadowBuffer) return;
        const Topology& topology = *m_data.transform->topology;
        const std::vector<std::uint8_t>& transparent = m_data.transform->transparent;
        std::vector<std::uint32_t> opaque;
        for (std::uint32_t polygon = 0; polygon < topology.polygonCount() && !transparent.empty(); ++polygon)
            if (!transparent[topology.objectOfPolygon(polygon)]) opaque.push_back(polygon);
        const std::size_t count = transparent.empty() ? topology.polygonCount() : opaque.size();
        for (std::size_t light = 0; light < m_data.shadowBuffer->lights.size(); ++light)
            if (!m_data.shadowBuffer->lights[light].empty())
                add(StageId::ShadowBuffer, {.light = int(light), .count = count, .numbers = opaque});
    }

    void addDrawing() {
        m_drawing = takeApart(m_data);
        completeZBuffer();
        const bool painted = m_data.keys.zBuffer.visibility == Visibility::Painter;
        StepPhase phase{.kind = painted ? ElementKind::Piece : ElementKind::Polygon,
                        .count = m_drawing.ranges.size(),
                        .ends = m_drawing.pixels,
                        .rows = m_drawing.rows};
        (painted ? phase.polygons : phase.numbers) = m_drawing.polygons;
        add(StageId::ZBuffer, std::move(phase));
    }

    void addShading() {
        const ShadingInputs& inputs = m_data.keys.shading;
        const ShadingOutput<Real>& shading = *m_data.shading;
        const auto addTerms = [&](ElementKind kind, const typename ShadingOutput<Real>::Elements& elements) {
            StepPhase terms{.kind = kind};
            for (std::uint32_t i = 0; i < elements.count(); ++i)
                if (elements.isEvaluated(i)) terms.numbers.push_back(i);
            terms.count = terms.numbers.size();
            add(StageId::Shading, std::move(terms));
        };
        addTerms(ElementKind::PolygonTerms, shading.polygons);
        addTerms(ElementKind::VertexTerms, shading.vertices);

        m_seen = countSeen(m_data);
        StepPhase pixels{.kind = ElementKind::Polygon};
        std::int64_t end = 0, rows = 0;
        for (std::uint32_t polygon = 0; polygon < m_seen.pixels.size(); ++polygon) {
            if (m_seen.pixels[polygon] == 0) continue;
            pixels.numbers.push_back(polygon);
            pixels.ends.push_back(end += m_seen.pixels[polygon]);
            pixels.rows.push_back(rows += m_seen.rows[polygon]);
        }
        pixels.count = pixels.numbers.size();
        add(StageId::Shading, std::move(pixels));
        if (inputs.layers.drawn) add(StageId::Shading, {.kind = ElementKind::Layers, .count = 1});
        if (inputs.samples > 1) add(StageId::Shading, {.kind = ElementKind::Samples, .count = 1});
        for (const StepPhase& phase : phases[index(StageId::Shading)])
            if (phase.kind == ElementKind::Polygon) m_pixelPhase = &phase;
    }

    // The number of elements of a phase that are over after `done` smallest steps of the stage, and the steps done in
    // the next one.
    struct Over {
        std::size_t elements = 0;
        std::int64_t rest = 0;
    };
    static Over over(const StepPhase& phase, std::int64_t done) {
        const std::int64_t within = std::clamp<std::int64_t>(done - phase.first, 0, phase.total());
        if (phase.ends.empty()) return {std::size_t(within), 0};
        const auto elements = std::size_t(std::ranges::upper_bound(phase.ends, within) - phase.ends.begin());
        return {elements, within - (elements == 0 ? 0 : phase.ends[elements - 1])};
    }

    void setStage(Moment moment, FrameData<Real>& out, Threads& threads) const {
        const std::vector<StepPhase>& all = phases[index(moment.stage)];
        switch (moment.stage) {
            case StageId::Transform:
                out.transform =
                    std::make_shared<TransformOutput<Real>>(transformSoFar(m_data, std::size_t(moment.done)));
                return;
            case StageId::Cull:
                out.cull = std::make_shared<CullOutput>(cullSoFar(m_data, std::size_t(moment.done), threads));
                return;
            case StageId::Normals: {
                std::size_t polygons = 0, vertices = 0;
                for (const StepPhase& phase : all)
                    (phase.kind == ElementKind::Polygon ? polygons : vertices) = over(phase, moment.done).elements;
                out.normals = std::make_shared<NormalsOutput<Real>>(normalsSoFar(m_data, polygons, vertices, threads));
                return;
            }
            case StageId::ShadowBuffer: {
                const StepPhase* now = nullptr;
                for (const StepPhase& phase : all)
                    if (!now || moment.done > phase.first) now = &phase;
                out.shadowBuffer = std::make_shared<ShadowBufferOutput<Real>>(shadowBuffersSoFar(
                    m_data, now ? std::size_t(now->light) : 0, now ? over(*now, moment.done).elements : 0, threads));
                return;
            }
            case StageId::ZBuffer: {
                Over made;
                for (const StepPhase& phase : all) made = over(phase, moment.done);
                const Reach reach =
                    made.rest > 0 ? reachOf(spans(StageId::ZBuffer, made.elements), made.rest) : Reach{};
                out.zBuffer =
                    std::make_shared<ZBufferOutput<Real>>(drawnSoFar(m_data, m_drawing, made.elements, reach, threads));
                return;
            }
            case StageId::Shading: {
                const ShadingProgress progress = shadingProgress(all, moment.done);
                std::call_once(m_once, [&] {
                    Threads unstopped(0, {});
                    m_opaque = shadedOpaque(m_data, m_frame->made(), unstopped);
                });
                out.shading = std::make_shared<ShadingOutput<Real>>(
                    shadedSoFar(m_data, *m_opaque, m_frame->made(), progress, threads));
                return;
            }
        }
    }

    ShadingProgress shadingProgress(const std::vector<StepPhase>& all, std::int64_t done) const {
        ShadingProgress progress;
        for (const StepPhase& phase : all) {
            const Over made = over(phase, done);
            const std::size_t next = made.elements == 0 ? 0 : phase.number(made.elements - 1) + 1;
            switch (phase.kind) {
                case ElementKind::PolygonTerms: progress.polygonTerms = next; break;
                case ElementKind::VertexTerms: progress.vertexTerms = next; break;
                case ElementKind::Layers: progress.layers = made.elements > 0; break;
                case ElementKind::Samples: progress.samples = made.elements > 0; break;
                default:
                    progress.polygon = made.elements < phase.count ? phase.number(made.elements) : ~0u;
                    if (made.rest > 0) progress.reach = reachOf(spans(StageId::Shading, made.elements), made.rest);
            }
        }
        return progress;
    }

    FramePtr m_frame;
    FrameData<Real> m_data;
    Drawing<Real> m_drawing;
    Seen m_seen;
    const StepPhase* m_pixelPhase = nullptr;
    mutable std::once_flag m_once;
    mutable std::shared_ptr<const ShadingOutput<Real>> m_opaque;
};

}  // namespace

Reach reachOf(const std::vector<PixelSpan>& spans, std::int64_t done) {
    for (const PixelSpan& span : spans) {
        if (done <= span.length()) return {span.y, span.first + int(done)};
        done -= span.length();
    }
    return {spans.empty() ? 0 : spans.back().y + 1, 0};
}

std::shared_ptr<const StepSource> makeStepSource(FramePtr whole) {
    const auto& frame = *whole;
    return readStages(frame, [&]<class Real>(const FrameData<Real>&) -> std::shared_ptr<const StepSource> {
        return std::make_shared<Source<Real>>(std::move(whole));
    });
}

}  // namespace pipeline
