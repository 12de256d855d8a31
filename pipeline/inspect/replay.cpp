#include "pipeline/inspect/replay.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "pipeline/stages/outlines.h"
#include "pipeline/stages/painter.h"

namespace pipeline {
namespace {

// Whether a triangle may cover a pixel of the tile: not where all its corners stand clearly on one side of it. A corner
// that is not in front of the near plane has no place on the screen; snapping moves one by half a pixel at most. Places
// are compared times z_view, which takes no division.
template <class Real>
bool mayCover(const TransformOutput<Real>& in, std::span<const std::uint32_t, 3> v, Tile tile) {
    const View& view = in.view;
    const Vec2<Real> scale(view.scale), low(glm::dvec2(tile.min - 1) - view.centre),
        high(glm::dvec2(tile.max + 1) - view.centre);
    glm::bvec4 beside(true);  // left, right, above, below
    for (const std::uint32_t i : v) {
        const Vec3<Real> p = in.viewSpace(i);
        if (view.perspective && !(p.z >= Real(view.near))) return true;
        const Real spread = view.perspective ? p.z : Real(1), x = scale.x * p.x, y = -scale.y * p.y;
        beside.x = beside.x && x < low.x * spread, beside.y = beside.y && x > high.x * spread;
        beside.z = beside.z && y < low.y * spread, beside.w = beside.w && y > high.y * spread;
    }
    return !glm::any(beside);
}

// The pieces of the scene's triangles for which keep(polygon) holds and that cover a pixel of the tile.
template <class Real, class Keep>
TriangleBins<Real> piecesAt(const FrameData<Real>& data, Tile tile, const Stop& stop, Keep keep) {
    const TransformOutput<Real>& in = *data.transform;
    TriangleBins<Real> pieces;
    for (std::size_t t = 0; t < in.topology->triangles.size() && !stop.stop_requested(); ++t) {
        const auto& v = in.topology->triangles[t].vertices;
        if (!mayCover(in, v, tile) || !keep(in.topology->polygonOf(t))) continue;
        setUpTriangle<Real>(in.view, {in.viewSpace(v[0]), in.viewSpace(v[1]), in.viewSpace(v[2])}, std::uint32_t(t),
                            [&](const RasterTriangle<Real>& piece) {
                                bool covers = false;
                                forEachCovered(piece.snapped, tile, [&](glm::ivec2, const auto&) { covers = true; });
                                if (covers) pieces.triangles.push_back(piece);
                            });
    }
    return pieces;
}

template <class Real>
std::vector<std::uint8_t> opaquePolygons(const FrameData<Real>& data) {
    const TransformOutput<Real>& in = *data.transform;
    return drawnIn(Pass::Opaque, *in.topology, in.transparent, data.keys.zBuffer.translucent, data.cull.get());
}

// The order is a matter of all triangles, not only of those that cover the pixel.
template <class Real>
std::vector<FragmentRecord> replayPainter(const FrameData<Real>& data, Tile tile, const Stop& stop) {
    const TransformOutput<Real>& in = *data.transform;
    const TriangleBins<Real> bins =
        binTriangles<Real>(*in.topology, in.view, in.world, data.verdicts(), {}, opaquePolygons(data));
    const PaintingOrder order =
        paintingOrder<Real>(*in.topology, in.view, in.world, bins, data.keys.zBuffer.split, stop);
    if (stop.stop_requested()) return {};
    std::vector<std::uint32_t> pieces(order.pieces.size());
    std::iota(pieces.begin(), pieces.end(), 0u);
    ZBufferOutput<Real> scratch = prepareZBuffer<Real>(tile, in.depthFormat, data.keys.zBuffer.planted);
    std::vector<FragmentRecord> record;
    paint<Real>(in.view, bins, order, pieces, tile, scratch, &record);
    return record;
}

template <class Real, class Draws>
std::vector<FragmentRecord> replayOutlines(const FrameData<Real>& data, Tile tile, Draws draws) {
    const OutlineBins<Real> bins = binOutlines<Real>(*data.transform, tile, draws);
    ZBufferOutput<Real> scratch = prepareZBuffer<Real>(tile, DepthFormat::Linear);
    std::vector<FragmentRecord> record;
    drawOutlines(data.transform->view, bins, 0, scratch, &record);
    return record;
}

}  // namespace

template <class Real>
std::vector<FragmentRecord> replayTile(const FrameData<Real>& data, Tile tile, const Stop& stop) {
    const RawVector<Verdict>& verdicts = data.verdicts();
    if (data.keys.zBuffer.visibility == Visibility::Painter) return replayPainter(data, tile, stop);
    if (data.keys.zBuffer.visibility == Visibility::None)
        return replayOutlines(data, tile, [&](std::uint32_t polygon) { return data.hasOutline(polygon); });
    const std::vector<std::uint8_t> drawn = opaquePolygons(data);
    const TriangleBins<Real> pieces = piecesAt(data, tile, stop, [&](std::uint32_t polygon) {
        return (verdicts.empty() || goesOn(verdicts[polygon])) && (drawn.empty() || drawn[polygon]);
    });
    std::vector<std::uint32_t> order(pieces.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    const DepthFormat format = data.transform->depthFormat;
    ZBufferOutput<Real> scratch = prepareZBuffer<Real>(tile, format, data.keys.zBuffer.planted);
    std::vector<FragmentRecord> record;
    zBuffer<Real>(data.transform->view, format, pieces, order, tile, scratch, &record);
    return record;
}

template <class Real>
std::vector<FragmentRecord> replayPixel(const FrameData<Real>& data, glm::ivec2 pixel, const Stop& stop) {
    return replayTile(data, {pixel, pixel + 1}, stop);
}

template <class Real>
std::vector<Layer<Real>> replayLayers(const FrameData<Real>& data, glm::ivec2 pixel) {
    const ShadingInputs& inputs = data.keys.shading;
    if (!data.shading || !inputs.layers.drawn) return {};
    const LayerBins<Real> layers = binLayers(inputs, data.shadingSources());
    const glm::ivec2 tile = pixel / kTileSize;
    const std::size_t i = std::size_t(tile.y) * std::size_t(layers.bins.tiles.x) + std::size_t(tile.x);
    return *layersIn<Real>(inputs, data.shadingSources(), layers, layers.order[i], {pixel, pixel + 1},
                           std::numeric_limits<std::size_t>::max());
}

template <class Real>
std::vector<std::uint32_t> culledAt(const FrameData<Real>& data, glm::ivec2 pixel, const Stop& stop) {
    const RawVector<Verdict>& verdicts = data.verdicts();
    if (verdicts.empty()) return {};
    const Tile tile{pixel, pixel + 1};
    std::vector<std::uint32_t> polygons;
    const auto add = [&](std::uint32_t triangle) { polygons.push_back(data.transform->topology->polygonOf(triangle)); };
    if (data.keys.zBuffer.visibility == Visibility::None) {
        const auto dropped = [&](std::uint32_t polygon) { return !data.hasOutline(polygon); };
        for (const FragmentRecord& fragment : replayOutlines(data, tile, dropped)) add(fragment.triangle);
    } else {
        const TriangleBins<Real> pieces =
            piecesAt(data, tile, stop, [&](std::uint32_t polygon) { return !goesOn(verdicts[polygon]); });
        for (const RasterTriangle<Real>& piece : pieces.triangles) add(piece.id);
    }
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    return polygons;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                   \
    template std::vector<FragmentRecord> replayTile(const FrameData<Real>&, Tile, const Stop&);        \
    template std::vector<FragmentRecord> replayPixel(const FrameData<Real>&, glm::ivec2, const Stop&); \
    template std::vector<Layer<Real>> replayLayers(const FrameData<Real>&, glm::ivec2);                \
    template std::vector<std::uint32_t> culledAt(const FrameData<Real>&, glm::ivec2, const Stop&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
