#include "pipeline/inspect/pixel_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/text.h"
#include "pipeline/inspect/replay.h"
#include "pipeline/inspect/shadow_blocker.h"
#include "pipeline/inspect/shadow_events.h"
#include "pipeline/scene/area_light.h"

namespace pipeline {

namespace {

template <class Real>
LightReport reportLight(std::size_t k, const Light& light, const LightSample<Real>& s, bool phongLobe, Real shadow) {
    LightReport r{int(k),
                  Vec3d(s.L),
                  Vec3d(s.R),
                  Vec3d(s.H),
                  double(s.nDotL),
                  double(s.rDotV),
                  double(s.nDotH),
                  double(s.specularPower),
                  double(s.fading),
                  {},
                  double(shadow),
                  Vec3d(s.ambient),
                  Vec3d(shadow * s.diffuse),
                  Vec3d(shadow * s.specular),
                  Vec3d(s.diffuse),
                  Vec3d(s.specular),
                  {}};
    for (std::size_t i = 0; i < r.factors.size(); ++i) r.factors[i] = double(s.factors[i]);
    if (!(s.nDotL > 0))
        r.note = fmt::format("N·L is not above 0, so light {} adds {} here.", k,
                             s.ambient == Vec3<Real>(0) ? "nothing" : "only its ambient part");
    else if (shadow == 0)
        r.note = fmt::format("In the {} of light {}: only the ambient term counts.",
                             light.kind == LightKind::Area ? "umbra" : "shadow", k);
    else if (s.fading == 0)
        r.note = fmt::format("Outside the spot of light {}, or faded to nothing.", k);
    else if (phongLobe && !(s.rDotV > 0))
        r.note = fmt::format("R·V is not above 0, so light {} adds no specular part.", k);
    else if (shadow < 1 && light.kind == LightKind::Area)
        r.note = fmt::format("In the penumbra of light {}: part of it is seen.", k);
    return r;
}

// What the terms sum to without shadows or with them, in the order of the shading stage.
template <class Real>
Vec3<Real> sumOf(const Evaluation& e, Vec3d LightReport::*diffuse, Vec3d LightReport::*specular) {
    Vec3<Real> sum = Vec3<Real>(e.emission) + Vec3<Real>(e.ambient);
    for (const LightReport& light : e.lights) sum += Vec3<Real>(light.*diffuse), sum += Vec3<Real>(light.*specular);
    return sum;
}

// Where the model clamps the colours of polygons and vertices their terms shrink alike.
template <class Real>
void clampTerms(Evaluation& e) {
    const Vec3<Real> total = sumOf<Real>(e, &LightReport::unshadowedDiffuse, &LightReport::unshadowedSpecular);
    for (int c = 0; c < 3; ++c) {
        if (total[c] >= 0 && total[c] <= 1) continue;
        const Real share = clampingFactor(total[c]);
        const auto shrink = [&](Vec3d& term) { term[c] = double(Real(term[c]) * share); };
        shrink(e.emission), shrink(e.ambient);
        for (LightReport& light : e.lights) {
            shrink(light.diffuse), shrink(light.specular);
            shrink(light.unshadowedDiffuse), shrink(light.unshadowedSpecular);
        }
        e.clamped = true;
    }
}

// In the frame's own arithmetic, so that the terms are those of its buffers to the last bit.
template <class Real>
Evaluation evaluate(const ShadingInputs& inputs, const Surface<Real>& at, const Material& material, std::string where,
                    double weight, const std::vector<double>& shadow) {
    const Model model = inputs.illumination.model;
    Evaluation e{std::move(where), weight, Vec3d(at.position), Vec3d(at.N), Vec3d(at.V), {}, {}, {}};
    e.color = Vec3d(at.color);
    e.emission = Vec3d(Vec3<Real>(0) + emissionTerm<Real>(model, material));
    Vec3<Real> ambient = Vec3<Real>(0) + at.color * ambientTerm<Real>(model, inputs.ambient, material);
    for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
        const LightSample<Real> sample = sampleLight(inputs.illumination, inputs.lights[k], material, at);
        e.lights.push_back(reportLight(k, inputs.lights[k], sample,
                                       modelFacts(model).specularReads(usesHalfway(model, material)).R,
                                       Real(shadow[k])));
        ambient += sample.ambient;
    }
    const Vec3<Real> whole = ambient;
    Vec3<Real> sum(0);  // the sum is found below, of what the terms then are
    for (std::size_t k = 0; k < shadow.size(); ++k)
        if (inputs.planted) spoilAmbient(inputs.planted, k, Real(shadow[k]), whole, ambient, sum);
    e.ambient = Vec3d(ambient);
    if (modelFacts(model).clamps && inputs.shading != Shading::Phong) clampTerms<Real>(e);
    e.intensity = Vec3d(sumOf<Real>(e, &LightReport::diffuse, &LightReport::specular));
    return e;
}

// With a true minus sign, as in the equation that it stands under.
std::string coordinateText(double value) { return fmt::format("{}{:.6g}", value < 0 ? "−" : "", std::abs(value)); }
std::string placeText(Vec3d p) {
    return fmt::format("({}, {}, {})", coordinateText(p.x), coordinateText(p.y), coordinateText(p.z));
}

template <class Real>
void reportWeights(const VertexWeights<Real>& weights, Interpolation asked, PixelReport& report) {
    static constexpr const char* kNames[]{"perspective-correct", "affine", "scanline"};
    report.interpolation = kNames[std::size_t(weights.used)];
    if (weights.used != asked)
        report.interpolation += ", for scanline knows no polygon that is clipped or crosses itself";
    for (std::size_t i = 0; i < weights.count; ++i)
        report.weights.emplace_back(int(weights.vertices[i]), double(weights.weights[i]));
}

template <class Real>
void evaluateAll(const FrameData<Real>& data, std::uint32_t triangleId, Vec3<Real> b, PixelReport& report) {
    const TransformOutput<Real>& in = *data.transform;
    const ShadingInputs inputs = withAllVectors(data.keys.shading);
    const ShadingSources<Real> sources = data.shadingSources();
    const std::uint32_t shown = in.topology->polygonOf(triangleId);
    const bool back = showsBack(inputs, sources, shown);
    const Material& material = materialOf(inputs, in.topology->objectOfPolygon(shown), back);
    RowCrossings row;
    const VertexWeights<Real> weights = vertexWeights(inputs.interpolation, in, triangleId, b, report.pixel, row);
    if (inputs.shading != Shading::Flat) reportWeights(weights, inputs.interpolation, report);
    switch (inputs.shading) {
        case Shading::Flat: {
            const Surface<Real> at = polygonSurface(inputs, sources, shown);
            const char* where = !modelFacts(inputs.illumination.model).firstVertex ? "at the mean of the vertices "
                                : takesFirstVertexNormal(inputs, sources, shown)
                                    ? "with the normal of the first vertex, at "
                                    : "at the first vertex ";
            report.evaluations.push_back(
                evaluate(inputs, at, material, where + placeText(Vec3d(at.position)), 1, report.shadow));
            break;
        }
        case Shading::Gouraud:
            for (std::size_t i = 0; i < weights.count; ++i) {
                const std::uint32_t vertex = weights.vertices[i];
                const Surface<Real> at = vertexSurface(inputs, sources, vertex, back);
                report.evaluations.push_back(evaluate(inputs, at, material, fmt::format("at vertex {}", vertex),
                                                      double(weights.weights[i]), report.shadow));
                report.evaluations.back().vertex = int(vertex);
            }
            break;
        case Shading::Phong:
            report.evaluations.push_back(evaluate(inputs,
                                                  pixelSurface(inputs, sources, triangleId, report.pixel, b, weights),
                                                  material, "at the pixel", 1, report.shadow));
            break;
    }
}

// Which polygon stands before a light that does not reach the pixel.
template <class Real>
void explainShadows(const Scene& scene, const FrameData<Real>& data, const Stop& stop, PixelReport& report) {
    if (!modelFacts(data.keys.shading.illumination.model).shadows) return;
    for (std::size_t k = 0; k < report.shadow.size(); ++k) {
        if (report.shadow[k] != 0 || data.keys.shading.lights[k].kind == LightKind::Area) continue;
        std::string why;  // the same for every vertex that the pixel is interpolated from
        for (Evaluation& e : report.evaluations) {
            if (!(e.lights[k].nDotL > 0)) continue;
            if (why.empty())
                why = whyShadowed(scene, data, k, report.position, std::uint32_t(report.triangle), report.back, stop);
            e.lights[k].note = why;
        }
    }
}

// The terms as the frame has them: interpolated in its own arithmetic, and the shadow's factor last.
template <class Real>
void sumUp(PixelReport& report, std::size_t lights) {
    const Evaluation& first = report.evaluations[0];
    Vec3<Real> ambient(first.ambient), emission(first.emission);
    for (const Evaluation& e : report.evaluations) {
        // Differences: what is the same at every vertex stays what it is.
        ambient += Real(e.weight) * (Vec3<Real>(e.ambient) - Vec3<Real>(first.ambient));
        emission += Real(e.weight) * (Vec3<Real>(e.emission) - Vec3<Real>(first.emission));
    }
    report.ambient = Vec3d(ambient), report.emission = Vec3d(emission);
    for (std::size_t k = 0; k < lights; ++k) {
        Vec3<Real> diffuse(0), specular(0);
        for (const Evaluation& e : report.evaluations) {
            diffuse += Real(e.weight) * Vec3<Real>(e.lights[k].unshadowedDiffuse);
            specular += Real(e.weight) * Vec3<Real>(e.lights[k].unshadowedSpecular);
        }
        report.diffuse.push_back(Vec3d(Real(report.shadow[k]) * diffuse));
        report.specular.push_back(Vec3d(Real(report.shadow[k]) * specular));
    }
}

template <class Real>
void reportFragments(const FrameData<Real>& data, const Stop& stop, PixelReport& report) {
    const auto record = replayPixel(data, report.pixel, stop);
    // Inside the stage some are still to come.
    const Buffer2D<std::int32_t>& overdraw = data.zBuffer->overdraw;
    const std::size_t arrived = overdraw.empty() ? record.size() : std::size_t(overdraw.at(report.pixel));
    std::size_t lastWon = record.size();
    for (std::size_t i = 0; i < std::min(arrived, record.size()); ++i)
        if (record[i].won) lastWon = i;
    const bool reversed = isReversed(data.transform->depthFormat);
    for (std::size_t i = 0; i < record.size(); ++i) {
        const FragmentRecord& f = record[i];
        const int polygon = int(data.transform->topology->polygonOf(f.triangle));
        if (data.keys.zBuffer.visibility != Visibility::ZBuffer) {
            const FragmentVerdict verdict = i >= arrived   ? FragmentVerdict::NotYet
                                            : i == lastWon ? FragmentVerdict::PaintedLast
                                                           : FragmentVerdict::PaintedOver;
            report.fragments.push_back({polygon, f.depth, f.stored, verdict, {}});
            continue;
        }
        const FragmentVerdict verdict = i >= arrived   ? FragmentVerdict::NotYet
                                        : !f.won       ? FragmentVerdict::NotNearer
                                        : i == lastWon ? FragmentVerdict::WonStays
                                                       : FragmentVerdict::Overwritten;
        const bool isNearer = reversed ? f.depth > f.stored : f.depth < f.stored;
        // What is as far away as the cleared buffer is nearer than nothing. Otherwise only a planted defect decides against
        // the numbers; comparisonText() reads its sign.
        const bool isError = f.won ? !isNearer && f.depth != f.stored : isNearer;
        const std::string_view sign = f.won && f.depth == f.stored ? "="
                                      : isError && f.won           ? (reversed ? "< (the error)" : "> (the error)")
                                      : isError                    ? (reversed ? "> (the error)" : "< (the error)")
                                      : f.won                      ? (reversed ? ">" : "<")
                                                                   : (reversed ? "≤" : "≥");
        report.fragments.push_back({polygon, f.depth, f.stored, verdict, sign});
    }
    for (std::size_t i = 0; i < record.size(); ++i)
        if (record[i].won && i < arrived)
            report.fragments[i].shadows = shadowEvents(data, record[i].triangle, report.pixel);
    for (std::uint32_t polygon : culledAt(data, report.pixel, stop))
        report.culled.push_back({int(polygon), letter(data.cull->verdicts[polygon]),
                                 reason(*data.transform, *data.cull, polygon),
                                 signedArea(*data.transform, *data.cull, polygon)});
}

template <class Real>
void reportSamples(const FrameData<Real>& data, std::size_t at, PixelReport& report) {
    const auto& mean = data.shading->vectors[index(BufferId::Antialiased)];
    if (data.keys.shading.samples == 1) return;
    report.samples = data.keys.shading.samples;
    report.antialiased = Vec3d(mean[0].pixels[at]);
}

// The opaque surface's intensity, and what the layers over it make of it.
template <class Real>
void reportLayers(const FrameData<Real>& data, std::uint32_t triangle, std::size_t at, PixelReport& report) {
    const ShadingInputs& inputs = data.keys.shading;
    const ShadingSources<Real> sources = data.shadingSources();
    const Topology& topology = *data.transform->topology;
    ShadingScratch<Real> scratch(inputs);
    ShadingCounts counts;
    const auto intensityOf = [&](std::uint32_t id, Vec3<Real> b) {
        return surfaceIntensity(inputs, sources, *data.shading, id, b, report.pixel, scratch, counts);
    };
    Vec3<Real> opaque(0), added(0);
    Real left = 1;
    if (triangle != kNoTriangle)
        opaque = intensityOf(triangle, barycentricAt(*data.transform, *data.zBuffer, report.pixel));
    for (const Layer<Real>& layer : replayLayers(data, report.pixel)) {
        const std::uint32_t polygon = topology.polygonOf(layer.triangle);
        const Real a =
            Real(opacity(materialOf(inputs, topology.objectOfPolygon(polygon), showsBack(inputs, sources, polygon))));
        const Vec3<Real> intensity = intensityOf(layer.triangle, layer.barycentric);
        added = a * intensity + (1 - a) * added;
        left = (1 - a) * left;
        report.layers.push_back(
            {int(polygon), double(layer.zView), double(a), Vec3d(intensity), Vec3d(left * opaque + added)});
    }
    report.intensity = Vec3d(opaque);
    report.transmittance = double(left);
    report.translucent = Vec3d(added);
    const auto& composed = data.shading->vectors[index(BufferId::Intensity)];  // left out where there are no layers
    report.composed = composed.empty() ? report.intensity : Vec3d(composed[0].pixels[at]);
    reportSamples(data, at, report);
    report.color = data.shading->color.pixels[at];
    report.iMax = data.shading->iMax;
}

template <class Real>
void fill(const FrameData<Real>& data, const Stop& stop, bool fragments, PixelReport& report) {
    if (!data.zBuffer) return;
    if (fragments) reportFragments(data, stop, report);
    if (stop.stop_requested()) return;
    const std::size_t at = data.zBuffer->zView->offset(report.pixel);
    const std::uint32_t triangle = data.zBuffer->triangle->pixels[at];
    if (data.shading && !data.keys.shading.outlines) reportLayers(data, triangle, at, report);
    if (triangle == kNoTriangle) return;
    const Topology& topology = *data.transform->topology;
    const Vec3<Real> b = barycentricAt(*data.transform, *data.zBuffer, report.pixel);
    report.covered = true;
    report.polygon = int(topology.polygonOf(triangle));
    report.object = int(topology.objectOfPolygon(std::size_t(report.polygon)));
    for (std::size_t i = 0; i < 3; ++i) report.vertices[i] = int(topology.triangles[triangle].vertices[i]);
    report.triangle = int(triangle);
    report.barycentric = Vec3d(b);
    report.zView = double(data.zBuffer->zView->pixels[at]);
    const bool storesDepth = data.keys.zBuffer.visibility == Visibility::ZBuffer && !data.zBuffer->depth.empty();
    report.depth = storesDepth ? double(data.zBuffer->depth.pixels[at]) : report.zView;
    const Vec3<Real> position = interpolated(data.transform->world, topology.triangles[triangle].vertices, b);
    report.position = Vec3d(position);
    if (!data.shading) return;

    report.outline = data.keys.shading.outlines;
    if (report.outline) {
        report.iMax = data.shading->iMax;
        report.intensity = report.composed = Vec3d(data.shading->vectors[index(BufferId::Intensity)][0].pixels[at]);
        reportSamples(data, at, report);
        report.color = data.shading->color.pixels[at];
        return;
    }
    report.isShaded = data.shading->pixelIsShaded.empty() || data.shading->pixelIsShaded[at] != 0;
    report.back = showsBack(data.keys.shading, data.shadingSources(), std::size_t(report.polygon));
    const std::size_t lights = data.keys.shading.lights.size();
    for (std::size_t k = 0; k < lights; ++k)
        report.shadow.push_back(double(shadowAt(data.keys.shading, data.shadingSources(), k, triangle, position)));
    evaluateAll(data, triangle, b, report);
    if (modelFacts(data.keys.shading.illumination.model).shadows)
        for (std::size_t k = 0; k < lights; ++k)
            report.shadowPlaces.push_back(
                data.keys.shading.parts.of(Part::Light, k)
                    ? placeInLight(report.evaluations, data.keys.shading.lights[k], k, report.shadow[k])
                    : kNotLookedFor);
    sumUp<Real>(report, lights);
}

}  // namespace

