#include "pipeline/fast/rasterize.h"

#include <cmath>

#include "pipeline/fast/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fast/rasterize.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// A number a pixel: edge functions in double, what is interpolated in float, as many as there are doubles in a vector.
using D = hn::ScalableTag<double>;
using F = hn::Rebind<float, D>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;

// Below this double holds every whole number.
constexpr double kWhole = 9007199254740992.0;

// Corners stand on a grid, and pixels' centres on one of half pixels: the edge functions of a triangle are multiples of
// the square of the finer step, and double holds as many of these.
double exactBelow(const SnappedTriangle& t) {
    std::int64_t bits = kSubPixels / 2;
    for (const glm::i64vec2& corner : t.corners) bits |= corner.x | corner.y;
    const auto step = double(bits & -bits);
    return kWhole * step * step;
}

// The edge functions of a triangle at the first pixel of its box in a tile, and their steps to the next column and row.
// covers: at least the bias, where all three are inside.
struct Edges {
    glm::ivec2 min, max;
    double value[3], column[3], row[3], bias[3];
    bool exact = true;  // double holds all of them in the box

    Edges(const SnappedTriangle& t, Tile tile) {
        const Tile box = t.pixels();
        min = glm::max(tile.min, box.min), max = glm::min(tile.max, box.max);
        const EdgeFunction edges[3]{
            {t.corners[1], t.corners[2]}, {t.corners[2], t.corners[0]}, {t.corners[0], t.corners[1]}};
        const double limit = exactBelow(t);
        for (int i = 0; i < 3; ++i) {
            value[i] = double(edges[i].atPixel(min));
            column[i] = -double(edges[i].dy) * double(kSubPixels), row[i] = double(edges[i].dx) * double(kSubPixels);
            bias[i] = edges[i].ownsBoundary() ? 0 : 1;
            const double most = std::abs(value[i]) + std::abs(column[i]) * std::max(0, max.x - min.x) +
                                std::abs(row[i]) * std::max(0, max.y - min.y);
            exact = exact && most < limit;
        }
    }
};

// Calls visit(x, y, inside, e1, e2) with the pixels [x, x + lanes) of a row of the tile, for all that the triangle
// covers; the edge functions opposite to corners 1 and 2 as floats.
template <class Visit>
HWY_INLINE void forEachCoveredVector(const Edges& edges, Tile tile, Visit visit) {
    const D d;
    const F f;
    const int lanes = int(hn::Lanes(d));
    for (int y = edges.min.y; y < edges.max.y; ++y) {
        const double down = y - edges.min.y;
        for (int x = edges.min.x; x < edges.max.x; x += lanes) {
            // Within the tile: its neighbours' pixels are another thread's.
            const int at = std::min(x, tile.max.x - lanes);
            const auto along = hn::Iota(d, double(at - edges.min.x));
            const auto edge = [&](int i) HWY_ATTR {
                return hn::Add(hn::Set(d, edges.value[i] + down * edges.row[i]),
                               hn::Mul(along, hn::Set(d, edges.column[i])));
            };
            const auto e0 = edge(0), e1 = edge(1), e2 = edge(2);
            const auto least =
                hn::Min(hn::Sub(e0, hn::Set(d, edges.bias[0])),
                        hn::Min(hn::Sub(e1, hn::Set(d, edges.bias[1])), hn::Sub(e2, hn::Set(d, edges.bias[2]))));
            const auto column = hn::Iota(f, float(at - x));  // those left of x have been visited
            const auto visited =
                hn::Or(hn::Lt(column, hn::Zero(f)), hn::Ge(column, hn::Set(f, float(edges.max.x - x))));
            const auto inside = hn::AndNot(visited, hn::Ge(hn::DemoteTo(f, least), hn::Zero(f)));
            if (hn::AllFalse(f, inside)) continue;
            visit(at, y, inside, hn::DemoteTo(f, e1), hn::DemoteTo(f, e2));
        }
    }
}

// interpolate's formulas, in its order.
struct Planes {
    hn::Vec<F> inverseArea2, w0, w1, w2, toW1, toW2;
    explicit Planes(const RasterTriangle<float>& t)
        : inverseArea2(hn::Set(F(), t.inverseArea2)),
          w0(hn::Set(F(), t.w[0])),
          w1(hn::Set(F(), t.w[1])),
          w2(hn::Set(F(), t.w[2])),
          toW1(hn::Set(F(), t.w[1] - t.w[0])),
          toW2(hn::Set(F(), t.w[2] - t.w[0])) {}
    HWY_INLINE hn::Vec<F> z(hn::Vec<F> l1, hn::Vec<F> l2, bool perspective) const {
        const auto w = hn::Add(hn::Add(w0, hn::Mul(l1, toW1)), hn::Mul(l2, toW2));
        return perspective ? hn::Div(hn::Set(F(), 1.0F), w) : w;
    }
};

}  // namespace

