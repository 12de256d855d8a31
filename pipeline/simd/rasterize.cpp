#include "pipeline/simd/rasterize.h"

#include <hwy/cache_control.h>

#include <array>
#include <limits>
#include <optional>

#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/rasterize.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/seen.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// How many fragments there were in each pixel of a tile.
struct CountedTile {
    std::array<Block<std::int32_t>, kBlocks> arrived{}, won{};
};

struct DrawnTile {
    Block<float>* z;
    Block<std::uint32_t>* record;
    CountedTile* counted;  // null where nobody asks
};

// How many fragments there were, lane by lane: sums of vectors stay in registers.
class Sums {
public:
    HWY_INLINE Sums() : m_outside(hn::Zero(I())), m_won(hn::Zero(I())) {}
    HWY_INLINE void add(Ints outside, Mask won) {
        m_outside = hn::Add(m_outside, hn::BitCast(I(), hn::ShiftRight<31>(hn::BitCast(U(), outside))));
        m_won = hn::Sub(m_won, hn::VecFromMask(I(), hn::RebindMask(I(), won)));
        ++m_vectors;
    }
    HWY_INLINE void addTo(TileCounts& counts) const {
        counts.arrived += m_vectors * kLanes - hn::GetLane(hn::SumOfLanes(I(), m_outside));
        counts.won += hn::GetLane(hn::SumOfLanes(I(), m_won));
    }

private:
    Ints m_outside, m_won;
    long long m_vectors = 0;
};

HWY_INLINE Floats nowhereOutside(Ints outside, Floats z) {
    return hn::BitCast(F(), hn::IfNegativeThenElse(outside, hn::BitCast(I(), all(kFar)), hn::BitCast(I(), z)));
}

// The lists of tiles jump about in the triangles.
HWY_INLINE void fetchAhead(const TrianglePiece& piece, std::span<const std::uint32_t> list, std::size_t n) {
    constexpr std::size_t kAhead = 12;
    if (n + kAhead >= list.size() || list[n + kAhead] & TrianglePiece::kOther) return;
    hwy::Prefetch(&piece.small[list[n + kAhead]]);
}

// Calls visit(at, edges, distances) for the vectors of a tile that a triangle which is not small covers a part of, and
// visitPixel(pixel, e) for its pixels where no vectors hold its edge functions.
template <class Visit, class VisitPixel>
HWY_INLINE void forEachOfOther(const RasterTriangle<float>& t, Tile tile, int bits, Visit visit,
                               VisitPixel visitPixel) {
    const Distances distances(t.w[0], t.w[1], t.w[2]);
    const auto draw = [&](std::size_t at, const EdgesAt& e) HWY_ATTR { visit(at, e, distances); };
    if (const MiddleEdges middle(t, tile, bits); middle.fits()) return forEachVector(middle, t, tile, draw);
    if (const LargeEdges large(t, tile); large.exact()) return forEachVector(large, t, tile, draw);
    forEachCovered(t.snapped, tile, visitPixel);
}

// Draws triangles into a tile. kPlain: all pixels of its blocks are in the picture, and nobody counts by pixel.
template <bool kPerspective, bool kPlain>
class TileDrawer {
public:
    TileDrawer(const View& view, Tile tile, const DrawnTile& out) : m_view(view), m_tile(tile), m_out(out) {}