PixelReport inspectPixel(const Frame& frame, glm::ivec2 pixel, const Stop& stop) {
    PixelReport report{};
    report.pixel = pixel;
    readStages(frame, [&](const auto& data) {
        fill(data, stop, true, report);
        explainShadows(frame.scene(), data, stop, report);
    });
    return report;
}

PixelReport inspectShading(const Frame& frame, glm::ivec2 pixel) {
    PixelReport report{};
    report.pixel = pixel;
    readStages(frame, [&](const auto& data) { fill(data, {}, false, report); });
    return report;
}

Evaluation inspectPolygon(const Frame& frame, std::uint32_t polygon) {
    return readStages(frame, [&]<class Real>(const FrameData<Real>& data) {
        const ShadingInputs inputs = withAllVectors(data.keys.shading);
        const ShadingSources<Real> in = data.shadingSources();
        const std::uint32_t object = data.transform->topology->objectOfPolygon(polygon);
        return evaluate(inputs, polygonSurface(inputs, in, polygon),
                        materialOf(inputs, object, showsBack(inputs, in, polygon)), "", 1,
                        std::vector<double>(inputs.lights.size(), 1));
    });
}

Evaluation inspectVertex(const Frame& frame, std::uint32_t vertex) {
    return readStages(frame, [&]<class Real>(const FrameData<Real>& data) {
        const ShadingInputs inputs = withAllVectors(data.keys.shading);
        const std::size_t object = data.transform->topology->objectOfVertex(vertex);
        return evaluate(inputs, vertexSurface(inputs, data.shadingSources(), vertex, false),
                        materialOf(inputs, object, false), "", 1, std::vector<double>(inputs.lights.size(), 1));
    });
}

}  // namespace pipeline
