#include "pipeline/stages/shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pipeline/stages/shading_terms.h"

namespace pipeline {

namespace {

template <class Real>
Vec3<Real> viewVector(const ShadingInputs& inputs, const View& view, Vec3<Real> position) {
    const UnitForm unit = inputs.illumination.detail.unit;
    if (modelFacts(inputs.illumination.model).viewer == Viewer::Camera) return towardsEye(view, position, unit);
    // OpenGL's infinite viewer looks along the viewing axis from everywhere, and its local viewer is at the eye also where
    // the view is orthographic.
    if (!inputs.illumination.localViewer) return -Vec3<Real>(view.forward);
    return normalized(Vec3<Real>(view.eye) - position, unit);
}

}  // namespace

template <class Real>
Surface<Real> polygonSurface(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t polygon) {
    const std::span<const Vec3<Real>> world = in.transform.world;
    const Topology::Corners corners = in.transform.topology->corners(polygon);
    // Relative to the first corner, so that the mean keeps its digits far from the origin.
    Vec3<Real> at = world[corners[0]];
    if (!modelFacts(inputs.illumination.model).firstVertex) {
        Vec3<Real> sum(0);
        for (std::size_t i = 1; i < corners.size(); ++i) sum += world[corners[i]] - at;
        at += sum / Real(corners.size());
    }
    const Vec3<Real> normal = flatNormal(inputs, in, polygon);
    Surface<Real> surface{at, showsBack(inputs, in, polygon) ? -normal : normal,
                          viewVector(inputs, in.transform.view, at), polygonColor(inputs, in, polygon)};
    if (inputs.planted.own) setOwnPlace(Domain::Polygon, polygon);
    if (inputs.planted) spoilSurface(inputs, surface);
    return surface;
}

template <class Real>
Surface<Real> vertexSurface(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t vertex,
                            bool back) {
    const Vec3<Real> position = in.transform.world[vertex], normal = in.normals.vertex[vertex];
    Surface<Real> surface{position, back ? -normal : normal, viewVector(inputs, in.transform.view, position),
                          Vec3<Real>(in.transform.topology->vertexColor(vertex))};
    if (inputs.planted.own) setOwnPlace(Domain::Vertex, vertex);
    if (inputs.planted) spoilSurface(inputs, surface);
    return surface;
}

template <class Real>
Surface<Real> pixelSurface(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::uint32_t triangle,
                           glm::ivec2 pixel, Vec3<Real> barycentric, const VertexWeights<Real>& weights) {
    const auto& v = in.transform.topology->triangles[triangle].vertices;
    const std::uint32_t polygon = in.transform.topology->polygonOf(triangle);
    const Vec3<Real> position =
        inputs.parts[Part::Position] ? interpolated(in.transform.world, v, barycentric) : Vec3<Real>(0);
    const Vec3<Real> normal =
        in.normals.vertex.empty()
            ? in.normals.polygon[polygon]
            : normalized(interpolated(weights, [&](std::uint32_t vertex) { return in.normals.vertex[vertex]; }),
                         inputs.illumination.detail.unit);
    Vec3<Real> V(0);
    if (inputs.parts[Part::ViewVector])
        V = modelFacts(inputs.illumination.model).viewer == Viewer::Setting
                ? viewVector(inputs, in.transform.view, position)
                : towardsEye<Real>(in.transform.view, pixel, inputs.illumination.detail.unit);
    Surface<Real> surface{position, showsBack(inputs, in, polygon) ? -normal : normal, V,
                          pixelColor(inputs, in, polygon, weights)};
    if (inputs.planted.own)
        setOwnPlace(Domain::Pixel, std::size_t(pixel.x) + std::size_t(pixel.y) * std::size_t(in.transform.view.size.x));
    if (inputs.planted) spoilPixel(inputs, in, weights, surface);
    return surface;
}

ShadingInputs withAllVectors(ShadingInputs inputs) {
    inputs.parts.whole.set(Part::Position).set(Part::ViewVector);
    inputs.illumination.detail.reflection = inputs.illumination.detail.halfway = true;
    inputs.illumination.detail.logContrast = std::numeric_limits<double>::infinity();
    return inputs;
}

double logContrast(const ShadingInputs& inputs) {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    if (inputs.colored) return kUnknown;  // the base may be as dark as a vertex' colour
    double contrast = 0;
    for (const auto* materials : {&inputs.materials, &inputs.backMaterials}) {
        for (const Material& material : *materials) {
            const Vec3d base = sumOf(baseTerms<double>(inputs, material));
            for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
                if (!inputs.parts.of(Part::Light, k)) continue;
                const Vec3d shining = inputs.lights[k].intensity * inputs.lights[k].color;
                const Vec3d diffuse = shining * material.diffuse, specular = shining * material.specular;
                for (int c = 0; c < 3; ++c) {
                    if (!(diffuse[c] >= 0 && specular[c] >= 0)) return kUnknown;  // the sum may be less than its base
                    if (specular[c] > 0) contrast = std::max(contrast, base[c] > 0 ? specular[c] / base[c] : kUnknown);
                }
            }
        }
    }
    return contrast > 0 ? log(contrast) : kUnknown;
}

