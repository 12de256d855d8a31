// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SEEN_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SEEN_H
#undef SHADESCOPE_SEEN_H
#else
#define SHADESCOPE_SEEN_H
#endif

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "pipeline/simd/blocks.h"
#include "pipeline/stages/z_buffer.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// In which pixels of a vector something is seen.
HWY_INLINE Mask seenIn(const std::uint32_t* records) {
    return hn::RebindMask(F(), hn::Ne(hn::Load(U(), records), hn::Set(U(), kNoTriangle)));
}

// And in which of them this triangle is.
HWY_INLINE Mask seesIn(const std::uint32_t* records, std::uint32_t record) {
    return hn::RebindMask(F(), hn::Eq(hn::Load(U(), records), hn::Set(U(), record)));
}

// The share of corners 1 and 2 in a pixel.
struct Shares {
    Floats one, two;
};

// What the triangles that are seen in a tile are found in.
struct SeenIn {
    const View& view;
    const TrianglePieces& pieces;
    Tile tile;
};

// A triangle that is seen in a tile, for any vector of it.
class SeenTriangle {
public:
    HWY_NOINLINE void become(const SeenIn& in, std::uint32_t record) {
        const TrianglePiece& piece = in.pieces.pieceOf(record);
        const std::uint32_t i = record & TrianglePieces::kIndex;
        if (record & TrianglePiece::kOther) return becomeOther(in, piece.others[i]);
        const SmallTriangle& t = piece.small[i];
        m_small = &t, m_id = t.id;
        m_w[0] = t.w0, m_w[1] = t.w1, m_w[2] = t.w2;
        for (std::size_t corner = 0; corner < 3; ++corner) m_order[corner] = t.corner(int(corner));
        const int x = in.tile.min.x - t.x, y = in.tile.min.y - t.y;
        // From the box's first pixel to the tile's.
        const auto edge = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
            PixelFunction e{c, a, b};
            e.value = e.atPixel(x, y);
            return e;
        };
        m_edges[0] = edge(t.a1, t.b1, t.c1), m_edges[1] = edge(t.a2, t.b2, t.c2);
    }
    std::uint32_t id() const { return m_id; }  // index into Topology::triangles
    // Else it is so large that weights() is all that is known of it.
    bool isLinear() const { return m_small || m_other->middle; }
    float w(std::size_t corner) const { return m_w[corner]; }
    // A quantity of the triangle's own corners at one of the corners that are drawn, which clipping may have made.
    Vec3<float> atCorner(const std::vector<Vec3<float>>& values, const std::uint32_t (&v)[3],
                         std::size_t corner) const {
        if (m_order[corner] < 3) return values[v[m_order[corner]]];
        const Vec3<float>& share = m_other->triangle->weights[corner];
        return share.x * values[v[0]] + share.y * values[v[1]] + share.z * values[v[2]];
    }
    // Its first pixel in the tile.
    glm::ivec2 firstPixel(Tile tile) const {
        const glm::ivec2 first = m_small ? glm::ivec2(m_small->x, m_small->y) : m_other->triangle->snapped.pixels().min;
        return glm::max(first - tile.min, 0);
    }

    // The shares of corners 1 and 2, linear in the picture.
    HWY_INLINE Shares linear(const VectorPlace& place) const {
        if (!m_small) return {m_other->middle->linear(1, place), m_other->middle->linear(2, place)};
        const Floats inverse = all(m_small->inverseArea2);
        const auto share = [&](const PixelFunction& edge)
                               HWY_ATTR { return hn::Mul(hn::ConvertTo(F(), edge.in(place)), inverse); };
        return {share(m_edges[0]), share(m_edges[1])};
    }
    Slope slope(int corner, glm::ivec2 first) const {
        if (!m_small) return m_other->middle->slope(corner, first);
        const PixelFunction& edge = m_edges[corner - 1];
        const float inverse = m_small->inverseArea2;
        return {float(edge.atPixel(first.x, first.y)) * inverse, float(edge.column) * inverse,
                float(edge.row) * inverse};
    }
    // Perspective-correct weights over the triangle's own corners, the bits of interpolate; where the triangle is not,
    // any numbers.
    HWY_INLINE Floats3 weights(const SeenIn& in, const VectorPlace& place) const {
        if (!isLinear()) return weightsOfHuge(in, place);
        const Shares b = corrected(in.view, linear(place));
        const Floats b0 = hn::Sub(hn::Sub(all(1), b.one), b.two);
        if (m_order[0] > 2) return ofCut(b);
        const auto of = [&](int own) HWY_ATTR {
            const Ints wanted = hn::Set(I(), own);
            const Mask first = asFloats(hn::Eq(wanted, hn::Set(I(), m_order[0])));
            const Mask second = asFloats(hn::Eq(wanted, hn::Set(I(), m_order[1])));
            return hn::IfThenElse(first, b0, hn::IfThenElse(second, b.one, b.two));
        };
        return {of(0), of(1), of(2)};
    }

