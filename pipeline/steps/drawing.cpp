#include "pipeline/steps/drawing.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "pipeline/stages/translucent.h"

namespace pipeline {
namespace {

// The half-open ranges of 0 … count − 1 that belong to one polygon each.
template <class Real, class PolygonOf>
void groupByPolygon(std::size_t count, PolygonOf polygonOf, Drawing<Real>& out) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t polygon = polygonOf(i);
        if (out.polygons.empty() || out.polygons.back() != polygon) {
            out.polygons.push_back(polygon);
            out.ranges.push_back({i, i});
        }
        out.ranges.back()[1] = i + 1;
    }
}

// Counts the pixels and rows of the elements, and drops the elements that have none.
template <class Real>
void countPixels(Drawing<Real>& drawing) {
    std::size_t kept = 0;
    std::int64_t pixels = 0, rows = 0;
    for (std::size_t i = 0; i < drawing.ranges.size(); ++i) {
        const std::vector<PixelSpan> spans = spansOf(drawing, i);
        if (spans.empty()) continue;
        for (std::size_t s = 0; s < spans.size(); ++s) {
            pixels += spans[s].length();
            rows += s == 0 || spans[s].y != spans[s - 1].y;
        }
        drawing.ranges[kept] = drawing.ranges[i], drawing.polygons[kept] = drawing.polygons[i], ++kept;
        drawing.pixels.push_back(pixels), drawing.rows.push_back(rows);
    }
    drawing.ranges.resize(kept), drawing.polygons.resize(kept);
}

template <class Real, class Visit>
void forEachPixel(const Drawing<Real>& drawing, std::size_t element, Visit visit) {
    const Tile picture{{0, 0}, drawing.bins.size};
    for (std::uint32_t i = drawing.ranges[element][0]; i < drawing.ranges[element][1]; ++i) {
        const PaintPiece* const piece = drawing.order.pieces.empty() ? nullptr : &drawing.order.pieces[i];
        const SnappedTriangle& triangle = drawing.bins.triangles[piece ? piece->triangle : i].snapped;
        forEachCovered(triangle, picture, [&](glm::ivec2 pixel, const auto&) {
            if (!piece || drawing.order.has(*piece, pixel)) visit(pixel);
        });
    }
}

// Draws into the pixels of a tile. They are inside one of the stage's own tiles, or `indices` is the list of one
// element.
// lists but an element's.
template <class Real>
void drawInto(const FrameData<Real>& data, const Drawing<Real>& drawing, std::span<const std::uint32_t> indices,
              Tile tile, ZBufferOutput<Real>& out, std::vector<FragmentRecord>* record = nullptr) {
    const TransformOutput<Real>& in = *data.transform;
    if (data.keys.zBuffer.visibility == Visibility::Painter)
        paint<Real>(in.view, drawing.bins, drawing.order, indices, tile, out, record);
    else
        zBuffer<Real>(in.view, in.depthFormat, drawing.bins, indices, tile, out, record);
}

template <class Real>
ZBufferOutput<Real> outlinesSoFar(const FrameData<Real>& data, const Drawing<Real>& drawing, std::uint32_t edges,
                                  Threads& threads) {
    const View& view = data.transform->view;
    ZBufferOutput<Real> out = prepareZBuffer<Real>({{0, 0}, view.size}, DepthFormat::Linear);
    OutlineBins<Real> bins = drawing.outlines;
    for (std::vector<std::uint32_t>& bin : bins.bins) {
        bin.erase(std::ranges::lower_bound(bin, edges), bin.end());
        out.tileIsDrawn.push_back(!bin.empty());
    }
    threads.forRange(bins.tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) drawOutlines(view, bins, tile, out);
    });
    return out;
}

}  // namespace

template <class Real>
Drawing<Real> takeApart(const FrameData<Real>& data) {
    const TransformOutput<Real>& in = *data.transform;
    const ZBufferInputs& inputs = data.keys.zBuffer;
    Drawing<Real> out;
    if (inputs.visibility == Visibility::None) {
        out.outlines = binOutlines<Real>(in, {{0, 0}, in.view.size},
                                         [&](std::uint32_t polygon) { return data.hasOutline(polygon); });
        groupByPolygon(
            out.outlines.edges.size(),
            [&](std::uint32_t i) { return in.topology->polygonOf(out.outlines.edges[i].id); }, out);
        return out;
    }
    std::span<const std::uint8_t> marks;
    if (data.cull && !inputs.parts[Part::Clipping]) marks = data.cull->marks;
    out.bins =
        binTriangles<Real>(*in.topology, in.view, in.world, data.verdicts(), marks,
                           drawnIn(Pass::Opaque, *in.topology, in.transparent, inputs.translucent, data.cull.get()));
    const auto polygonOf = [&](std::uint32_t triangle) {
        return in.topology->polygonOf(out.bins.triangles[triangle].id);
    };
    if (inputs.visibility == Visibility::Painter) {
        out.order = paintingOrder<Real>(*in.topology, in.view, in.world, out.bins, inputs.split);
        out.tiles = binPieces(out.bins, out.order);
        groupByPolygon(
            out.order.pieces.size(), [&](std::uint32_t i) { return polygonOf(out.order.pieces[i].triangle); }, out);
    } else {
        out.tiles = std::move(out.bins.bins);
        groupByPolygon(out.bins.triangles.size(), polygonOf, out);
    }
    countPixels(out);
    return out;
}

