#include "pipeline/stages/outlines.h"

#include <algorithm>

namespace pipeline {
namespace {

constexpr Plane kPlanes[kPlaneCount]{Plane::Near, Plane::Far, Plane::Left, Plane::Right, Plane::Top, Plane::Bottom};

// The part of the line from a to b inside all planes; nothing left: false.
template <class W>
bool clipLine(const View& view, std::array<ClipCorner<W>, 2>& ends) {
    for (const Plane plane : kPlanes) {
        const W da = signedDistance(view, plane, ends[0].view, glm::dvec2(kGuardBand));
        const W db = signedDistance(view, plane, ends[1].view, glm::dvec2(kGuardBand));
        if (!(da >= 0) && !(db >= 0)) return false;
        if (da >= 0 && db >= 0) continue;
        const ClipCorner<W> from = ends[da >= 0 ? 0 : 1], to = ends[da >= 0 ? 1 : 0];
        const W inside = da >= 0 ? da : db, outside = da >= 0 ? db : da;
        const W s = inside / (inside - outside);
        ClipCorner<W>& cut = ends[da >= 0 ? 1 : 0];
        cut = {from.view + s * (to.view - from.view), from.weights + s * (to.weights - from.weights)};
        if (plane == Plane::Near) cut.view.z = W(view.near);
        if (plane == Plane::Far) cut.view.z = W(view.far);
    }
    return true;
}

// The triangle of a polygon that has both vertices, and where among its corners they stand. An outline's edge is an edge
// of exactly one of them; a degenerate polygon may say otherwise, then the first triangle stands for it.
struct EdgePlace {
    std::uint32_t triangle;
    int from = 0, to = 1;
};
EdgePlace findEdge(const Topology& topology, std::uint32_t polygon, std::uint32_t from, std::uint32_t to) {
    const auto first = std::uint32_t(topology.firstTriangleOf(polygon));
    for (std::uint32_t t = first; t < first + topology.triangleCountOf(polygon); ++t) {
        const auto& v = topology.triangles[t].vertices;
        const auto a = std::find(std::begin(v), std::end(v), from), b = std::find(std::begin(v), std::end(v), to);
        if (a != std::end(v) && b != std::end(v)) return {t, int(a - v), int(b - v)};
    }
    return {first};
}

std::int64_t floorDivide(std::int64_t a, std::int64_t b) {  // b > 0
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// Calls visit(pixel, t) for the pixels of a line within a tile; t, 0 to 1, is where along it the pixel was taken.
template <class Visit>
void forEachOnLine(const std::array<glm::i64vec2, 2>& ends, Tile tile, Visit visit) {
    const glm::i64vec2 d = ends[1] - ends[0];
    const int major = std::abs(d.x) >= std::abs(d.y) ? 0 : 1, minor = 1 - major;
    const bool turned = d[major] < 0;
    const glm::i64vec2 a = ends[turned ? 1 : 0], b = ends[turned ? 0 : 1];
    const std::int64_t run = b[major] - a[major], rise = b[minor] - a[minor];
    const std::int64_t first = std::max<std::int64_t>(a[major] >> kSubPixelBits, tile.min[major]);
    const std::int64_t last = std::min<std::int64_t>(b[major] >> kSubPixelBits, tile.max[major] - 1);
    for (std::int64_t i = first; i <= last; ++i) {
        const std::int64_t at = std::clamp(i * kSubPixels + kSubPixels / 2, a[major], b[major]) - a[major];
        const std::int64_t across = a[minor] + (run > 0 ? floorDivide(rise * at, run) : 0);
        glm::ivec2 pixel;
        pixel[major] = int(i), pixel[minor] = int(across >> kSubPixelBits);
        if (pixel[minor] < tile.min[minor] || pixel[minor] >= tile.max[minor]) continue;
        const double t = run > 0 ? double(at) / double(run) : 0;
        visit(pixel, turned ? 1 - t : t);
    }
}

}  // namespace

template <class Real>
void addOutline(const TransformOutput<Real>& in, std::uint32_t polygon, std::vector<OutlineEdge<Real>>& edges) {
    using W = AtLeastDouble<Real>;
    const View& view = in.view;
    const Vec2<W> centre(view.centre), scale(view.scale);
    const Topology::Corners corners = in.topology->corners(polygon);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // From the vertex with the smaller number, so that two polygons draw their common edge alike.
        std::uint32_t from = corners[i], to = corners[i + 1 == corners.size() ? 0 : i + 1];
        if (from > to) std::swap(from, to);
        const EdgePlace place = findEdge(*in.topology, polygon, from, to);
        std::array<ClipCorner<W>, 2> ends{ClipCorner<W>{Vec3<W>(in.viewSpace(from)), Vec3<W>(0)},
                                          ClipCorner<W>{Vec3<W>(in.viewSpace(to)), Vec3<W>(0)}};
        ends[0].weights[place.from] = 1, ends[1].weights[place.to] = 1;
        if (!clipLine(view, ends)) continue;
        OutlineEdge<Real> edge{};
        edge.id = place.triangle;
        for (std::size_t k = 0; k < 2; ++k) {
            const Vec3<W> v = ends[k].view;
            const W spread = view.perspective ? v.z : W(1);
            edge.ends[k] =
                snap(Vec2<W>(centre.x + scale.x * v.x / spread, centre.y - scale.y * v.y / spread), view.subPixelBits);
            edge.w[k] = Real(view.perspective ? 1 / v.z : v.z);
            edge.weights[k] = Vec3<Real>(ends[k].weights);
        }
        // The farther end first: in w_0 + t (w_1 - w_0) nothing is then subtracted and lost.
        if (edge.w[0] > edge.w[1]) {
            std::swap(edge.ends[0], edge.ends[1]);
            std::swap(edge.w[0], edge.w[1]);
            std::swap(edge.weights[0], edge.weights[1]);
        }
        edges.push_back(edge);
    }
}

template <class Real>
void binEdges(Tile extent, OutlineBins<Real>& out) {
    for (int y = extent.min.y; y < extent.max.y; y += kTileSize)
        for (int x = extent.min.x; x < extent.max.x; x += kTileSize)
            out.tiles.push_back({{x, y}, glm::min(glm::ivec2(x, y) + kTileSize, extent.max)});
    out.bins.resize(out.tiles.size());
    const int columns = (extent.max.x - extent.min.x + kTileSize - 1) / kTileSize;
    for (std::uint32_t i = 0; i < out.edges.size(); ++i) {
        const auto& ends = out.edges[i].ends;
        const glm::i64vec2 low = glm::min(ends[0], ends[1]) >> std::int64_t(kSubPixelBits);
        const glm::i64vec2 high = glm::max(ends[0], ends[1]) >> std::int64_t(kSubPixelBits);
        const glm::ivec2 a = glm::max(glm::ivec2(low), extent.min), b = glm::min(glm::ivec2(high), extent.max - 1);
        if (a.x > b.x || a.y > b.y) continue;
        const glm::ivec2 from = (a - extent.min) / kTileSize, to = (b - extent.min) / kTileSize;
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) out.bins[std::size_t(y * columns + x)].push_back(i);
    }
}

