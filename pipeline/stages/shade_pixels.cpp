// The per-pixel half of stage 6.
#include "pipeline/defects/drawing_hooks.h"
#include "pipeline/stages/pixel_writer.h"
#include "pipeline/stages/shading_terms.h"

namespace pipeline {
namespace {

// A pixel on its way to a colour.
template <class Real>
struct Pixel {
    std::uint32_t polygon;
    VertexWeights<Real> weights;  // of what is interpolated
    const Material& material;
    bool back;  // the polygon shows its back, and is lit from there
    Surface<Real> surface;
};

// A light's terms and, where somebody wants to see them, its vectors, at one pixel.
template <class Real>
void lightAtPixel(const ShadingInputs& inputs, const ShadingSources<Real>& in, const ShadingOutput<Real>& out,
                  std::size_t k, const Pixel<Real>& pixel, bool vectors, LightSample<Real>& s) {
    const auto sample = [&](const Surface<Real>& at) {
        return sampleLight(inputs.illumination, inputs.lights[k], pixel.material, at,
                           inputs.parts.of(Part::Attenuation, k));
    };
    switch (inputs.shading) {
        case Shading::Phong: s = sample(pixel.surface); return;
        case Shading::Flat: {
            if (vectors) s = sample(polygonSurface(inputs, in, pixel.polygon));
            const LightTerms<Real>& terms = out.polygons.termsOf(pixel.polygon, inputs.lights.size(), k);
            s.diffuse = terms.diffuse, s.specular = terms.specular;
            return;
        }
        case Shading::Gouraud: {
            s.diffuse = s.specular = Vec3<Real>(0);
            if (vectors) s = {};
            for (std::size_t i = 0; i < pixel.weights.count; ++i) {
                const Real weight = pixel.weights.weights[i];
                const std::uint32_t vertex = pixel.weights.vertices[i];
                const LightTerms<Real>& terms =
                    vertexElements(out, pixel.back).termsOf(vertex, inputs.lights.size(), k);
                s.diffuse += weight * terms.diffuse, s.specular += weight * terms.specular;
                if (!vectors) continue;
                const LightSample<Real> v = sample(vertexSurface(inputs, in, vertex, pixel.back));
                s.L += weight * v.L, s.R += weight * v.R, s.H += weight * v.H;
                s.nDotL += weight * v.nDotL, s.rDotV += weight * v.rDotV, s.nDotH += weight * v.nDotH;
            }
            if (vectors) s.L = normalized(s.L), s.R = normalized(s.R), s.H = normalized(s.H);
        }
    }
}

// Emission and ambient light at one pixel; in Phong shading without the lights' own ambient parts.
template <class Real>
BaseTerms<Real> baseAtPixel(const ShadingInputs& inputs, const ShadingOutput<Real>& out, const Pixel<Real>& pixel) {
    switch (inputs.shading) {
        case Shading::Phong: return baseTerms(inputs, pixel.material, pixel.surface.color);
        case Shading::Flat: return out.polygons.baseOf(pixel.polygon);
        case Shading::Gouraud: {
            const auto& elements = vertexElements(out, pixel.back);
            return {interpolated(pixel.weights, [&](std::uint32_t vertex) { return elements.baseOf(vertex).emission; }),
                    interpolated(pixel.weights, [&](std::uint32_t vertex) { return elements.baseOf(vertex).ambient; })};
        }
    }
    return {};
}

// Where the pixel's surface is, and the N and V that its colour was computed with; those only where
// the shading or somebody who looks needs them.
template <class Real>
Surface<Real> shownSurface(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::uint32_t triangle,
                           glm::ivec2 at, Vec3<Real> barycentric, const VertexWeights<Real>& weights, bool wanted) {
    const Triangle& corners = in.transform.topology->triangles[triangle];
    if (inputs.shading == Shading::Phong || (wanted && inputs.shading == Shading::Gouraud))
        return pixelSurface(inputs, in, triangle, at, barycentric, weights);
    const Vec3<Real> position =
        inputs.parts[Part::Position] ? interpolated(in.transform.world, corners.vertices, barycentric) : Vec3<Real>(0);
    if (!wanted) return {position, Vec3<Real>(0), Vec3<Real>(0)};
    const Surface<Real> polygon = polygonSurface(inputs, in, in.transform.topology->polygonOf(triangle));
    return {position, polygon.N, polygon.V};
}

template <class Real>
Vec3<Real> shade(const ShadingInputs& inputs, const ShadingSources<Real>& in, const ShadingOutput<Real>& out,
                 std::uint32_t id, Vec3<Real> barycentric, glm::ivec2 at, Wanted wanted, ShadingScratch<Real>& scratch,
                 const Writer<Real>& write, ShadingCounts& counts) {
    const std::uint32_t shown = in.transform.topology->polygonOf(id);
    const bool back = showsBack(inputs, in, shown);
    const Material& material = materialOf(inputs, in.transform.topology->objectOfPolygon(shown), back);
    const VertexWeights<Real> weights =
        vertexWeights(inputs.interpolation, in.transform, id, barycentric, at, scratch.row);
    counts.affineInstead += weights.used != inputs.interpolation;
    const Pixel<Real> pixel{shown, weights, material, back,
                            shownSurface(inputs, in, id, at, barycentric, weights, wanted.surfaces)};
    if (wanted.any)
        write.put(BufferId::DiffuseCoefficient, pixelColor(inputs, in, shown, weights) * Vec3<Real>(material.diffuse));
    write.put(BufferId::Position, pixel.surface.position);
    write.put(BufferId::Normal, pixel.surface.N);
    write.put(BufferId::ViewVector, pixel.surface.V);
    BaseTerms<Real> base = baseAtPixel(inputs, out, pixel);
    for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
        if (!inputs.parts.of(Part::Light, k)) continue;
        LightSample<Real>& s = scratch.samples[k];
        lightAtPixel(inputs, in, out, k, pixel, wanted.vectors, s);
        if (inputs.shading != Shading::Phong) continue;
        base.ambient += s.ambient;
        count(s, counts);
    }
    write.put(BufferId::Emission, base.emission);
    const Vec3<Real> ambient = base.ambient;
    // One fixed order, so that the terms' buffers sum to the intensity to the last bit.
    Vec3<Real> intensity = sumOf(base);
    for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
        if (!inputs.parts.of(Part::Light, k)) continue;
        const LightSample<Real>& s = scratch.samples[k];
        const bool idle = s.diffuse == Vec3<Real>(0) && s.specular == Vec3<Real>(0);
        const bool lookUp = inputs.parts[Part::ShadowLookup] || wanted.everyShadow || !idle;
        const Real shadow = lookUp ? shadowAt(inputs, in, k, id, pixel.surface.position) : Real(1);
        if (in.shadow && !in.shadow->lights[k].empty()) ++(lookUp ? counts.lookups : counts.idleLookups);
        const Vec3<Real> diffuse = shadow * s.diffuse, specular = shadow * s.specular;
        intensity += diffuse;
        intensity += specular;
        if (inputs.planted) spoilAmbient(inputs.planted, k, shadow, ambient, base.ambient, intensity);
        if (inputs.planted) spoilSum(inputs, k, shadow, base, scratch, intensity);
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
    write.put(BufferId::Ambient, base.ambient);
    return intensity;
}

}  // namespace

