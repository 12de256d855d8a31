#include "pipeline/stages/translucent.h"

#include <algorithm>

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

namespace {

// The layers of each pixel side by side, in the order in which they were found; sorts: the farthest first.
template <class Real>
std::vector<Layer<Real>> pixelByPixel(const std::vector<Layer<Real>>& found, Tile tile, bool sorts) {
    const glm::ivec2 size = tile.max - tile.min;
    const auto placeIn = [&](const Layer<Real>& layer) {
        const glm::ivec2 at = layer.pixel - tile.min;
        return std::size_t(at.y) * std::size_t(size.x) + std::size_t(at.x);
    };
    // The end of each pixel's layers, then, as they are put there, their beginning.
    std::vector<std::uint32_t> ends(std::size_t(size.x) * std::size_t(size.y), 0);
    for (const Layer<Real>& layer : found) ++ends[placeIn(layer)];
    for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
    std::vector<Layer<Real>> ordered(found.size());
    for (std::size_t i = found.size(); i > 0; --i) ordered[--ends[placeIn(found[i - 1])]] = found[i - 1];
    if (!sorts) return ordered;
    const auto isFarther = [](const Layer<Real>& a, const Layer<Real>& b) { return a.depth > b.depth; };
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const auto end = i + 1 < ends.size() ? ends[i + 1] : ordered.size();
        if (end - ends[i] > 1) std::ranges::stable_sort(std::span(ordered).subspan(ends[i], end - ends[i]), isFarther);
    }
    return ordered;
}

}  // namespace

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
    found = pixelByPixel(found, tile, layers.sorts);
    if (inputs.planted) spoilLayers(inputs.planted, found);
    return found;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                  \
    template TransformOutput<Real> withoutTransparent(const TransformOutput<Real>&);                                  \
    template LayerBins<Real> binLayers(const ShadingInputs&, const ShadingSources<Real>&);                            \
    template std::optional<std::vector<Layer<Real>>> layersIn(const ShadingInputs&, const ShadingSources<Real>&,      \
                                                              const LayerBins<Real>&, std::span<const std::uint32_t>, \
                                                              Tile, std::size_t);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