private:
    // b1 and b2 of interpolate.
    HWY_INLINE Shares corrected(const View& view, Shares l) const {
        if (!view.perspective) return l;
        const Floats z = Distances(m_w[0], m_w[1], m_w[2]).z<true>(l.one, l.two);
        return {hn::Mul(hn::Mul(l.one, all(m_w[1])), z), hn::Mul(hn::Mul(l.two, all(m_w[2])), z)};
    }
    // Of a piece that clipping left: its corners are not the triangle's own.
    Floats3 ofCut(Shares b) const {
        const auto& w = m_other->triangle->weights;
        const auto weight = [&](int c) HWY_ATTR {
            return hn::Add(hn::Add(all(w[0][c]), hn::Mul(b.one, all(w[1][c] - w[0][c]))),
                           hn::Mul(b.two, all(w[2][c] - w[0][c])));
        };
        return {weight(0), weight(1), weight(2)};
    }
    Floats3 weightsOfHuge(const SeenIn& in, const VectorPlace& place) const {
        if (m_other->large->exact()) {
            const EdgesAt edges = m_other->large->at(m_other->large->from(place));
            return ofCut(corrected(in.view, {edges.l1, edges.l2}));
        }
        const auto& c = m_other->triangle->snapped.corners;
        const EdgeFunction edges[3]{{c[1], c[2]}, {c[2], c[0]}, {c[0], c[1]}};
        HWY_ALIGN float of[3][16];
        for (std::size_t l = 0; l < hn::Lanes(F()); ++l) {
            const glm::ivec2 pixel = in.tile.min + pixelOf(place.at + l);
            const std::array<std::int64_t, 3> e{edges[0].atPixel(pixel), edges[1].atPixel(pixel),
                                                edges[2].atPixel(pixel)};
            const Vec3<float> weights = interpolate(*m_other->triangle, e, in.view.perspective).barycentric;
            for (int i = 0; i < 3; ++i) of[i][l] = weights[i];
        }
        return {hn::Load(F(), of[0]), hn::Load(F(), of[1]), hn::Load(F(), of[2])};
    }
    void becomeOther(const SeenIn& in, const RasterTriangle<float>& t) {
        if (!m_other) m_other = std::make_unique<Other>();
        m_small = nullptr, m_id = t.id, m_other->triangle = &t;
        m_other->middle = MiddleEdges(t, in.tile, in.view.subPixelBits);
        if (!m_other->middle->fits()) m_other->middle.reset(), m_other->large = LargeEdges(t, in.tile);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            m_w[corner] = t.w[corner];
            m_order[corner] = kCut;
            for (int own = 0; own < 3; ++own)
                if (t.weights[corner][own] == 1) m_order[corner] = own;
        }
        const bool cut = std::ranges::count(m_order, kCut) > 0;
        if (cut) std::ranges::fill(m_order, kCut);
    }

    static constexpr int kCut = 3;
    // What is known of one that is not small.
    struct Other {
        const RasterTriangle<float>* triangle;
        std::optional<MiddleEdges> middle;
        std::optional<LargeEdges> large;  // where `middle` does not fit
    };
    std::uint32_t m_id;
    float m_w[3];
    std::array<int, 3> m_order;      // which of the triangle's own corners each is, or kCut for all
    const SmallTriangle* m_small;    // null where it is not one
    PixelFunction m_edges[2];        // a small triangle's edge functions 1 and 2
    std::unique_ptr<Other> m_other;  // kept for the next one
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
