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

// The weights of corners 1 and 2 in a pixel; what they leave of 1 is that of corner 0.
struct Shares {
    Floats one, two;
};

// What the triangles that are seen in a tile are found in.
struct SeenIn {
    const View& view;
    const TrianglePieces& pieces;
    Tile tile;
    const float* z;  // of the tile's blocks: z_view of what is seen
};

// Whether what is seen in a vector are small triangles alone.
HWY_INLINE bool areSmall(const std::uint32_t* records, Mask seen) {
    const auto other = hn::And(hn::Load(U(), records), hn::Set(U(), TrianglePiece::kOther));
    return hn::AllFalse(F(), hn::And(seen, hn::RebindMask(F(), hn::Ne(other, hn::Zero(U())))));
}

// The small triangles that the pixels of a vector see, each its own, and their weights there, with the bits of
// SeenTriangle's. Where nothing is seen, any triangle of them.
struct SeenInPixels {
    HWY_ALIGN std::uint32_t id[16];  // index into Topology::triangles
    Shares weights;

    // seen: at least one.
    HWY_INLINE SeenInPixels(const SeenIn& in, const VectorPlace& place, const std::uint32_t* records, Mask seen) {
        HWY_ALIGN std::uint32_t wanted[16];
        const auto some = hn::Set(U(), records[hn::FindKnownFirstTrue(F(), seen)]);
        hn::Store(hn::IfThenElse(hn::RebindMask(U(), seen), hn::Load(U(), records), some), U(), wanted);
        const std::int32_t* of[16];
        for (std::size_t l = 0; l < hn::Lanes(F()); ++l) of[l] = &in.pieces.smallOf(wanted[l]).a1;
        const I whole;
        static_assert(offsetof(SmallTriangle, b2) == 16 && offsetof(SmallTriangle, biasedArea) == 32);
        static_assert(offsetof(SmallTriangle, inverseArea2) == 48 && offsetof(SmallTriangle, x) == 56);
        const auto quarter = [&](int number) HWY_ATTR {
            return loadFours(whole, [&](std::size_t l) { return of[l] + std::ptrdiff_t(4) * number; });
        };
        const Fours<I> one = quarter(0), two = quarter(1), three = quarter(2), four = quarter(3);
        hn::Store(hn::BitCast(U(), four.of[1]), U(), id);
        const Ints left = hn::ShiftRight<16>(hn::ShiftLeft<16>(four.of[2])), top = hn::ShiftRight<16>(four.of[2]);
        const Ints x = hn::Sub(hn::Add(place.column, hn::Set(whole, in.tile.min.x)), left);
        const Ints y = hn::Sub(hn::Add(place.row, hn::Set(whole, in.tile.min.y)), top);
        const auto edge = [&](Ints a, Ints b, Ints c)
                              HWY_ATTR { return hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), c); };
        const auto order = hn::And(hn::ShiftRight<16>(four.of[3]), hn::Set(whole, 255));
        const Ints bias0 = hn::BitCast(whole, hn::ShiftRight<24>(hn::BitCast(U(), four.of[3])));
        const Ints e1 = edge(one.of[0], one.of[1], one.of[2]), e2 = edge(one.of[3], two.of[0], two.of[1]);
        const Ints e0 = hn::Sub(hn::Sub(hn::Add(three.of[0], bias0), e1), e2);
        const auto inFloat = [](Ints bits) HWY_ATTR { return hn::BitCast(F(), bits); };
        const Floats inverse = inFloat(four.of[0]), z = hn::Load(F(), in.z + place.at);
        const auto share = [&](auto isFirst, auto isSecond) HWY_ATTR {
            const Ints e = hn::IfThenElse(isFirst, e0, hn::IfThenElse(isSecond, e1, e2));
            const Ints w = hn::IfThenElse(isFirst, three.of[1], hn::IfThenElse(isSecond, three.of[2], three.of[3]));
            const Floats linear = hn::Mul(hn::ConvertTo(F(), e), inverse);
            return in.view.perspective ? hn::Mul(hn::Mul(linear, inFloat(w)), z) : linear;
        };
        weights = {share(isDrawnAs<1, 0>(order), isDrawnAs<1, 1>(order)),
                   share(isDrawnAs<2, 0>(order), isDrawnAs<2, 1>(order))};
    }

