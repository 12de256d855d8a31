// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SEEN_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SEEN_H
#undef SHADESCOPE_SEEN_H
#else
#define SHADESCOPE_SEEN_H
#endif

#include "pipeline/simd/blocks.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// b1 and b2 of interpolate: perspective-correct weights of corners 1 and 2.
HWY_INLINE void correct(const EdgesAt& at, float w0, float w1, float w2, bool perspective, Floats& b1, Floats& b2) {
    b1 = at.l1, b2 = at.l2;
    if (!perspective) return;
    const Floats z = Distances(w0, w1, w2).z(at, true);
    b1 = hn::Mul(hn::Mul(at.l1, all(w1)), z), b2 = hn::Mul(hn::Mul(at.l2, all(w2)), z);
}

// Goes once more over the triangles of a tile of which something is seen; seen: of its first block, the triangle in each
// pixel, and `stride` further those of the next.
// Calls visit(at, mask, weights) for the vectors that hold pixels of one; weights: over the triangle's own corners, the
// bits of interpolate. Before these, begin(triangle).
template <class Begin, class Visit>
HWY_INLINE void forEachSeen(const View& view, const TrianglePieces& pieces, std::size_t index,
                            const std::uint32_t* seen, std::size_t stride, Begin begin, Visit visit) {
    const Tile tile = tileOf(pieces.size, index);
    std::uint32_t begun = kNoTriangle;
    const auto place = [&](std::size_t at) { return at / kBlockPixels * stride + at % kBlockPixels; };
    const auto seenOf = [&](std::size_t at, Mask inside, std::uint32_t id) HWY_ATTR {
        const auto mine = hn::Eq(hn::Load(U(), seen + place(at)), hn::Set(U(), id));
        const Mask mask = hn::And(inside, hn::RebindMask(F(), mine));
        if (begun != id && !hn::AllFalse(F(), mask)) begin(begun = id);
        return mask;
    };
    for (const TrianglePiece& piece : pieces.pieces) {
        for (const std::uint32_t i : piece.list(index)) {
            if (!(i & TrianglePiece::kOther)) {
                const SmallTriangle& t = piece.small[i];
                const int corner0 = t.corner(0), corner1 = t.corner(1);
                forEachVector(t, tile, [&](std::size_t at, const EdgesAt& e) HWY_ATTR {
                    const Mask mask = seenOf(at, e.inside, t.id);
                    if (hn::AllFalse(F(), mask)) return;
                    Floats b1, b2;
                    correct(e, t.w0, t.w1, t.w2, view.perspective, b1, b2);
                    const Floats b0 = hn::Sub(hn::Sub(all(1), b1), b2);
                    const auto weight = [&](int c) HWY_ATTR { return c == corner0 ? b0 : c == corner1 ? b1 : b2; };
                    visit(at, mask, Floats3{weight(0), weight(1), weight(2)});
                });
                continue;
            }
            const RasterTriangle<float>& t = piece.others[i & ~TrianglePiece::kOther];
            const LargeEdges edges(t, tile);
            if (edges.exact()) {
                forEachVector(edges, t, tile, [&](std::size_t at, const EdgesAt& e) HWY_ATTR {
                    const Mask mask = seenOf(at, e.inside, t.id);
                    if (hn::AllFalse(F(), mask)) return;
                    Floats b1, b2;
                    correct(e, t.w[0], t.w[1], t.w[2], view.perspective, b1, b2);
                    const auto& w = t.weights;
                    const auto weight = [&](int c) HWY_ATTR {
                        return hn::Add(hn::Add(all(w[0][c]), hn::Mul(b1, all(w[1][c] - w[0][c]))),
                                       hn::Mul(b2, all(w[2][c] - w[0][c])));
                    };
                    visit(at, mask, Floats3{weight(0), weight(1), weight(2)});
                });
                continue;
            }
            const auto lanes = hn::Lanes(F());
            forEachCovered(t.snapped, tile, [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) HWY_ATTR {
                const std::size_t here = placeOf(pixel - tile.min), at = here / lanes * lanes;
                if (seen[place(here)] != t.id) return;
                if (begun != t.id) begin(begun = t.id);
                const Mask mask =
                    hn::RebindMask(F(), hn::Eq(hn::Iota(I(), std::int32_t(at)), hn::Set(I(), std::int32_t(here))));
                visit(at, mask, all(interpolate(t, e, view.perspective).barycentric));
            });
        }
    }
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
