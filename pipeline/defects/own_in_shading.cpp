// A student's functions in stage 6.
#include <algorithm>
#include <cmath>

#include "pipeline/core/numerics.h"
#include "pipeline/defects/defect_ways.h"
#include "pipeline/defects/own_hooks.h"
#include "pipeline/scene/model_facts.h"
#include "pipeline/stages/shading.h"
#include "pipeline/stages/translucent.h"

namespace pipeline {

template <class Real>
bool ownDirections(const Own& own, const Light& light, const Surface<Real>& at, LightSample<Real>& s) {
    OwnCall call(own);
    switch (own.function) {
        case OwnFunction::LightVector: {
            if (light.kind == LightKind::AtInfinity) return false;
            call << light.position << at.position;
            const auto found = call.result();
            if (found) s.L = vectorOf<Real>(*found);
            return found.has_value();
        }
        case OwnFunction::Mirror:
            if (s.R == Vec3<Real>(0)) return false;
            call << at.N << s.L;
            if (const auto found = call.result()) s.R = vectorOf<Real>(*found), s.rDotV = glm::dot(s.R, at.V);
            return false;
        case OwnFunction::Halfway:
            if (s.H == Vec3<Real>(0)) return false;
            call << s.L << at.V;
            if (const auto found = call.result()) s.H = vectorOf<Real>(*found), s.nDotH = glm::dot(at.N, s.H);
            return false;
        default: return false;
    }
}

template <class Real>
bool isOwnVectorOff(const Own& own, const Surface<Real>& at, const LightSample<Real>& s) {
    constexpr double kOff = 1e-5;  // more than rounding leaves in float
    const auto isOff = [](const Vec3<Real>& v) { return v != Vec3<Real>(0) && offUnit(Vec3d(v)) > kOff; };
    switch (own.function) {
        case OwnFunction::LightVector: return isOff(s.L);
        case OwnFunction::Mirror: return isOff(s.R);
        case OwnFunction::Halfway: return isOff(s.H);
        case OwnFunction::ViewVector: return isOff(at.V);
        case OwnFunction::NormalAt: return isOff(at.N);
        default: return false;
    }
}

template <class Real>
void ownTerms(const Own& own, const Illumination& illumination, const Light& light, const Material& material,
              const Surface<Real>& at, LightSample<Real>& s) {
    // The contracts are of a light's intensity, and of a power of a cosine.
    const ModelFacts& facts = modelFacts(illumination.model);
    if (facts.lobe == Lobe::None || facts.found.glLights) return;
    const bool halfway = usesHalfway(illumination.model, material);
    OwnCall call(own);
    if (own.function == OwnFunction::Lambert) {
        call << material.diffuse << light.intensity * light.color << at.N << s.L;
        if (const auto found = call.result()) s.diffuse = vectorOf<Real>(*found);
    } else if (own.function == (halfway ? OwnFunction::Blinn : OwnFunction::Specular)) {
        call << material.specular << light.intensity * light.color << at.N << s.L << at.V
             << effectiveExponent(illumination.model, illumination.exponentFactor, material);
        if (const auto found = call.result()) s.specular = vectorOf<Real>(*found);
    }
}

template <class Real>
void ownSurface(const ShadingInputs& inputs, Surface<Real>& surface) {
    const View& view = *inputs.shadow.eye;
    if (inputs.planted.own->function != OwnFunction::ViewVector || !view.perspective) return;
    if (surface.V == Vec3<Real>(0)) return;
    OwnCall call(*inputs.planted.own);
    call << view.eye << surface.position;
    if (const auto found = call.result()) surface.V = vectorOf<Real>(*found);
}

template <class Real>
void ownPixel(const Own& own, const ShadingSources<Real>& in, const VertexWeights<Real>& weights,
              Surface<Real>& surface) {
    if (own.function != OwnFunction::NormalAt || in.normals.vertex.empty() || weights.count != 3) return;
    OwnCall call(own);
    call << Vec3<Real>(weights.weights[0], weights.weights[1], weights.weights[2]);
    Vec3<Real> sum(0);
    for (std::size_t i = 0; i < 3; ++i) {
        call << in.normals.vertex[weights.vertices[i]];
        sum += weights.weights[i] * in.normals.vertex[weights.vertices[i]];
    }
    // Of a back face the stage has turned it round.
    if (const auto found = call.result())
        surface.N = glm::dot(sum, surface.N) < 0 ? -vectorOf<Real>(*found) : vectorOf<Real>(*found);
}

template <class Real>
void spoilSum(const ShadingInputs& inputs, std::size_t light, Real shadow, const BaseTerms<Real>& base,
              ShadingScratch<Real>& scratch, Vec3<Real>& intensity) {
    const Planted& planted = inputs.planted;
    if (planted.defect == Defect::AmbientInShadow && planted.way == kHighlightInShadow)
        intensity += (1 - shadow) * scratch.samples[light].specular;
    if (planted.defect == Defect::AmbientInShadow && planted.way == kBlockedAlone && light == 0 &&
        scratch.samples[0].nDotL > 0)
        intensity -= (1 - shadow) * base.ambient;
    const Own* const own = planted.own;
    if (!own || (own->function != OwnFunction::InShadow && own->function != OwnFunction::Total)) return;
    if (light == 0) scratch.shadows.clear();
    scratch.shadows.push_back(shadow);
    const std::size_t lights = inputs.lights.size();
    if (scratch.shadows.size() < lights) return;
    OwnCall call(*own);
    const Vec3<Real> there = base.emission + base.ambient;
    if (own->function == OwnFunction::InShadow) {
        if (lights != 1) return;
        call << double(shadow) << there << scratch.samples[0].diffuse << scratch.samples[0].specular;
    } else {
        call << there << double(lights);
        for (std::size_t k = 0; k < lights; ++k) call << scratch.shadows[k] * scratch.samples[k].diffuse;
        call << double(lights);
        for (std::size_t k = 0; k < lights; ++k) call << scratch.shadows[k] * scratch.samples[k].specular;
    }
    if (const auto found = call.result()) intensity = vectorOf<Real>(*found);
}

void spoilMaximum(const ShadingInputs& inputs, const std::vector<std::uint8_t>& transparent, double& iMax) {
    const Own* const own = inputs.planted.own;
    if (!own || own->function != OwnFunction::IMax || modelFacts(inputs.illumination.model).white != White::Maximum)
        return;
    double diffuse = 0, specular = 0;
    for (std::size_t i = 0; i < inputs.materials.size(); ++i) {
        if (!transparent.empty() && transparent[i]) continue;
        const Vec3d kd = inputs.materials[i].diffuse, ks = inputs.materials[i].specular;
        diffuse = std::max({diffuse, kd.x, kd.y, kd.z}), specular = std::max({specular, ks.x, ks.y, ks.z});
    }
    OwnCall call(*own);
    call << Vec3d(diffuse) << inputs.ambient.lightIn(inputs.illumination.model) << Vec3d(diffuse) << Vec3d(specular)
         << double(inputs.lights.size());
    for (const Light& light : inputs.lights) call << light.intensity * light.color;
    if (const auto found = call.result()) iMax = found->at[0];
}

void ownFrameBuffer(const Own& own, Vec3d intensity, double iMax, Color8& value) {
    if (own.function != OwnFunction::FrameBuffer || !(iMax > 0)) return;
    OwnCall call(own);
    call << intensity << iMax;
    const auto found = call.result();
    for (int c = 0; c < 3 && found; ++c)
        value[c] = std::uint8_t(std::clamp(found->at[std::size_t(c)], 0.0, 255.0) + 0.5);
}

template <class Real>
void spoilBlended(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::span<const Layer<Real>> layers,
                  std::span<const Vec3<Real>> lit, glm::ivec2 pixel, Vec3<Real> behind, Vec3<Real>& intensity) {
    const Own* const own = inputs.planted.own;
    if (!own || (own->function != OwnFunction::Blend && own->function != OwnFunction::BlendLayers)) return;
    const std::size_t place = std::size_t(pixel.y) * std::size_t(in.transform.view.size.x) + std::size_t(pixel.x);
    const Topology& topology = *in.transform.topology;
    const auto alpha = [&](std::size_t i) {
        const std::uint32_t polygon = topology.polygonOf(layers[i].triangle);
        return opacity(materialOf(inputs, topology.objectOfPolygon(polygon), showsBack(inputs, in, polygon)));
    };
    std::vector<std::size_t> mine;
    for (std::size_t i = 0; i < layers.size(); ++i)
        if (layers[i].pixel == pixel) mine.push_back(i);
    if (own->function == OwnFunction::Blend) {
        bool isOther = false;
        Vec3<Real> c = behind;
        for (const std::size_t i : mine) {
            const Real a = Real(alpha(i));
            OwnCall call(*own);
            call << double(a) << lit[i] << c;
            const auto found = call.result(OwnPlace::Pixel, place);
            c = found ? vectorOf<Real>(*found) : a * lit[i] + (1 - a) * c;
            isOther = isOther || found;
        }
        if (isOther) intensity = c;
        return;
    }
    std::ranges::sort(mine, {}, [&](std::size_t i) { return layers[i].triangle; });
    OwnCall call(*own);
    call << double(mine.size());
    for (const std::size_t i : mine) call << double(layers[i].zView);
    call << double(mine.size());
    for (const std::size_t i : mine) call << alpha(i);
    call << double(mine.size());
    for (const std::size_t i : mine) call << lit[i];
    call << behind;
    if (const auto found = call.result(OwnPlace::Pixel, place)) intensity = vectorOf<Real>(*found);
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                               \
    template bool ownDirections(const Own&, const Light&, const Surface<Real>&, LightSample<Real>&);               \
    template bool isOwnVectorOff(const Own&, const Surface<Real>&, const LightSample<Real>&);                      \
    template void ownTerms(const Own&, const Illumination&, const Light&, const Material&, const Surface<Real>&,   \
                           LightSample<Real>&);                                                                    \
    template void ownSurface(const ShadingInputs&, Surface<Real>&);                                                \
    template void ownPixel(const Own&, const ShadingSources<Real>&, const VertexWeights<Real>&, Surface<Real>&);   \
    template void spoilSum(const ShadingInputs&, std::size_t, Real, const BaseTerms<Real>&, ShadingScratch<Real>&, \
                           Vec3<Real>&);                                                                           \
    template void spoilBlended(const ShadingInputs&, const ShadingSources<Real>&, std::span<const Layer<Real>>,    \
                               std::span<const Vec3<Real>>, glm::ivec2, Vec3<Real>, Vec3<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