private:
    // In which of these orders a triangle's own corner is drawn as that corner.
    template <int kOwn, int kDrawn>
    HWY_INLINE static hn::Mask<I> isDrawnAs(Ints order) {
        auto is = hn::Ne(order, order);
        for (int i = 0; i < 6; ++i)
            if (SmallTriangle::kCorners[i][kOwn] == kDrawn) is = hn::Or(is, hn::Eq(order, hn::Set(I(), i)));
        return is;
    }
};

// A triangle that is seen in a tile, for any vector of it. Its corners are its own, or, where clipping has cut it, those
// of a piece.
class SeenTriangle {
public:
    HWY_NOINLINE void become(const SeenIn& in, std::uint32_t record) {
        if (record & TrianglePiece::kOther)
            return becomeOther(in, in.pieces.pieceOf(record).others[record & TrianglePieces::kIndex]);
        const SmallTriangle& t = in.pieces.smallOf(record);
        m_small = &t, m_id = t.id, m_isCut = false;
        using Wraps = std::uint32_t;
        const auto rest = [](std::int32_t all, std::int32_t one, std::int32_t two) {
            return std::int32_t(Wraps(all) - Wraps(one) - Wraps(two));
        };
        const PixelFunction edges[3]{
            {rest(t.biasedArea + t.bias0, t.c1, t.c2), rest(0, t.a1, t.a2), rest(0, t.b1, t.b2)},
            {t.c1, t.a1, t.b1},
            {t.c2, t.a2, t.b2}};
        const float w[3]{t.w0, t.w1, t.w2};
        const int x = in.tile.min.x - t.x, y = in.tile.min.y - t.y;  // from the box's first pixel to the tile's
        for (int corner = 0; corner < 3; ++corner) {
            const int drawn = t.corner(corner);
            m_w[corner] = w[drawn], m_edges[corner] = edges[drawn];
            m_edges[corner].value = edges[drawn].atPixel(x, y);
        }
    }
    std::uint32_t id() const { return m_id; }  // index into Topology::triangles
    // Else it is so large that weights() is all that is known of it.
    bool isLinear() const { return m_small || m_other->middle; }
    float w(std::size_t corner) const { return m_w[corner]; }
    // A quantity of the triangle's own corners at one of its corners.
    Vec3<float> atCorner(std::span<const Vec3<float>> values, const std::uint32_t (&v)[3], std::size_t corner) const {
        if (!m_isCut) return values[v[corner]];
        const Vec3<float>& share = m_other->triangle->weights[corner];
        return share.x * values[v[0]] + share.y * values[v[1]] + share.z * values[v[2]];
    }
    // Its first pixel in the tile.
    glm::ivec2 firstPixel(Tile tile) const {
        const glm::ivec2 first = m_small ? glm::ivec2(m_small->x, m_small->y) : m_other->triangle->snapped.pixels().min;
        return glm::max(first - tile.min, 0);
    }
    // The weight of a corner that is linear in the picture.
    Slope slope(int corner, glm::ivec2 first) const {
        if (!m_small) return m_other->middle->slope(m_other->drawn[corner], first);
        const PixelFunction& edge = m_edges[corner];
        const float inverse = m_small->inverseArea2;
        return {float(edge.atPixel(first.x, first.y)) * inverse, float(edge.column) * inverse,
                float(edge.row) * inverse};
    }
    // Perspective-correct weights over the triangle's own corners, the bits of interpolate; where the triangle is not
    // seen, any numbers.
    HWY_INLINE Shares weights(const SeenIn& in, const VectorPlace& place) const {
        if (HWY_UNLIKELY(!m_small)) return weightsOfOther(in, place);
        const Floats inverse = all(m_small->inverseArea2);
        const auto share = [&](int corner) HWY_ATTR {
            return corrected(in, place, corner, hn::Mul(hn::ConvertTo(F(), m_edges[corner].in(place)), inverse));
        };
        return {share(1), share(2)};
    }

private:
    HWY_INLINE Floats corrected(const SeenIn& in, const VectorPlace& place, int corner, Floats linear) const {
        if (!in.view.perspective) return linear;
        return hn::Mul(hn::Mul(linear, all(m_w[corner])), hn::Load(F(), in.z + place.at));
    }
    HWY_NOINLINE Shares weightsOfOther(const SeenIn& in, const VectorPlace& place) const {
        if (!m_other->middle && !m_other->large->exact()) return weightsOfHuge(in, place);
        const auto share = [&](int corner) HWY_ATTR {
            const int drawn = m_other->drawn[corner];
            const Floats linear =
                m_other->middle ? m_other->middle->linear(drawn, place) : m_other->large->linear(drawn, place);
            return corrected(in, place, corner, linear);
        };
        if (!m_isCut) return {share(1), share(2)};
        Shares sum{all(0), all(0)};
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3<float>& own = m_other->triangle->weights[std::size_t(corner)];
            const Floats b = share(corner);
            sum.one = hn::Add(sum.one, hn::Mul(b, all(own.y))), sum.two = hn::Add(sum.two, hn::Mul(b, all(own.z)));
        }
        return sum;
    }
    Shares weightsOfHuge(const SeenIn& in, const VectorPlace& place) const {
        const auto& c = m_other->triangle->snapped.corners;
        const EdgeFunction edges[3]{{c[1], c[2]}, {c[2], c[0]}, {c[0], c[1]}};
        HWY_ALIGN float one[16], two[16];
        for (std::size_t l = 0; l < hn::Lanes(F()); ++l) {
            const glm::ivec2 pixel = in.tile.min + pixelOf(place.at + l);
            const std::array<std::int64_t, 3> e{edges[0].atPixel(pixel), edges[1].atPixel(pixel),
                                                edges[2].atPixel(pixel)};
            const Vec3<float> weights = interpolate(*m_other->triangle, e, in.view.perspective).barycentric;
            one[l] = weights.y, two[l] = weights.z;
        }
        return {hn::Load(F(), one), hn::Load(F(), two)};
    }
    void becomeOther(const SeenIn& in, const RasterTriangle<float>& t) {
        if (!m_other) m_other = std::make_unique<Other>();
        m_small = nullptr, m_id = t.id, m_other->triangle = &t;
        m_other->middle = MiddleEdges(t, in.tile, in.view.subPixelBits);
        if (!m_other->middle->fits()) m_other->middle.reset(), m_other->large = LargeEdges(t, in.tile);
        int whole = 0;
        for (int own = 0; own < 3; ++own)
            for (int corner = 0; corner < 3; ++corner)
                if (t.weights[std::size_t(corner)][own] == 1) m_other->drawn[own] = corner, ++whole;
        m_isCut = whole < 3;
        if (m_isCut) m_other->drawn = {0, 1, 2};
        for (int corner = 0; corner < 3; ++corner) m_w[corner] = t.w[std::size_t(m_other->drawn[corner])];
    }

    // What is known of one that is not small.
    struct Other {
        const RasterTriangle<float>* triangle;
        glm::ivec3 drawn;  // in which place each corner is drawn
        std::optional<MiddleEdges> middle;
        std::optional<LargeEdges> large;  // where `middle` does not fit
    };
    std::uint32_t m_id;
    bool m_isCut;
    float m_w[3];
    const SmallTriangle* m_small;    // null where it is not one
    PixelFunction m_edges[3];        // of the edge opposite each corner, of a small one
    std::unique_ptr<Other> m_other;  // kept for the next one
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