    TileCounts draw(const TrianglePieces& all, std::size_t index) {
        Sums sums;
        for (std::size_t number = 0; number < all.pieces.size(); ++number) {
            const TrianglePiece& piece = all.pieces[number];
            const auto list = piece.list(index);
            for (std::size_t n = 0; n < list.size(); ++n) {
                fetchAhead(piece, list, n);
                const std::uint32_t i = list[n], record = TrianglePieces::record(number, i);
                if (i & TrianglePiece::kOther)
                    drawOther(piece.others[i & TrianglePieces::kIndex], record);
                else
                    drawSmall(piece.small[i], record, sums);
            }
        }
        sums.addTo(m_counts);
        return m_counts;
    }

private:
    HWY_INLINE void drawSmall(const SmallTriangle& t, std::uint32_t record, Sums& sums) {
        const Distances distances(t.w0, t.w1, t.w2);
        const auto seen = hn::Set(U(), record);
        forEachVector(t, m_tile, [&](std::size_t at, const EdgesAt& edges) HWY_ATTR {
            drawVector(at, edges, distances, seen, sums);
        });
    }
    HWY_NOINLINE void drawOther(const RasterTriangle<float>& t, std::uint32_t record) {
        Sums sums;
        const auto seen = hn::Set(U(), record);
        forEachOfOther(
            t, m_tile, m_view.subPixelBits,
            [&](std::size_t at, const EdgesAt& edges, const Distances& distances)
                HWY_ATTR { drawVector(at, edges, distances, seen, sums); },
            [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) {
                const std::size_t at = placeOf(pixel - m_tile.min);
                const float z = interpolate(t, e, kPerspective).z;
                const bool won = z < m_out.z[0].of[at];
                ++m_counts.arrived, m_counts.won += won;
                if (m_out.counted) ++m_out.counted->arrived[0].of[at], m_out.counted->won[0].of[at] += won;
                if (won) m_out.z[0].of[at] = z, m_out.record[0].of[at] = record;
            });
        sums.addTo(m_counts);
    }
    // What a triangle has in one vector.
    HWY_INLINE void drawVector(std::size_t at, const EdgesAt& edges, const Distances& distances, hn::Vec<U> record,
                               Sums& sums) {
        float* const to = &m_out.z[0].of[at];
        std::uint32_t* const seen = &m_out.record[0].of[at];
        const Ints outside =
            kPlain ? edges.outside
                   : hn::IfThenElse(hn::RebindMask(I(), within(m_tile, at)), edges.outside, hn::Set(I(), -1));
        const Floats z = nowhereOutside(outside, distances.template z<kPerspective>(edges.l1, edges.l2));
        const Floats stored = hn::Load(F(), to);
        const Mask won = hn::Lt(z, stored);
        sums.add(outside, won);
        // Stored as a whole: what follows may load the same block, and a store through a mask is not passed on to it.
        hn::Store(hn::IfThenElse(won, z, stored), F(), to);
        hn::Store(hn::IfThenElse(hn::RebindMask(U(), won), record, hn::Load(U(), seen)), U(), seen);
        if (kPlain || !m_out.counted) return;
        const auto count = [&](std::int32_t* counts, Mask mask) HWY_ATTR {
            hn::Store(hn::Sub(hn::Load(I(), counts), hn::VecFromMask(I(), hn::RebindMask(I(), mask))), I(), counts);
        };
        count(&m_out.counted->arrived[0].of[at], asFloats(hn::Gt(outside, hn::Set(I(), -1))));
        count(&m_out.counted->won[0].of[at], won);
    }

    const View& m_view;
    Tile m_tile;
    DrawnTile m_out;
    TileCounts m_counts;
};

// Whether a triangle was turned round for its corners to run clockwise. One that clipping has cut counts as facing.
bool facesViewer(const RasterTriangle<float>& t) {
    int own[3]{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec3<float>& w = t.weights[corner];
        if (w.x != 1 && w.y != 1 && w.z != 1) return true;
        own[corner] = w.x == 1 ? 0 : w.y == 1 ? 1 : 2;
    }
    return own[1] != (own[0] + 1) % 3;
}

// The farthest depth that is stored in each square of a tile.
class Farthest {
public:
    explicit Farthest(const Block<float>* blocks) {
        for (int y = 0; y < kAcross; ++y)
            for (int x = 0; x < kAcross; ++x) {
                Floats most = all(-kFar);
                for (int row = 0; row < kSide / kBlock; ++row) {
                    const float* from = blocks[0].of + blockAt(x * kSide / kBlock, y * kSide / kBlock + row);
                    for (std::size_t i = 0; i < std::size_t(kSide) * kBlock; i += hn::Lanes(F()))
                        most = hn::Max(most, hn::Load(F(), from + i));
                }
                m_of[y][x] = hn::GetLane(hn::MaxOfLanes(F(), most));
            }
    }
    // Whether no pixel of a triangle with these w can be nearer than what is there; box: its pixels.
    bool hides(std::array<float, 3> w, Tile box, Tile tile, bool perspective) const {
        const auto [low, high] = std::ranges::minmax(w);
        // Two products and three sums of at most twice the largest |w|, and shares with four roundings, err by less than
        // 2^-19 of it; the reciprocal by twice as much.
        const float nearest =
            perspective ? (1 - 0x1p-18F) / high : low - 0x1p-19F * std::max(std::abs(low), std::abs(high));
        const glm::ivec2 first = glm::max(box.min - tile.min, 0) / kSide;
        const glm::ivec2 last = (glm::min(box.max, tile.max) - tile.min - 1) / kSide;
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x)
                if (!(nearest > m_of[y][x])) return false;
        return true;
    }

