// The per-pixel half of stage 6.
#include "pipeline/stages/shading.h"

namespace pipeline {
namespace {

// A light's terms and, where somebody wants to see them, its vectors, at one pixel.
template <class Real>
LightSample<Real> lightAtPixel(const ShadingInputs& inputs, const ShadingSources<Real>& in,
                               const ShadingOutput<Real>& out, std::size_t k, const Triangle& triangle,
                               Vec3<Real> barycentric, const Surface<Real>& surface, const Material& material,
                               bool vectors) {
    const std::size_t lights = inputs.lights.size();
    switch (inputs.shading) {
        case Shading::Phong: return sampleLight(inputs.lights[k], material, surface);
        case Shading::Flat: {
            LightSample<Real> s{};
            if (vectors)
                s = sampleLight(inputs.lights[k], material, polygonSurface(in.transform, in.normals, triangle.polygon));
            const LightTerms<Real>& terms = out.polygons.terms[triangle.polygon * lights + k];
            s.diffuse = terms.diffuse, s.specular = terms.specular;
            return s;
        }
        case Shading::Gouraud: {
            LightSample<Real> s{};
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t vertex = triangle.vertices[i];
                const LightTerms<Real>& terms = out.vertices.terms[vertex * lights + k];
                s.diffuse += barycentric[i] * terms.diffuse;
                s.specular += barycentric[i] * terms.specular;
                if (!vectors) continue;
                const LightSample<Real> v =
                    sampleLight(inputs.lights[k], material, vertexSurface(in.transform, in.normals, vertex));
                s.L += barycentric[i] * v.L, s.R += barycentric[i] * v.R, s.H += barycentric[i] * v.H;
                s.nDotL += barycentric[i] * v.nDotL;
                s.rDotV += barycentric[i] * v.rDotV;
                s.nDotH += barycentric[i] * v.nDotH;
            }
            s.L = normalized(s.L), s.R = normalized(s.R), s.H = normalized(s.H);
            return s;
        }
    }
    return {};
}

// Writes into buffers that are there, and nowhere else.
template <class Real>
struct Writer {
    ShadingOutput<Real>& out;
    std::size_t at;
    void put(BufferId id, Vec3<Real> value, std::size_t k = 0) const {
        auto& buffers = out.vectors[index(id)];
        if (!buffers.empty()) buffers[k].pixels[at] = value;
    }
    void put(BufferId id, Real value, std::size_t k = 0) const {
        auto& buffers = out.scalars[index(id)];
        if (!buffers.empty()) buffers[k].pixels[at] = value;
    }
};

template <class Real>
bool wantsVectors(const ShadingOutput<Real>& out) {
    using enum BufferId;
    for (BufferId id : {LightVector, ReflectionVector, HalfwayVector})
        if (!out.vectors[index(id)].empty()) return true;
    for (BufferId id : {NDotL, RDotV, NDotH})
        if (!out.scalars[index(id)].empty()) return true;
    return false;
}

template <class Real>
bool wantsSurface(const ShadingOutput<Real>& out) {
    return !out.vectors[index(BufferId::Normal)].empty() || !out.vectors[index(BufferId::ViewVector)].empty();
}

// Where the pixel's surface is, and the N and V that its colour was computed with; those only where
// the shading or somebody who looks needs them.
template <class Real>
Surface<Real> shownSurface(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::uint32_t triangle,
                           Vec3<Real> barycentric, bool wanted) {
    const Triangle& corners = in.transform.topology->triangles[triangle];
    if (inputs.shading == Shading::Phong || (wanted && inputs.shading == Shading::Gouraud))
        return pixelSurface(in.transform, in.normals, triangle, barycentric);
    const Vec3<Real> position = interpolated(in.transform.world, corners.vertices, barycentric);
    if (!wanted) return {position, Vec3<Real>(0), Vec3<Real>(0)};
    const Surface<Real> polygon = polygonSurface(in.transform, in.normals, corners.polygon);
    return {position, polygon.N, polygon.V};
}

}  // namespace

template <class Real>
void shadePixels(const ShadingInputs& inputs, const ShadingSources<Real>& in, Tile tile, ShadingOutput<Real>& out) {
    const Topology& topology = *in.transform.topology;
    const bool vectors = wantsVectors(out), surfaces = wantsSurface(out);
    for (int y = tile.min.y; y < tile.max.y; ++y) {
        for (int x = tile.min.x; x < tile.max.x; ++x) {
            const std::size_t at = in.zBuffer.triangle.offset({x, y});
            const std::uint32_t id = in.zBuffer.triangle.pixels[at];
            if (id == kNoTriangle) continue;
            const Triangle& triangle = topology.triangles[id];
            const Vec3<Real> barycentric = in.zBuffer.barycentric.pixels[at];
            const Material& material = inputs.materials[topology.polygonObject[triangle.polygon]];
            const Surface<Real> surface = shownSurface(inputs, in, id, barycentric, surfaces);
            const Writer<Real> write{out, at};
            write.put(BufferId::Position, surface.position);
            write.put(BufferId::Normal, surface.N);
            write.put(BufferId::ViewVector, surface.V);

            const Vec3<Real> ambient = ambientTerm<Real>(inputs.ambient, material);
            write.put(BufferId::Ambient, ambient);
            // One fixed order, so that the terms' buffers sum to the intensity to the last bit.
            Vec3<Real> intensity = ambient;
            for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
                if (!inputs.lightCounts[k]) continue;
                const LightSample<Real> s =
                    lightAtPixel(inputs, in, out, k, triangle, barycentric, surface, material, vectors);
                const Real shadow = shadowAt(inputs, in, k, triangle.polygon, surface.position);
                const Vec3<Real> diffuse = shadow * s.diffuse, specular = shadow * s.specular;
                intensity += diffuse;
                intensity += specular;
                write.put(BufferId::Shadow, shadow, k);
                write.put(BufferId::Diffuse, diffuse, k);
                write.put(BufferId::Specular, specular, k);
                write.put(BufferId::LightVector, s.L, k);
                write.put(BufferId::ReflectionVector, s.R, k);
                write.put(BufferId::HalfwayVector, s.H, k);
                write.put(BufferId::NDotL, s.nDotL, k);
                write.put(BufferId::RDotV, s.rDotV, k);
                write.put(BufferId::NDotH, s.nDotH, k);
            }
            write.put(BufferId::Intensity, intensity);
            out.color.pixels[at] = frameBufferValue(Vec3d(intensity), out.iMax);
        }
    }
}

template void shadePixels(const ShadingInputs&, const ShadingSources<float>&, Tile, ShadingOutput<float>&);
template void shadePixels(const ShadingInputs&, const ShadingSources<double>&, Tile, ShadingOutput<double>&);

}  // namespace pipeline
