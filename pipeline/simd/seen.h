// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SEEN_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SEEN_H
#undef SHADESCOPE_SEEN_H
#else
#define SHADESCOPE_SEEN_H
#endif

#include <algorithm>
#include <array>

#include "pipeline/simd/blocks.h"
#include "pipeline/stages/z_buffer.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// In which pixels of a vector something is seen.
HWY_INLINE Mask seenIn(const std::uint32_t* records) {
    return hn::RebindMask(F(), hn::Ne(hn::Load(U(), records), hn::Set(U(), kNoTriangle)));
}

// The share of corners 1 and 2 in a pixel.
struct Shares {
    Floats one, two;
};

// A triangle that is seen in a tile, for any vector of it. Neighbours mostly see the same one.
class SeenTriangle {
public:
    SeenTriangle(const View& view, const TrianglePieces& pieces, Tile tile)
        : m_view(view), m_pieces(pieces), m_tile(tile) {}

    HWY_INLINE void become(std::uint32_t record) {
        if (record != m_record) change(record);
    }
    std::uint32_t id() const { return m_id; }  // index into Topology::triangles
    // Else it is so large that weights() is all that is known of it.
    bool isLinear() const { return m_small || m_middle.fits(); }
    float w(std::size_t corner) const { return m_w[corner]; }
    // A quantity of the triangle's own corners at one of the corners that are drawn, which clipping may have made.
    Vec3<float> atCorner(const std::vector<Vec3<float>>& values, const std::uint32_t (&v)[3],
                         std::size_t corner) const {
        if (m_order[corner] < 3) return values[v[m_order[corner]]];
        const Vec3<float>& share = m_other->weights[corner];
        return share.x * values[v[0]] + share.y * values[v[1]] + share.z * values[v[2]];
    }

    // Linear in the picture, in the vector at `at` of the tile.
    HWY_INLINE Shares linear(std::size_t at) const {
        const BlockPlace place(at);
        if (!m_small)
            return {m_middle.linear(1, place.x, place.y, place.first),
                    m_middle.linear(2, place.x, place.y, place.first)};
        const auto edge = [&](int i) HWY_ATTR {
            const Ints e = m_edges[i].at(place.x, place.y, place.first);
            return hn::Mul(hn::ConvertTo(F(), e), all(m_small->inverseArea2));
        };
        return {edge(0), edge(1)};
    }
    // Perspective-correct weights over the triangle's own corners, the bits of interpolate; where the triangle is not,
    // any numbers.
    HWY_INLINE Floats3 weights(std::size_t at) const {
        if (!isLinear()) return weightsOfHuge(at);
        const Shares b = corrected(linear(at));
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
    HWY_INLINE Shares corrected(Shares l) const {
        if (!m_view.perspective) return l;
        const Floats z = Distances(m_w[0], m_w[1], m_w[2]).z(l.one, l.two, true);
        return {hn::Mul(hn::Mul(l.one, all(m_w[1])), z), hn::Mul(hn::Mul(l.two, all(m_w[2])), z)};
    }
    // Of a piece that clipping left: its corners are not the triangle's own.
    Floats3 ofCut(Shares b) const {
        const auto& w = m_other->weights;
        const auto weight = [&](int c) HWY_ATTR {
            return hn::Add(hn::Add(all(w[0][c]), hn::Mul(b.one, all(w[1][c] - w[0][c]))),
                           hn::Mul(b.two, all(w[2][c] - w[0][c])));
        };
        return {weight(0), weight(1), weight(2)};
    }
    Floats3 weightsOfHuge(std::size_t at) const {
        if (m_large.exact()) {
            const BlockPlace place(at);
            const EdgesAt edges = m_large.at(place.x, place.y, place.first);
            return ofCut(corrected({edges.l1, edges.l2}));
        }
        const auto& c = m_other->snapped.corners;
        const EdgeFunction edges[3]{{c[1], c[2]}, {c[2], c[0]}, {c[0], c[1]}};
        HWY_ALIGN float of[3][16];
        for (std::size_t l = 0; l < hn::Lanes(F()); ++l) {
            const glm::ivec2 pixel = m_tile.min + pixelOf(at + l);
            const std::array<std::int64_t, 3> e{edges[0].atPixel(pixel), edges[1].atPixel(pixel),
                                                edges[2].atPixel(pixel)};
            const Vec3<float> weights = interpolate(*m_other, e, m_view.perspective).barycentric;
            for (int i = 0; i < 3; ++i) of[i][l] = weights[i];
        }
        return {hn::Load(F(), of[0]), hn::Load(F(), of[1]), hn::Load(F(), of[2])};
    }
    HWY_NOINLINE void change(std::uint32_t record) {
        m_record = record;
        const TrianglePiece& piece = m_pieces.pieceOf(record);
        const std::uint32_t i = record & TrianglePieces::kIndex;
        if (record & TrianglePiece::kOther) return becomeOther(piece.others[i]);
        const SmallTriangle& t = piece.small[i];
        m_small = &t, m_id = t.id;
        m_w[0] = t.w0, m_w[1] = t.w1, m_w[2] = t.w2;
        for (std::size_t corner = 0; corner < 3; ++corner) m_order[corner] = t.corner(int(corner));
        const int x = m_tile.min.x - t.x, y = m_tile.min.y - t.y;
        // From the box's first pixel to the tile's.
        m_edges[0].become(t.c1, t.a1, t.b1), m_edges[0].value = m_edges[0].atPixel(x, y);
        m_edges[1].become(t.c2, t.a2, t.b2), m_edges[1].value = m_edges[1].atPixel(x, y);
    }
    void becomeOther(const RasterTriangle<float>& t) {
        m_small = nullptr, m_other = &t, m_id = t.id;
        m_middle = MiddleEdges(t, m_tile, m_view.subPixelBits);
        if (!m_middle.fits()) m_large = LargeEdges(t, m_tile);
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
    const View& m_view;
    const TrianglePieces& m_pieces;
    Tile m_tile;
    std::uint32_t m_record = kNoTriangle, m_id = kNoTriangle;
    float m_w[3]{};
    std::array<int, 3> m_order{};  // which of the triangle's own corners each is, or kCut for all
    const SmallTriangle* m_small = nullptr;
    TileFunction m_edges[2];  // a small triangle's edge functions 1 and 2
    const RasterTriangle<float>* m_other = nullptr;
    MiddleEdges m_middle;
    LargeEdges m_large;  // where m_middle does not fit
};

// Calls visit(mask) for each of the triangles seen in a vector; records: its pixels'. Before it, `triangle` has become
// that one.
template <class Visit>
HWY_INLINE void forEachTriangle(SeenTriangle& triangle, const std::uint32_t* records, Visit visit) {
    const auto here = hn::Load(U(), records);
    Mask left = seenIn(records);
    while (!hn::AllFalse(F(), left)) {
        const std::uint32_t record = records[hn::FindKnownFirstTrue(F(), left)];
        const Mask mine = hn::RebindMask(F(), hn::Eq(here, hn::Set(U(), record)));
        triangle.become(record);
        visit(mine);
        left = hn::AndNot(mine, left);
    }
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