void drawTile(const View& view, const TriangleBins<float>& bins, std::size_t index, ZBufferOutput<float>& out) {
    const Tile tile = bins.tile(index);
    const F f;
    const I whole;
    const U unsign;
    const bool narrow = tile.max.x - tile.min.x < int(hn::Lanes(f));
    for (const std::uint32_t& i : bins.bins[index]) {
        const RasterTriangle<float>& triangle = bins.triangles[i];
        const Edges edges(triangle.snapped, tile);
        if (narrow || !edges.exact) {
            zBuffer(view, DepthFormat::Linear, bins, std::span(&i, 1), tile, out);
            continue;
        }
        const Planes planes(triangle);
        forEachCoveredVector(edges, tile, [&](int x, int y, auto inside, auto e1, auto e2) HWY_ATTR {
            const std::size_t at = out.zView.offset({x, y});
            const auto l1 = hn::Mul(e1, planes.inverseArea2), l2 = hn::Mul(e2, planes.inverseArea2);
            const auto z = planes.z(l1, l2, view.perspective);
            const auto stored = hn::LoadU(f, &out.zView.pixels[at]);
            const auto won = hn::And(inside, hn::Lt(z, stored));
            const auto count = [&](std::vector<std::int32_t>& counts, auto mask) HWY_ATTR {
                const auto one = hn::IfThenElseZero(hn::RebindMask(whole, mask), hn::Set(whole, 1));
                hn::StoreU(hn::Add(hn::LoadU(whole, &counts[at]), one), whole, &counts[at]);
            };
            count(out.overdraw.pixels, inside);
            if (hn::AllFalse(f, won)) return;
            count(out.depthWrites.pixels, won);
            hn::StoreU(hn::IfThenElse(won, z, stored), f, &out.zView.pixels[at]);
            std::uint32_t* ids = &out.triangle.pixels[at];
            hn::StoreU(
                hn::IfThenElse(hn::RebindMask(unsign, won), hn::Set(unsign, triangle.id), hn::LoadU(unsign, ids)),
                unsign, ids);
            const auto b1 = view.perspective ? hn::Mul(hn::Mul(l1, planes.w1), z) : l1;
            const auto b2 = view.perspective ? hn::Mul(hn::Mul(l2, planes.w2), z) : l2;
            const auto weight = [&](int c, auto before) HWY_ATTR {
                const auto& w = triangle.weights;
                const auto sum = hn::Add(hn::Add(hn::Set(f, w[0][c]), hn::Mul(b1, hn::Set(f, w[1][c] - w[0][c]))),
                                         hn::Mul(b2, hn::Set(f, w[2][c] - w[0][c])));
                return hn::IfThenElse(won, sum, before);
            };
            float* weights = &out.barycentric.pixels[at].x;
            auto bx = hn::Zero(f), by = bx, bz = bx;
            hn::LoadInterleaved3(f, weights, bx, by, bz);
            hn::StoreInterleaved3(weight(0, bx), weight(1, by), weight(2, bz), f, weights);
        });
    }
}

void drawShadowTile(const View& face, const TriangleBins<float>& bins, std::size_t index, Buffer2D<float>& depth) {
    const Tile tile = bins.tile(index);
    const F f;
    const bool narrow = tile.max.x - tile.min.x < int(hn::Lanes(f));
    for (const std::uint32_t i : bins.bins[index]) {
        const RasterTriangle<float>& triangle = bins.triangles[i];
        const Edges edges(triangle.snapped, tile);
        if (narrow || !edges.exact) {
            forEachCovered(triangle.snapped, tile, [&](glm::ivec2 texel, const std::array<std::int64_t, 3>& e) {
                float& stored = depth.at(texel);
                stored = std::min(stored, interpolate(triangle, e, face.perspective).z);
            });
            continue;
        }
        const Planes planes(triangle);
        forEachCoveredVector(edges, tile, [&](int x, int y, auto inside, auto e1, auto e2) HWY_ATTR {
            float* at = &depth.pixels[depth.offset({x, y})];
            const auto z =
                planes.z(hn::Mul(e1, planes.inverseArea2), hn::Mul(e2, planes.inverseArea2), face.perspective);
            const auto stored = hn::LoadU(f, at);
            hn::StoreU(hn::IfThenElse(hn::And(inside, hn::Lt(z, stored)), z, stored), f, at);
        });
    }
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(drawTile);
HWY_EXPORT(drawShadowTile);

void zBufferInVectors(const View& view, const TriangleBins<float>& bins, std::size_t tile, ZBufferOutput<float>& out) {
    HWY_DYNAMIC_DISPATCH(drawTile)(view, bins, tile, out);
}

void shadowBufferInVectors(const View& face, const TriangleBins<float>& bins, std::size_t tile,
                           Buffer2D<float>& depth) {
    HWY_DYNAMIC_DISPATCH(drawShadowTile)(face, bins, tile, depth);
}

}  // namespace pipeline
#endif
