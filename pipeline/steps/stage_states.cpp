#include "pipeline/steps/stage_states.h"

#include <algorithm>

#include "pipeline/defects/drawing_hooks.h"
#include "pipeline/run/stage_parts.h"
#include "pipeline/stages/translucent.h"

namespace pipeline {

namespace {

// 0 where nothing has been written yet.
template <class Values>
void fillFrom(std::size_t first, Values&& values) {
    if (first < values.size())
        std::fill(values.begin() + std::ptrdiff_t(first), values.end(),
                  typename std::remove_cvref_t<Values>::value_type(0));
}

}  // namespace

template <class Real>
TransformOutput<Real> transformSoFar(const FrameData<Real>& data, std::size_t vertices) {
    TransformInputs inputs = data.keys.transform;
    inputs.placesAsGiven = false;  // some positions are not there yet
    const std::vector<std::uint32_t>& first = inputs.topology->firstVertex;
    auto out = prepareTransform<Real>(inputs);
    out.done = vertices;
    for (std::size_t object = 0; object < inputs.transforms.size() && first[object] < vertices; ++object)
        transform(inputs, object, 0, std::min<std::size_t>(vertices, first[object + 1]) - first[object], out);
    fillFrom(vertices, out.world.own());
    return out;
}

template <class Real>
CullOutput cullSoFar(const FrameData<Real>& data, std::size_t polygons, Threads& threads) {
    CullOutput out = prepareCull(data.transform->topology->polygonCount());
    cullPolygons(data.keys.cull, *data.transform, polygons, threads, out);
    std::fill(out.verdicts.begin() + std::ptrdiff_t(polygons), out.verdicts.end(), Verdict::NotYet);
    fillFrom(polygons, out.marks);
    return out;
}

template <class Real>
NormalsOutput<Real> normalsSoFar(const FrameData<Real>& data, std::size_t polygons, std::size_t vertices,
                                 Threads& threads) {
    NormalsInputs inputs = data.keys.normals;
    inputs.asGiven = false;  // some normals are not there yet
    const TransformOutput<Real>& in = *data.transform;
    const std::vector<std::uint32_t>& first = in.topology->firstVertex;
    NormalsOutput<Real> out = prepareNormals(inputs, in);
    findPolygonNormals(inputs, in, std::min(polygons, out.polygon.size()), threads, out);
    fillFrom(polygons, out.polygon), fillFrom(polygons, out.weighted);
    for (std::size_t object = 0; object + 1 < first.size() && first[object] < vertices; ++object)
        findVertexNormals(inputs, in, object, threads, out);
    fillFrom(vertices, out.vertex.own());
    return out;
}

namespace {

// With the same texels, which are not copied if they are in blocks.
template <class Real>
LightView<Real> sharing(const LightView<Real>& light) {
    return light;
}
LightView<float> sharing(const LightView<float>& light) {
    if (light.blocks.empty() || !light.blocks[0]) return light;
    LightView<float> out{light.faces, {}, light.blocks, light.rounding};
    for (const auto& blocks : light.blocks) out.depth.push_back(rowsLater(blocks));
    return out;
}

}  // namespace

template <class Real>
ShadowBufferOutput<Real> shadowBuffersSoFar(const FrameData<Real>& data, std::size_t light, std::size_t polygons,
                                            Threads& threads) {
    const ShadowBufferInputs& inputs = data.keys.shadowBuffer;
    const std::vector<std::vector<LightView<Real>>>& whole = data.shadowBuffer->lights;
    TransformOutput<Real> opaque;
    if (!data.transform->transparent.empty()) opaque = withoutTransparent(*data.transform);
    const TransformOutput<Real>& in = opaque.topology ? opaque : *data.transform;
    ShadowBufferOutput<Real> out = prepareShadowBuffer(inputs, in);
    const bool over = polygons >= in.topology->polygonCount();
    for (std::size_t k = 0; k < light + (over ? 1 : 0); ++k)
        for (std::size_t i = 0; i < whole[k].size(); ++i) out.lights[k][i] = sharing(whole[k][i]);
    if (polygons == 0 || over) return out;
    std::vector<std::uint8_t> drawn(in.topology->polygonCount(), 0);
    std::fill_n(drawn.begin(), polygons, std::uint8_t(1));
    drawShadows<Real>(in, inputs.cull, drawn, out.lights[light], threads);
    return out;
}

namespace {

template <class Real>
std::size_t tileCount(const FrameData<Real>& data) {
    const glm::ivec2 tiles = (data.transform->view.size + kTileSize - 1) / kTileSize;
    return std::size_t(tiles.x) * std::size_t(tiles.y);
}

// Copies the results of the pixels that are done.
template <class T>
void take(const std::vector<std::uint8_t>& done, const Buffer2D<T>& from, Buffer2D<T>& to) {
    for (std::size_t i = 0; i < done.size(); ++i)
        if (done[i]) to.pixels[i] = from.pixels[i];
}

// For each pixel whether it has been shaded.
template <class Real>
std::vector<std::uint8_t> shadedPixels(const FrameData<Real>& data, const ShadingProgress& progress) {
    const Buffer2D<std::uint32_t>& seen = *data.zBuffer->triangle;
    const Topology& topology = *data.transform->topology;
    std::vector<std::uint8_t> done(seen.pixels.size(), 0);
    for (std::size_t i = 0; i < done.size(); ++i) {
        if (seen.pixels[i] == kNoTriangle) continue;
        const std::uint32_t polygon = topology.polygonOf(seen.pixels[i]);
        const int x = int(i % std::size_t(seen.size.x)), y = int(i / std::size_t(seen.size.x));
        const Reach& reach = progress.reach;
        done[i] = polygon < progress.polygon ||
                  (polygon == progress.polygon && (y < reach.row || (y == reach.row && x < reach.x)));
    }
    return done;
}

}  // namespace

template <class Real>
std::shared_ptr<const ShadingOutput<Real>> shadedOpaque(const FrameData<Real>& data, BufferSet made, Threads& threads) {
    const ShadingInputs& inputs = data.keys.shading;
    if (!inputs.layers.drawn && inputs.samples == 1) return data.shading;
    const ShadingSources<Real> in = data.shadingSources();
    auto out = std::make_shared<ShadingOutput<Real>>(clearedShading(inputs, in, made, threads));
    out->polygons = data.shading->polygons, out->vertices = data.shading->vertices;
    out->verticesBack = data.shading->verticesBack;
    threads.forRange(tileCount(data), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) {
            const Tile pixels = tileOf(in.transform.view.size, tile);
            if (inputs.outlines)
                shadeOutlines(in, pixels, *out);
            else
                shadePixels(inputs, in, pixels, *out);
        }
    });
    return out;
}

