// The part of stage 6 that evaluates polygons and vertices.
#include "pipeline/stages/shading_terms.h"

namespace pipeline {

ShadingCounts& ShadingCounts::operator+=(const ShadingCounts& more) {
    evaluations += more.evaluations;
    polygons += more.polygons, hiddenPolygons += more.hiddenPolygons;
    vertices += more.vertices, hiddenVertices += more.hiddenVertices;
    powers += more.powers, vanished += more.vanished;
    lookups += more.lookups, idleLookups += more.idleLookups;
    tiles += more.tiles, emptyTiles += more.emptyTiles;
    layers += more.layers;
    affineInstead += more.affineInstead;
    relit += more.relit, relitTiles += more.relitTiles;
    return *this;
}

namespace {

// Scales the terms at a place down to a colour in [0, 1].
template <class Real>
void clampElement(std::size_t place, std::size_t lights, typename ShadingOutput<Real>::Elements& out) {
    for (int c = 0; c < 3; ++c) {
        Real& total = out.intensity[place][c];
        if (total >= 0 && total <= 1) continue;
        const Real share = clampingFactor(total);
        out.base[place].emission[c] *= share;
        out.base[place].ambient[c] *= share;
        for (std::size_t k = 0; k < lights; ++k) {
            out.terms[place * lights + k].diffuse[c] *= share;
            out.terms[place * lights + k].specular[c] *= share;
        }
        total = total > 1 ? Real(1) : Real(0);
    }
}

template <class Real>
void shadeElement(const ShadingInputs& inputs, const Surface<Real>& at, const Material& material, std::size_t place,
                  typename ShadingOutput<Real>::Elements& out, ShadingCounts& counts) {
    const std::size_t lights = inputs.lights.size();
    BaseTerms<Real> base = baseTerms(inputs, material, at.color);
    for (std::size_t k = 0; k < lights; ++k) {
        if (!inputs.parts.of(Part::Light, k)) continue;
        const LightSample<Real> sample =
            sampleLight(inputs.illumination, inputs.lights[k], material, at, inputs.parts.of(Part::Attenuation, k));
        count(sample, counts);
        out.terms[place * lights + k] = {sample.diffuse, sample.specular};
        base.ambient += sample.ambient;
    }
    out.base[place] = base;
    Vec3<Real> intensity = sumOf(base);
    for (std::size_t k = 0; k < lights; ++k) {
        intensity += out.terms[place * lights + k].diffuse;
        intensity += out.terms[place * lights + k].specular;
    }
    out.intensity[place] = intensity;
    if (modelFacts(inputs.illumination.model).clamps) clampElement<Real>(place, lights, out);
}

}  // namespace

template <class Real>
Vec3<Real> polygonColor(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t polygon) {
    const Topology& topology = *in.transform.topology;
    if (topology.meshes[topology.objectOfPolygon(polygon)]->colors.empty()) return Vec3<Real>(1);
    const Topology::Corners corners = topology.corners(polygon);
    const Vec3<Real> first(topology.vertexColor(corners[0]));
    if (modelFacts(inputs.illumination.model).firstVertex) return first;
    Vec3<Real> sum(0);
    for (std::size_t i = 1; i < corners.size(); ++i) sum += Vec3<Real>(topology.vertexColor(corners[i])) - first;
    return first + sum / Real(corners.size());
}

template <class Real>
Vec3<Real> pixelColor(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::uint32_t polygon,
                      const VertexWeights<Real>& weights) {
    const Topology& topology = *in.transform.topology;
    if (inputs.shading == Shading::Flat) return polygonColor(inputs, in, polygon);
    if (topology.meshes[topology.objectOfPolygon(polygon)]->colors.empty()) return Vec3<Real>(1);
    return interpolated(weights, [&](std::uint32_t vertex) { return Vec3<Real>(topology.vertexColor(vertex)); });
}

template <class Real>
ShadingCounts shadePolygons(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t begin,
                            std::size_t end, ShadingOutput<Real>& out) {
    ShadingCounts counts;
    for (std::size_t i = begin; i < end; ++i) {
        if (!out.polygons.isEvaluated(i)) {
            ++counts.hiddenPolygons;
            continue;
        }
        ++counts.polygons;
        const Material& material =
            materialOf(inputs, in.transform.topology->objectOfPolygon(i), showsBack(inputs, in, i));
        shadeElement(inputs, polygonSurface(inputs, in, i), material, out.polygons.placeOf(i), out.polygons, counts);
    }
    return counts;
}

template <class Real>
ShadingCounts shadeVertices(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t begin,
                            std::size_t end, ShadingOutput<Real>& out) {
    ShadingCounts counts;
    for (std::size_t i = begin; i < end; ++i) {
        if (!out.vertices.isEvaluated(i)) {
            ++counts.hiddenVertices;
            continue;
        }
        ++counts.vertices;
        const std::size_t object = in.transform.topology->objectOfVertex(i), place = out.vertices.placeOf(i);
        shadeElement(inputs, vertexSurface(inputs, in, i, false), inputs.materials[object], place, out.vertices,
                     counts);
        if (!inputs.illumination.twoSided) continue;
        shadeElement(inputs, vertexSurface(inputs, in, i, true), inputs.backMaterials[object], place, out.verticesBack,
                     counts);
    }
    return counts;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                  \
    template Vec3<Real> polygonColor(const ShadingInputs&, const ShadingSources<Real>&, std::size_t);                 \
    template Vec3<Real> pixelColor(const ShadingInputs&, const ShadingSources<Real>&, std::uint32_t,                  \
                                   const VertexWeights<Real>&);                                                       \
    template ShadingCounts shadePolygons(const ShadingInputs&, const ShadingSources<Real>&, std::size_t, std::size_t, \
                                         ShadingOutput<Real>&);                                                       \
    template ShadingCounts shadeVertices(const ShadingInputs&, const ShadingSources<Real>&, std::size_t, std::size_t, \
                                         ShadingOutput<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