template <class Real>
void drawOutlines(const View& view, const OutlineBins<Real>& bins, std::size_t tile, ZBufferOutput<Real>& out,
                  std::vector<FragmentRecord>* record) {
    for (const std::uint32_t i : bins.bins[tile]) {
        const OutlineEdge<Real>& edge = bins.edges[i];
        forEachOnLine(edge.ends, bins.tiles[tile], [&](glm::ivec2 pixel, double along) {
            // 1/z is affine along the line in the picture, as over a triangle.
            const Real t = Real(along), w = edge.w[0] + t * (edge.w[1] - edge.w[0]);
            const Real z = view.perspective ? 1 / w : w, b = view.perspective ? t * edge.w[1] * z : t;
            const Fragment<Real> fragment{z, view.perspective ? w : Real(0),
                                          edge.weights[0] + b * (edge.weights[1] - edge.weights[0])};
            const std::size_t at = out.zView->offset(pixel - out.origin);
            if (record) record->push_back({edge.id, pixel, double(z), double(out.zView->pixels[at]), true});
            ++out.overdraw.pixels[at];
            writeFragment(out, at, edge.id, fragment);
        });
    }
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                        \
    template void addOutline(const TransformOutput<Real>&, std::uint32_t, std::vector<OutlineEdge<Real>>&); \
    template void binEdges(Tile, OutlineBins<Real>&);                                                       \
    template void drawOutlines(const View&, const OutlineBins<Real>&, std::size_t, ZBufferOutput<Real>&,    \
                               std::vector<FragmentRecord>*);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