private:
    static constexpr int kSide = 16, kAcross = kTileSize / kSide;
    float m_of[kAcross][kAcross];
};

// The weights of what is seen in a tile, as rows.
void writeWeights(const View& view, const SeenBlocks& seen, std::size_t index, Buffer2D<Vec3<float>>& out) {
    const Tile tile = tileOf(seen.pieces.size, index);
    const SeenIn in{view, seen.pieces, tile, seen.z.tile(index)->of};
    SeenTriangle triangle;
    std::uint32_t record = kNoTriangle;
    for (std::size_t at = 0; at < kTilePixels; at += hn::Lanes(F())) {
        HWY_ALIGN float of[3][16]{};
        const std::uint32_t* const records = &seen.record.tile(index)->of[at];
        for (Mask left = seenIn(records); !hn::AllFalse(F(), left);) {
            const std::uint32_t next = records[hn::FindKnownFirstTrue(F(), left)];
            if (next != record) record = next, triangle.become(in, record);
            const Mask mask = seesIn(records, record);
            left = hn::AndNot(mask, left);
            const Shares b = triangle.weights(in, VectorPlace(at));
            hn::BlendedStore(hn::Sub(hn::Sub(all(1), b.one), b.two), mask, F(), of[0]);
            hn::BlendedStore(b.one, mask, F(), of[1]);
            hn::BlendedStore(b.two, mask, F(), of[2]);
        }
        for (std::size_t l = 0; l < hn::Lanes(F()); ++l) {
            const glm::ivec2 pixel = tile.min + pixelOf(at + l);
            if (pixel.x < tile.max.x && pixel.y < tile.max.y) out.at(pixel) = {of[0][l], of[1][l], of[2][l]};
        }
    }
}

}  // namespace

TileCounts drawTile(const View& view, std::size_t index, SeenBlocks& seen, ZBufferOutput<float>& out) {
    const TrianglePieces& all = seen.pieces;
    const Tile tile = tileOf(all.size, index);
    if (!all.touches(index)) return {};
    seen.z.fill(index, kFar), seen.record.fill(index, kNoTriangle);
    std::optional<CountedTile> counted;
    const DrawnTile drawn{seen.z.tile(index), seen.record.tile(index),
                          out.overdraw.empty() ? nullptr : &counted.emplace()};
    const glm::ivec2 size = tile.max - tile.min;
    const auto draw = [&](auto drawer) { return drawer.draw(all, index); };
    const bool isPlain = !counted && size.x % kBlock == 0 && size.y % kBlock == 0;
    TileCounts counts = isPlain            ? view.perspective ? draw(TileDrawer<true, true>(view, tile, drawn))
                                                              : draw(TileDrawer<false, true>(view, tile, drawn))
                                   : view.perspective ? draw(TileDrawer<true, false>(view, tile, drawn))
                                           : draw(TileDrawer<false, false>(view, tile, drawn));
    for (std::size_t at = 0; at < kTilePixels; at += hn::Lanes(F()))
        counts.seen += static_cast<long long>(hn::CountTrue(F(), seenIn(&drawn.record[0].of[at])));
    if (counted) {
        copyRows(counted->arrived.data(), tile, out.overdraw);
        copyRows(counted->won.data(), tile, out.depthWrites);
    }
    if (!out.barycentric.empty()) writeWeights(view, seen, index, out.barycentric);
    return counts;
}

// Draws triangles into a tile of a shadow buffer. The nearest remains, whatever the order. What faces the light comes
// first: of a solid, it hides the rest.
template <bool kPerspective>
class ShadowDrawer {
public:
    ShadowDrawer(const View& face, Tile tile, Block<float>* blocks)
        : m_bits(face.subPixelBits), m_tile(tile), m_blocks(blocks) {}