template <class Real>
ShadingOutput<Real> shadedSoFar(const FrameData<Real>& data, const ShadingOutput<Real>& opaque, BufferSet made,
                                const ShadingProgress& progress, Threads& threads) {
    const ShadingInputs& inputs = data.keys.shading;
    const ShadingSources<Real> in = data.shadingSources();
    if (progress.samples) return *data.shading;
    ShadingOutput<Real> out = clearedShading(inputs, in, made, threads);
    prepareElements(inputs, in, {data.shading->polygons.places, data.shading->vertices.places}, out);
    shadePolygons(inputs, in, 0, std::min(progress.polygonTerms, out.polygons.count()), out);
    shadeVertices(inputs, in, 0, std::min(progress.vertexTerms, out.vertices.count()), out);
    out.pixelIsShaded = shadedPixels(data, progress);
    const std::vector<std::uint8_t>& done = out.pixelIsShaded;
    // The result of a pixel depends on no other pixel, unless a planted error makes it so.
    threads.forRange(kBufferCount, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t id = begin; id < end; ++id) {
            // The whole picture may have left out the intensity, and a reused picture may have buffers that are no
            // longer requested.
            out.vectors[id].resize(std::min(out.vectors[id].size(), opaque.vectors[id].size()));
            for (std::size_t k = 0; k < out.vectors[id].size(); ++k)
                take(done, opaque.vectors[id][k], out.vectors[id][k]);
            for (std::size_t k = 0; k < out.scalars[id].size(); ++k)
                take(done, opaque.scalars[id][k], out.scalars[id][k]);
        }
    });
    take(done, opaque.color, out.color);
    const std::size_t shadedTiles = inputs.outlines ? 0 : tileCount(data);
    threads.forRange(shadedTiles, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile)
            if (inputs.planted) spoilTile(inputs.planted, tileOf(in.transform.view.size, tile), out);
    });
    auto& mean = out.vectors[index(BufferId::Antialiased)];
    if (!mean.empty() && inputs.samples == 1) mean = out.vectors[index(BufferId::Intensity)];
    if (!progress.layers) return out;
    const LayerBins<Real> layers = binLayers(inputs, in);
    threads.forRange(layers.order.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) drawLayers(inputs, in, layers, tile, out);
    });
    if (!mean.empty() && inputs.samples == 1) mean = out.vectors[index(BufferId::Intensity)];
    return out;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                  \
    template TransformOutput<Real> transformSoFar(const FrameData<Real>&, std::size_t);                               \
    template CullOutput cullSoFar(const FrameData<Real>&, std::size_t, Threads&);                                     \
    template NormalsOutput<Real> normalsSoFar(const FrameData<Real>&, std::size_t, std::size_t, Threads&);            \
    template ShadowBufferOutput<Real> shadowBuffersSoFar(const FrameData<Real>&, std::size_t, std::size_t, Threads&); \
    template std::shared_ptr<const ShadingOutput<Real>> shadedOpaque(const FrameData<Real>&, BufferSet, Threads&);    \
    template ShadingOutput<Real> shadedSoFar(const FrameData<Real>&, const ShadingOutput<Real>&, BufferSet,           \
                                             const ShadingProgress&, Threads&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
