#include "pipeline/stages/shading.h"

namespace pipeline {

template <class Real>
Surface<Real> polygonSurface(const TransformOutput<Real>& in, const NormalsOutput<Real>& normals, std::size_t polygon) {
    const Topology::Corners corners = in.topology->corners(polygon);
    // Relative to the first corner, so that the mean keeps its digits far from the origin.
    const Vec3<Real> origin = in.world[corners[0]];
    Vec3<Real> sum(0);
    for (std::size_t i = 1; i < corners.size(); ++i) sum += in.world[corners[i]] - origin;
    const Vec3<Real> mean = origin + sum / Real(corners.size());
    return {mean, normals.polygon[polygon], towardsEye(in.view, mean)};
}

template <class Real>
Surface<Real> vertexSurface(const TransformOutput<Real>& in, const NormalsOutput<Real>& normals, std::size_t vertex) {
    const Vec3<Real> position = in.world[vertex];
    return {position, normals.vertex[vertex], towardsEye(in.view, position)};
}

template <class Real>
Surface<Real> pixelSurface(const TransformOutput<Real>& in, const NormalsOutput<Real>& normals, std::uint32_t triangle,
                           Vec3<Real> barycentric) {
    const auto& v = in.topology->triangles[triangle].vertices;
    const Vec3<Real> position = interpolated(in.world, v, barycentric);
    const Vec3<Real> normal = normals.vertex.empty() ? normals.polygon[in.topology->triangles[triangle].polygon]
                                                     : normalized(interpolated(normals.vertex, v, barycentric));
    return {position, normal, towardsEye(in.view, position)};
}

template <class Real>
ShadingOutput<Real> prepareShading(const ShadingInputs& inputs, const ShadingSources<Real>& in, BufferSet wanted) {
    ShadingOutput<Real> out;
    out.iMax = maximumIntensity(inputs.materials, inputs.lights, inputs.ambient);
    const auto makeRoom = [&](auto& elements, std::size_t count) {
        elements.terms.resize(count * inputs.lights.size());
        elements.intensity.resize(count);
    };
    if (inputs.polygonTerms) makeRoom(out.polygons, in.transform.topology->polygonCount());
    if (inputs.vertexTerms) makeRoom(out.vertices, in.transform.topology->vertexCount());

    const glm::ivec2 size = in.transform.view.size;
    wanted.set(index(BufferId::Intensity));
    for (const BufferInfo& info : bufferTable()) {
        if (info.stage != StageId::Shading || info.domain != Domain::Pixel || info.element != Element::Real ||
            !wanted[index(info.id)])
            continue;
        const std::size_t lights = info.perLight ? inputs.lights.size() : 1;
        for (std::size_t k = 0; k < lights; ++k) {
            if (info.channels == 3)
                out.vectors[index(info.id)].emplace_back(size, Vec3<Real>(Real(info.neutral)));
            else
                out.scalars[index(info.id)].emplace_back(size, Real(info.neutral));
        }
    }
    out.color = {size, Color8(0)};
    return out;
}

namespace {

template <class Real>
void shadeElement(const ShadingInputs& inputs, const Surface<Real>& at, const Material& material, std::size_t i,
                  typename ShadingOutput<Real>::Elements& out) {
    const std::size_t lights = inputs.lights.size();
    Vec3<Real> intensity = ambientTerm<Real>(inputs.ambient, material);
    for (std::size_t k = 0; k < lights; ++k) {
        if (!inputs.lightCounts[k]) continue;
        const LightSample<Real> sample = sampleLight(inputs.lights[k], material, at);
        out.terms[i * lights + k] = {sample.diffuse, sample.specular};
        intensity += sample.diffuse;
        intensity += sample.specular;
    }
    out.intensity[i] = intensity;
}

}  // namespace

template <class Real>
void shadePolygons(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t begin, std::size_t end,
                   ShadingOutput<Real>& out) {
    for (std::size_t i = begin; i < end; ++i) {
        if (!inputs.evaluateAll && !in.verdicts.empty() && !goesOn(in.verdicts[i])) continue;
        const Material& material = inputs.materials[in.transform.topology->polygonObject[i]];
        shadeElement(inputs, polygonSurface(in.transform, in.normals, i), material, i, out.polygons);
    }
}

template <class Real>
void shadeVertices(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t begin, std::size_t end,
                   ShadingOutput<Real>& out) {
    for (std::size_t i = begin; i < end; ++i) {
        const Material& material = inputs.materials[in.transform.topology->objectOfVertex(i)];
        shadeElement(inputs, vertexSurface(in.transform, in.normals, i), material, i, out.vertices);
    }
}

template <class Real>
Real shadowAt(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t k, std::uint32_t polygon,
              Vec3<Real> position) {
    const Light& light = inputs.lights[k];
    if (!light.castsShadow) return 1;
    const Vec3<Real> normal = in.normals.polygon[polygon];
    if (!(glm::dot(normal, towardsLight(light, position)) > 0)) return 0;
    if (!in.shadow || !in.shadow->lights[k]) return 1;
    return shadowFactor(*in.shadow->lights[k], inputs.shadow, position, normal);
}

Color8 frameBufferValue(Vec3d intensity, double iMax) {
    Color8 value(0);
    for (int c = 0; c < 3; ++c) {
        const double share = iMax > 0 ? intensity[c] / iMax : 0;
        // Written so that a share that is not a number gives 0.
        value[c] = static_cast<std::uint8_t>(!(share > 0) ? 0 : share >= 1 ? 255 : share * 255 + 0.5);
    }
    return value;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                              \
    template Surface<Real> polygonSurface(const TransformOutput<Real>&, const NormalsOutput<Real>&, std::size_t); \
    template Surface<Real> vertexSurface(const TransformOutput<Real>&, const NormalsOutput<Real>&, std::size_t);  \
    template Surface<Real> pixelSurface(const TransformOutput<Real>&, const NormalsOutput<Real>&, std::uint32_t,  \
                                        Vec3<Real>);                                                              \
    template ShadingOutput<Real> prepareShading(const ShadingInputs&, const ShadingSources<Real>&, BufferSet);    \
    template void shadePolygons(const ShadingInputs&, const ShadingSources<Real>&, std::size_t, std::size_t,      \
                                ShadingOutput<Real>&);                                                            \
    template void shadeVertices(const ShadingInputs&, const ShadingSources<Real>&, std::size_t, std::size_t,      \
                                ShadingOutput<Real>&);                                                            \
    template Real shadowAt(const ShadingInputs&, const ShadingSources<Real>&, std::size_t, std::uint32_t, Vec3<Real>);
SHADESCOPE_INSTANTIATE(float)
SHADESCOPE_INSTANTIATE(double)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