template <class Real>
std::vector<PixelSpan> spansOf(const Drawing<Real>& drawing, std::size_t element) {
    std::vector<PixelSpan> spans;
    forEachPixel(drawing, element, [&](glm::ivec2 pixel) {
        if (!spans.empty() && spans.back().y == pixel.y && spans.back().last + 1 == pixel.x)
            ++spans.back().last;
        else
            spans.push_back({pixel.y, pixel.x, pixel.x});
    });
    const auto before = [](const PixelSpan& a, const PixelSpan& b) {
        return a.y != b.y ? a.y < b.y : a.first < b.first;
    };
    std::ranges::sort(spans, before);
    // Triangles of a fan that touch or overlap become one span.
    std::size_t kept = 0;
    for (std::size_t i = 1; i < spans.size(); ++i) {
        PixelSpan& last = spans[kept];
        if (spans[i].y == last.y && spans[i].first <= last.last + 1)
            last.last = std::max(last.last, spans[i].last);
        else
            spans[++kept] = spans[i];
    }
    if (!spans.empty()) spans.resize(kept + 1);
    return spans;
}

template <class Real>
ZBufferOutput<Real> drawnSoFar(const FrameData<Real>& data, const Drawing<Real>& drawing, std::size_t elements,
                               Reach reach, Threads& threads) {
    const bool all = elements == drawing.ranges.size();
    if (data.keys.zBuffer.visibility == Visibility::None)
        return outlinesSoFar(data, drawing, all ? ~0u : drawing.ranges[elements][0], threads);
    const TransformOutput<Real>& in = *data.transform;
    ZBufferOutput<Real> out = prepareZBuffer<Real>({{0, 0}, in.view.size}, in.depthFormat, data.keys.zBuffer.planted);
    out.tileIsDrawn.resize(drawing.tiles.size());
    const std::uint32_t before = all ? ~0u : drawing.ranges[elements][0];
    threads.forRange(drawing.tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) {
            const std::vector<std::uint32_t>& list = drawing.tiles[tile];
            const auto count = std::size_t(std::ranges::lower_bound(list, before) - list.begin());
            out.tileIsDrawn[tile] = count > 0;
            drawInto<Real>(data, drawing, {list.data(), count}, drawing.bins.tile(tile), out);
        }
    });
    if (all || (reach.row == 0 && reach.x == 0)) return out;
    std::vector<std::uint32_t> indices(drawing.ranges[elements][1] - before);
    std::iota(indices.begin(), indices.end(), before);
    drawInto<Real>(data, drawing, indices, {{0, 0}, {in.view.size.x, reach.row}}, out);
    drawInto<Real>(data, drawing, indices, {{0, reach.row}, {reach.x, reach.row + 1}}, out);
    for (std::size_t tile = 0; tile < drawing.tiles.size(); ++tile)
        out.tileIsDrawn[tile] |= std::ranges::binary_search(drawing.tiles[tile], before);
    return out;
}

template <class Real>
PixelFragments fragmentsAt(const FrameData<Real>& data, const Drawing<Real>& drawing, std::size_t element,
                           glm::ivec2 pixel) {
    const glm::ivec2 tile = pixel / kTileSize;
    const std::size_t at = std::size_t(tile.y) * std::size_t(drawing.bins.tiles.x) + std::size_t(tile.x);
    const std::vector<std::uint32_t>& list = drawing.tiles[at];
    const auto [first, end] = drawing.ranges[element];
    const auto before = std::size_t(std::ranges::lower_bound(list, first) - list.begin());
    const auto own = std::size_t(std::ranges::lower_bound(list, end) - list.begin());
    const Tile alone{pixel, pixel + 1};
    ZBufferOutput<Real> scratch = prepareZBuffer<Real>(alone, data.transform->depthFormat, data.keys.zBuffer.planted);
    PixelFragments fragments;
    drawInto<Real>(data, drawing, {list.data(), before}, alone, scratch, &fragments.before);
    drawInto<Real>(data, drawing, {list.data() + before, own - before}, alone, scratch, &fragments.own);
    return fragments;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                            \
    template Drawing<Real> takeApart(const FrameData<Real>&);                                                   \
    template std::vector<PixelSpan> spansOf(const Drawing<Real>&, std::size_t);                                 \
    template PixelFragments fragmentsAt(const FrameData<Real>&, const Drawing<Real>&, std::size_t, glm::ivec2); \
    template ZBufferOutput<Real> drawnSoFar(const FrameData<Real>&, const Drawing<Real>&, std::size_t, Reach, Threads&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