template <class Real>
void prepareElements(const ShadingInputs& inputs, const ShadingSources<Real>& in, ElementPlaces places,
                     ShadingOutput<Real>& out) {
    const auto makeRoom = [&](auto& elements, std::vector<std::uint32_t> of, std::size_t count) {
        const std::size_t room = of.empty() ? count : std::size_t(std::ranges::max(of)) + 1;
        elements.places = std::move(of);
        elements.base.assign(room, {});
        elements.terms.assign(room * inputs.lights.size(), {});
        elements.intensity.assign(room, Vec3<Real>(0));
    };
    const Topology& topology = *in.transform.topology;
    if (inputs.parts[Part::PolygonTerms]) makeRoom(out.polygons, std::move(places.polygons), topology.polygonCount());
    if (!inputs.parts[Part::VertexTerms]) return;
    if (inputs.illumination.twoSided) makeRoom(out.verticesBack, places.vertices, topology.vertexCount());
    makeRoom(out.vertices, std::move(places.vertices), topology.vertexCount());
}

template <class Real>
ShadingCounts shadeOutlines(const ShadingSources<Real>& in, Tile tile, ShadingOutput<Real>& out) {
    for (int y = tile.min.y; y < tile.max.y; ++y) {
        for (int x = tile.min.x; x < tile.max.x; ++x) {
            const std::size_t at = in.zBuffer.triangle->offset({x, y});
            if (in.zBuffer.triangle->pixels[at] == kNoTriangle) continue;
            out.vectors[index(BufferId::Intensity)][0].pixels[at] = Vec3<Real>(Real(out.iMax));
            out.color.pixels[at] = Color8(255);
        }
    }
    return {};
}

void storeFrameBufferValue(Vec3d intensity, double iMax, const Planted& planted, Color8& pixel) {
    for (int c = 0; c < 3; ++c) {
        const double share = iMax > 0 ? intensity[c] / iMax : 0;
        // Written so that a share that is not a number gives 0.
        pixel[c] = static_cast<std::uint8_t>(!(share > 0) ? 0 : share >= 1 ? 255 : share * 255 + 0.5);
    }
    if (planted) spoilFrameBuffer(planted, intensity, iMax, pixel);
}

Color8 frameBufferValue(Vec3d intensity, double iMax, const Planted& planted) {
    Color8 value;
    storeFrameBufferValue(intensity, iMax, planted, value);
    return value;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                  \
    template Surface<Real> polygonSurface(const ShadingInputs&, const ShadingSources<Real>&, std::size_t);            \
    template Surface<Real> vertexSurface(const ShadingInputs&, const ShadingSources<Real>&, std::size_t, bool);       \
    template Surface<Real> pixelSurface(const ShadingInputs&, const ShadingSources<Real>&, std::uint32_t, glm::ivec2, \
                                        Vec3<Real>, const VertexWeights<Real>&);                                      \
    template ShadingCounts shadeOutlines(const ShadingSources<Real>&, Tile, ShadingOutput<Real>&);                    \
    template void prepareElements(const ShadingInputs&, const ShadingSources<Real>&, ElementPlaces,                   \
                                  ShadingOutput<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