    void draw(const TrianglePieces& all, std::size_t index) {
        std::vector<std::pair<const TrianglePiece*, std::uint32_t>> rest;
        for (const TrianglePiece& piece : all.pieces) {
            const auto list = piece.list(index);
            for (std::size_t n = 0; n < list.size(); ++n) {
                fetchAhead(piece, list, n);
                const std::uint32_t i = list[n];
                if (const bool isOther = i & TrianglePiece::kOther;
                    isOther ? !facesViewer(otherOf(piece, i)) : !piece.small[i].facesViewer())
                    rest.emplace_back(&piece, i);
                else if (isOther)
                    drawOther(otherOf(piece, i));
                else
                    drawSmall(piece.small[i]);
            }
        }
        if (rest.empty()) return;
        const Farthest farthest(m_blocks);
        for (const auto& [piece, i] : rest) drawUnlessHidden(farthest, *piece, i);
    }

private:
    static const RasterTriangle<float>& otherOf(const TrianglePiece& piece, std::uint32_t i) {
        return piece.others[i & TrianglePieces::kIndex];
    }
    void drawUnlessHidden(const Farthest& farthest, const TrianglePiece& piece, std::uint32_t i) {
        const auto isHidden = [&](std::array<float, 3> w, Tile box) {
            return farthest.hides(w, box, m_tile, kPerspective);
        };
        if (i & TrianglePiece::kOther) {
            const RasterTriangle<float>& t = otherOf(piece, i);
            if (!isHidden(t.w, t.snapped.pixels())) drawOther(t);
            return;
        }
        const SmallTriangle& t = piece.small[i];
        const glm::ivec2 low(t.x, t.y);
        if (!isHidden({t.w0, t.w1, t.w2}, {low, low + glm::ivec2(t.width, t.height)})) drawSmall(t);
    }
    HWY_INLINE void drawSmall(const SmallTriangle& t) {
        const Distances distances(t.w0, t.w1, t.w2);
        forEachVector(t, m_tile,
                      [&](std::size_t at, const EdgesAt& edges) HWY_ATTR { drawVector(at, edges, distances); });
    }
    HWY_NOINLINE void drawOther(const RasterTriangle<float>& t) {
        forEachOfOther(
            t, m_tile, m_bits,
            [&](std::size_t at, const EdgesAt& edges, const Distances& distances)
                HWY_ATTR { drawVector(at, edges, distances); },
            [&](glm::ivec2 texel, const std::array<std::int64_t, 3>& e) {
                float& stored = m_blocks[0].of[placeOf(texel - m_tile.min)];
                stored = std::min(stored, interpolate(t, e, kPerspective).z);
            });
    }
    HWY_INLINE void drawVector(std::size_t at, const EdgesAt& edges, const Distances& distances) {
        float* const to = &m_blocks[0].of[at];
        const Floats z = nowhereOutside(edges.outside, distances.template z<kPerspective>(edges.l1, edges.l2));
        const Floats stored = hn::Load(F(), to);
        hn::Store(hn::IfThenElse(hn::Lt(z, stored), z, stored), F(), to);
    }

    int m_bits;
    Tile m_tile;
    Block<float>* m_blocks;
};

void drawShadowTile(const View& face, const TrianglePieces& all, std::size_t index, BlockBuffer2D<float>& depth) {
    const Tile tile = tileOf(all.size, index);
    if (face.perspective)
        ShadowDrawer<true>(face, tile, depth.tile(index)).draw(all, index);
    else
        ShadowDrawer<false>(face, tile, depth.tile(index)).draw(all, index);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(drawTile);
HWY_EXPORT(drawShadowTile);

TileCounts zBufferInVectors(const View& view, std::size_t tile, SeenBlocks& seen, ZBufferOutput<float>& out) {
    return HWY_DYNAMIC_DISPATCH(drawTile)(view, tile, seen, out);
}

void shadowBufferInVectors(const View& face, const TrianglePieces& pieces, std::size_t tile,
                           BlockBuffer2D<float>& depth) {
    HWY_DYNAMIC_DISPATCH(drawShadowTile)(face, pieces, tile, depth);
}

}  // namespace pipeline
#endif
