#include "pipeline/stages/translucent.h"

#include <algorithm>
#include <limits>

#include "pipeline/stages/painter.h"

namespace pipeline {

std::vector<std::uint8_t> drawnIn(Pass pass, const Topology& topology, std::span<const std::uint8_t> transparent,
                                  std::span<const TranslucentSides> sides, const CullOutput* cull) {
    if (pass == Pass::Opaque && transparent.empty() && sides.empty()) return {};
    std::vector<std::uint8_t> drawn(topology.polygonCount(), 0);
    for (std::size_t polygon = 0; polygon < drawn.size(); ++polygon) {
        const std::uint32_t object = topology.objectOfPolygon(polygon);
        if (!transparent.empty() && transparent[object]) continue;
        const bool back = cull && cull->isBack(polygon);
        const bool translucent = !sides.empty() && (back ? sides[object].back : sides[object].front);
        drawn[polygon] = translucent == (pass == Pass::Translucent);
    }
    return drawn;
}

template <class Real>
TransformOutput<Real> withoutTransparent(const TransformOutput<Real>& in) {
    const Topology& topology = *in.topology;
    const auto nothing = std::make_shared<const Mesh>();
    std::vector<std::shared_ptr<const Mesh>> meshes = topology.meshes;
    TransformOutput<Real> out;
    out.mirrored = in.mirrored;  // the objects stay, without their meshes
    for (std::size_t object = 0; object < meshes.size(); ++object)
        if (in.transparent[object]) meshes[object] = nothing;
    out.topology = std::make_shared<const Topology>(makeTopology(std::move(meshes)));
    out.world.makeOwn(out.topology->vertexCount());
    for (std::size_t object = 0; object < topology.meshes.size(); ++object) {
        const std::size_t first = out.topology->firstVertex[object];
        const std::size_t count = out.topology->firstVertex[object + 1] - first;
        std::ranges::copy(in.world.all().subspan(topology.firstVertex[object], count),
                          out.world.own().begin() + std::ptrdiff_t(first));
    }
    return out;
}

template <class Real>
LayerBins<Real> binLayers(const ShadingInputs& inputs, const ShadingSources<Real>& in) {
    const TransformOutput<Real>& t = in.transform;
    const std::vector<std::uint8_t> drawn =
        drawnIn(Pass::Translucent, *t.topology, t.transparent, inputs.layers.sides, in.cull);
    std::span<const Verdict> verdicts;
    if (in.cull) verdicts = in.cull->verdicts;
    LayerBins<Real> out;
    out.bins = binTriangles<Real>(*t.topology, t.view, t.world, verdicts, {}, drawn);
    if (inputs.layers.order == Translucency::Exact) {
        out.order = out.bins.bins;
        // One triangle that clipping has cut is more than one here.
        out.sorts = inputs.layers.sorted || out.bins.triangles.size() > 1;
        return out;
    }
    const PaintingOrder order = paintingOrder<Real>(*t.topology, t.view, t.world, out.bins, false);
    out.order = binPieces(out.bins, order);
    for (std::vector<std::uint32_t>& tile : out.order)
        for (std::uint32_t& i : tile) i = order.pieces[i].triangle;
    out.sorts = false;
    return out;
}

template <class Real>
std::optional<std::vector<Layer<Real>>> layersIn(const ShadingInputs& inputs, const ShadingSources<Real>& in,
                                                 const LayerBins<Real>& layers, std::span<const std::uint32_t> order,
                                                 Tile tile, std::size_t limit) {
    const View& view = in.transform.view;
    const DepthCode code(view, in.transform.depthFormat);
    const bool compares = inputs.layers.depthStored && in.transform.depthFormat != DepthFormat::Linear;
    std::vector<Layer<Real>> found;
    for (const std::uint32_t i : order) {
        const RasterTriangle<Real>& triangle = layers.bins.triangles[i];
        forEachCovered(triangle.snapped, tile, [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) {
            if (found.size() > limit) return;
            const std::size_t at = in.zBuffer.zView->offset(pixel);
            const Fragment<Real> fragment = interpolate(triangle, pixel, e, view.perspective);
            const auto w = interpolateW(triangle, e);
            const bool first = in.zBuffer.triangle->pixels[at] == kNoTriangle;
            const bool nearer = compares ? first || code.nearer(code.encode(w, w), in.zBuffer.depth.pixels[at])
                                         : fragment.z < in.zBuffer.zView->pixels[at];
            if (nearer)
                found.push_back(
                    {triangle.id, pixel, double(view.perspective ? -w : w), fragment.z, fragment.barycentric});
        });
        if (found.size() > limit) return {};
    }
    if (layers.sorts)
        std::ranges::stable_sort(found, [](const Layer<Real>& a, const Layer<Real>& b) { return a.depth > b.depth; });
    if (inputs.planted) spoilLayers(inputs.planted, found);
    return found;
}

namespace {

// What the layers of a tile's pixels come to.
template <class Real>
struct Composed {
    glm::ivec2 origin;
    Buffer2D<Vec3<Real>> added;
    Buffer2D<Real> left;
    Buffer2D<std::int32_t> count;
};

template <class Real>
Composed<Real> compose(const ShadingInputs& inputs, const ShadingSources<Real>& in, Tile tile,
                       const std::vector<Layer<Real>>& layers, const ShadingOutput<Real>& out, ShadingCounts& counts) {
    const Topology& topology = *in.transform.topology;
    const glm::ivec2 size = tile.max - tile.min;
    Composed<Real> c{tile.min, {size, Vec3<Real>(0)}, {size, Real(1)}, {size, 0}};
    ShadingScratch<Real> scratch(inputs);
    for (const Layer<Real>& layer : layers) {
        const std::uint32_t polygon = topology.polygonOf(layer.triangle);
        const Real a =
            Real(opacity(materialOf(inputs, topology.objectOfPolygon(polygon), showsBack(inputs, in, polygon))));
        const Vec3<Real> intensity =
            surfaceIntensity(inputs, in, out, layer.triangle, layer.barycentric, layer.pixel, scratch, counts);
        const std::size_t at = c.count.offset(layer.pixel - tile.min);
        c.added.pixels[at] = a * intensity + (1 - a) * c.added.pixels[at];
        c.left.pixels[at] = (1 - a) * c.left.pixels[at];
        ++c.count.pixels[at];
    }
    return c;
}

template <class Real>
void layOver(const ShadingInputs& inputs, const Composed<Real>& c, ShadingOutput<Real>& out) {
    auto& intensities = out.vectors[index(BufferId::Intensity)][0];
    auto& added = out.vectors[index(BufferId::Translucent)];
    auto& left = out.scalars[index(BufferId::Transmittance)];
    for (int y = 0; y < c.count.size.y; ++y)
        for (int x = 0; x < c.count.size.x; ++x) {
            const std::size_t from = c.count.offset({x, y});
            if (c.count.pixels[from] == 0) continue;
            const std::size_t at = intensities.offset(c.origin + glm::ivec2(x, y));
            Vec3<Real>& intensity = intensities.pixels[at];
            intensity = c.left.pixels[from] * intensity + c.added.pixels[from];
            out.color.pixels[at] = frameBufferValue(Vec3d(intensity), out.iMax, inputs.planted);
            if (!added.empty()) added[0].pixels[at] = c.added.pixels[from];
            if (!left.empty()) left[0].pixels[at] = c.left.pixels[from];
            if (!out.layers.empty()) out.layers.pixels[at] = c.count.pixels[from];
        }
}

template <class Real>
void drawTile(const ShadingInputs& inputs, const ShadingSources<Real>& in, const LayerBins<Real>& layers,
              std::span<const std::uint32_t> order, Tile tile, ShadingOutput<Real>& out, std::size_t limit,
              ShadingCounts& counts) {
    const glm::ivec2 size = tile.max - tile.min;
    const bool single = size.x * size.y == 1;
    const auto found =
        layersIn(inputs, in, layers, order, tile, single ? std::numeric_limits<std::size_t>::max() : limit);
    if (found) {
        counts.layers += static_cast<long long>(found->size());
        if (!found->empty()) layOver(inputs, compose(inputs, in, tile, *found, out, counts), out);
        return;
    }
    Tile first = tile, second = tile;
    const int axis = size.y > 1 ? 1 : 0;
    first.max[axis] = second.min[axis] = tile.min[axis] + size[axis] / 2;
    drawTile(inputs, in, layers, order, first, out, limit, counts);
    drawTile(inputs, in, layers, order, second, out, limit, counts);
}

}  // namespace

template <class Real>
ShadingCounts drawLayers(const ShadingInputs& inputs, const ShadingSources<Real>& in, const LayerBins<Real>& layers,
                         std::size_t tile, ShadingOutput<Real>& out, std::size_t limit) {
    ShadingCounts counts;
    drawTile<Real>(inputs, in, layers, layers.order[tile], layers.bins.tile(tile), out, limit, counts);
    return counts;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                  \
    template TransformOutput<Real> withoutTransparent(const TransformOutput<Real>&);                                  \
    template LayerBins<Real> binLayers(const ShadingInputs&, const ShadingSources<Real>&);                            \
    template std::optional<std::vector<Layer<Real>>> layersIn(const ShadingInputs&, const ShadingSources<Real>&,      \
                                                              const LayerBins<Real>&, std::span<const std::uint32_t>, \
                                                              Tile, std::size_t);                                     \
    template ShadingCounts drawLayers(const ShadingInputs&, const ShadingSources<Real>&, const LayerBins<Real>&,      \
                                      std::size_t, ShadingOutput<Real>&, std::size_t);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