template <class Real>
ShadingCounts shadePixels(const ShadingInputs& inputs, const ShadingSources<Real>& in, Tile tile,
                          ShadingOutput<Real>& out) {
    const Wanted wanted = wantedOf(out);
    ShadingCounts counts;
    ShadingScratch<Real> scratch(inputs);
    for (int y = tile.min.y; y < tile.max.y; ++y) {
        for (int x = tile.min.x; x < tile.max.x; ++x) {
            const std::size_t at = in.zBuffer.triangle->offset({x, y});
            const std::uint32_t id = in.zBuffer.triangle->pixels[at];
            if (id == kNoTriangle) continue;
            const Vec3<Real> intensity = shade(inputs, in, out, id, in.zBuffer.barycentric.pixels[at], {x, y}, wanted,
                                               scratch, Writer<Real>{wanted.any ? &out : nullptr, at}, counts);
            out.vectors[index(BufferId::Intensity)][0].pixels[at] = intensity;
            storeFrameBufferValue(Vec3d(intensity), out.iMax, inputs.planted, out.color.pixels[at]);
        }
    }
    if (inputs.planted) spoilTile(inputs.planted, tile, out);
    return counts;
}

template <class Real>
Vec3<Real> surfaceIntensity(const ShadingInputs& inputs, const ShadingSources<Real>& in, const ShadingOutput<Real>& out,
                            std::uint32_t triangle, Vec3<Real> barycentric, glm::ivec2 pixel,
                            ShadingScratch<Real>& scratch, ShadingCounts& counts) {
    return shade(inputs, in, out, triangle, barycentric, pixel, {}, scratch, Writer<Real>{nullptr, 0}, counts);
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                   \
    template ShadingCounts shadePixels(const ShadingInputs&, const ShadingSources<Real>&, Tile, ShadingOutput<Real>&); \
    template Vec3<Real> surfaceIntensity(const ShadingInputs&, const ShadingSources<Real>&,                            \
                                         const ShadingOutput<Real>&, std::uint32_t, Vec3<Real>, glm::ivec2,            \
                                         ShadingScratch<Real>&, ShadingCounts&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
