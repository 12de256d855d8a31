// The values of a step of the shading stage, as the inspector reads them from the same frame.
#include <algorithm>

#include "pipeline/core/text.h"
#include "pipeline/inspect/shadow_events.h"
#include "pipeline/stages/translucent.h"
#include "pipeline/steps/bindings.h"

namespace pipeline {
namespace {

constexpr int kIntensityDigits = 3;

// One evaluation of the illumination model: its vectors, its ambient part, and a turn for each light.
template <class Real>
void bindEvaluation(const FrameData<Real>& data, const Evaluation& at, std::uint32_t object, bool back, Bindings& out) {
    const ShadingInputs& inputs = data.keys.shading;
    const Model model = inputs.illumination.model;
    const Material& material = materialOf(inputs, object, back);
    const bool halfway = usesHalfway(model, material);
    out.vector("N", at.N), out.vector("V", at.V);
    out.vector("emission", Vec3d(emissionTerm<Real>(model, material)), kIntensityDigits);
    out.vector("ambient", at.color * Vec3d(ambientTerm<Real>(model, inputs.ambient, material)), kIntensityDigits);
    for (const LightReport& light : at.lights) {
        Bindings& turn = out.loops["lights"].emplace_back();
        turn.whole("light", light.light, light.note);
        turn.number("F", light.fading, 4, "attenuation times spot");
        turn.vector("light's ambient", light.ambient, kIntensityDigits);
        turn.number("N·L", light.nDotL);
        const double lobe = halfway ? light.nDotH : light.rDotV;
        for (const char* name : {"R·V", "N·H", "R·V or N·H"}) turn.number(name, lobe);
        turn.number("S", light.shadow);
        turn.vector("diffuse", light.diffuse, kIntensityDigits);
        turn.vector("specular", light.specular, kIntensityDigits, at.clamped ? "shrunk: I was above 1" : "");
        turn.tests["lit"] = light.nDotL > 0;
        turn.tests["mirrored"] = light.nDotL > 0 && lobe > 0;
    }
}

// A turn for each light if there are none yet, with the comparison that decides its shadow.
template <class Real>
void bindShadows(const FrameData<Real>& data, const PixelReport& report, Bindings& out) {
    std::vector<Bindings>& lights = out.loops["lights"];
    const bool isNew = lights.empty();
    for (std::size_t k = 0; k < report.shadow.size(); ++k) {
        Bindings& turn = isNew ? lights.emplace_back() : lights[k];
        if (isNew) turn.whole("light", std::int64_t(k)), turn.number("S", report.shadow[k]);
        const auto found = shadowDepths(data, k, std::uint32_t(report.triangle), Vec3<Real>(report.position));
        turn.tests["looked up"] = found.has_value();
        if (!found) continue;
        turn.tests["in shadow"] = found->shadowed;
        AlgorithmValue& place =
            turn.word("x', y', z'", fmt::format("{}, {}, {}", found->texel.x, found->texel.y, depthText(found->z)));
        place.numbers = {double(found->texel.x), double(found->texel.y), found->z};
        turn.depth("z'", found->z);
        turn.depth("Z'[x'][y']", found->stored).shown = fmt::format("Z'[{}][{}]", found->texel.x, found->texel.y);
        turn.word("bias", fmt::format("{:.3g}", found->bias), "which the lecture leaves out").numbers = {found->bias};
    }
}

// I_a and I_b of lecture 1's double interpolation, or of normals: `value` interpolated along the two edges that the row
// crosses.
template <class Real, class Value>
void bindRow(const FrameData<Real>& data, const PixelReport& report, std::uint32_t triangle, const char* a,
             const char* b, Value value, Bindings& out) {
    RowCrossings row;
    const auto weights = vertexWeights<Real>(Interpolation::Scanline, *data.transform, triangle,
                                             Vec3<Real>(report.barycentric), report.pixel, row);
    out.tests["along the row"] = weights.used == Interpolation::Scanline;
    if (weights.used != Interpolation::Scanline) return;
    const double x = report.pixel.x + 0.5;
    std::size_t i = 0;
    while (i + 3 < row.crossings.size() && x > row.crossings[i + 1].x) i += 2;
    for (const char* name : {a, b}) {
        const RowCrossings::Crossing& edge = row.crossings[i++];
        const Vec3d from = value(edge.from);
        out.vector(name, from + (value(edge.to) - from) * edge.along, kIntensityDigits,
                   fmt::format("between vertices {} and {}", edge.from, edge.to));
    }
}

void bindFrameBuffer(Vec3d intensity, double iMax, const Planted& planted, Bindings& out) {
    const Color8 value = frameBufferValue(intensity, iMax, planted);
    out.word("FB", fmt::format("{}, {}, {}", int(value.r), int(value.g), int(value.b)),
             fmt::format("Imax = {}", shortest(iMax)))
        .numbers = {double(value.r), double(value.g), double(value.b)};
}

template <class Real>
void bindPixelShading(const Frame& frame, const FrameData<Real>& data, glm::ivec2 pixel, Bindings& out) {
    const PixelReport report = inspectShading(frame, pixel);
    bindFrameBuffer(report.intensity, report.iMax, data.keys.shading.planted, out);
    out.vector("intensity", report.intensity, kIntensityDigits);
    if (report.outline) return;
    const std::uint32_t triangle = data.zBuffer->triangle->at(pixel);
    Vec3d whole(0);  // without shadows, as it was evaluated
    std::vector<std::string> weights, vertices;
    for (const auto& [vertex, weight] : report.weights)
        weights.push_back(fixed(weight, 4)), vertices.push_back(std::to_string(vertex));
    out.word("λ", fmt::format("{}", fmt::join(weights, ", ")), report.interpolation);
    out.word("vertices", fmt::format("{}", fmt::join(vertices, ", ")));
    const auto unshadowed = [](const Evaluation& e) {
        Vec3d sum = e.emission + e.ambient;
        for (const LightReport& light : e.lights) sum += light.unshadowedDiffuse + light.unshadowedSpecular;
        return sum;
    };
    const Shading shading = data.keys.shading.shading;
    if (shading == Shading::Phong) {
        bindEvaluation(data, report.evaluations[0], std::uint32_t(report.object), report.back, out);
        bindRow(
            data, report, triangle, "Na", "Nb", [&](std::uint32_t v) { return Vec3d(data.normals->vertex[v]); }, out);
    } else {
        for (const Evaluation& e : report.evaluations) whole += e.weight * unshadowed(e);
        out.vector("I", whole, kIntensityDigits, "without shadows");
        bindRow(
            data, report, triangle, "Ia", "Ib",
            [&](std::uint32_t v) {
                const auto& lit = report.back && !data.shading->verticesBack.intensity.empty()
                                      ? data.shading->verticesBack
                                      : data.shading->vertices;
                return lit.count() > 0 ? Vec3d(lit.intensity[lit.placeOf(v)]) : Vec3d(0);
            },
            out);
    }
    bindShadows(data, report, out);
}

// The first pixel with the most layers, and its layers.
template <class Real>
std::optional<glm::ivec2> mostLayers(const FrameData<Real>& data) {
    const ShadingInputs& inputs = data.keys.shading;
    const ShadingSources<Real> in = data.shadingSources();
    const LayerBins<Real> bins = binLayers(inputs, in);
    std::optional<glm::ivec2> best;
    std::size_t most = 0;
    for (std::size_t tile = 0; tile < bins.order.size(); ++tile) {
        const auto layers =
            layersIn<Real>(inputs, in, bins, bins.order[tile], tileOf(in.transform.view.size, tile), kLayersAtOnce);
        if (!layers) continue;
        for (std::size_t i = 0; i < layers->size();) {
            std::size_t end = i;
            while (end < layers->size() && (*layers)[end].pixel == (*layers)[i].pixel) ++end;
            if (end - i > most) most = end - i, best = (*layers)[i].pixel;
            i = end;
        }
    }
    return best;
}

template <class Real>
void bindLayers(const Frame& frame, const FrameData<Real>& data, Bindings& out) {
    const glm::ivec2 pixel = mostLayers(data).value_or(glm::ivec2(0));
    const PixelReport report = inspectShading(frame, pixel);
    out.word("x, y", fmt::format("{}, {}", pixel.x, pixel.y)).numbers = {double(pixel.x), double(pixel.y)};
    out.vector("opaque", report.intensity, kIntensityDigits);
    out.word("layers", plural(std::int64_t(report.layers.size()), "layer"));
    for (const LayerReport& layer : report.layers) {
        Bindings& turn = out.loops["layers"].emplace_back();
        turn.whole("polygon", layer.polygon, "z = " + depthText(layer.zView));
        turn.number("α", layer.alpha);
        turn.vector("I", layer.intensity, kIntensityDigits);
        turn.vector("C", layer.composed, kIntensityDigits);
    }
    bindFrameBuffer(report.layers.empty() ? report.intensity : report.layers.back().composed, report.iMax,
                    data.keys.shading.planted, out);
}

template <class Real>
void bindTerms(const Frame& frame, const FrameData<Real>& data, const BoundStep& step, Bindings& out) {
    const Topology& topology = *data.transform->topology;
    const bool isVertex = step.phase->kind == ElementKind::VertexTerms;
    bindElement(step, isVertex ? "vertex" : "polygon", out);
    const auto object =
        std::uint32_t(isVertex ? topology.objectOfVertex(step.number()) : topology.objectOfPolygon(step.number()));
    const Evaluation at = isVertex ? inspectVertex(frame, step.number()) : inspectPolygon(frame, step.number());
    out.whole("object", object);
    bindEvaluation(data, at, object, !isVertex && showsBack(data.keys.shading, data.shadingSources(), step.number()),
                   out);
    out.vector("intensity", at.intensity, kIntensityDigits, "with S = 1");
}

}  // namespace

template <class Real>
void bindShading(const Frame& frame, const FrameData<Real>& data, const std::vector<PixelSpan>& spans,
                 const BoundStep& step, Bindings& out) {
    switch (step.phase->kind) {
        case ElementKind::PolygonTerms:
        case ElementKind::VertexTerms: return bindTerms(frame, data, step, out);
        case ElementKind::Layers: return bindLayers(frame, data, out);
        case ElementKind::Samples: {
            const int side = data.keys.shading.samples;
            out.word("samples", plural(std::int64_t(side) * side, "sample"));
            return;
        }
        default: bindElement(step, "polygon", out);
    }
    bindPixelShading(frame, data, bindPixel(spans, step.within, out), out);
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                 \
    template void bindShading(const Frame&, const FrameData<Real>&, const std::vector<PixelSpan>&, const BoundStep&, \
                              Bindings&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
