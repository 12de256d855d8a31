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
struct Sums {
    Ints arrived, won;
    HWY_INLINE Sums() : arrived(hn::Zero(I())), won(hn::Zero(I())) {}
    HWY_INLINE void add(Mask inside, Mask wins) {
        const Ints one = hn::Set(I(), 1);
        arrived = hn::Add(arrived, hn::IfThenElseZero(hn::RebindMask(I(), inside), one));
        won = hn::Add(won, hn::IfThenElseZero(hn::RebindMask(I(), wins), one));
    }
    HWY_INLINE void addTo(TileCounts& counts) const {
        counts.arrived += hn::GetLane(hn::SumOfLanes(I(), arrived));
        counts.won += hn::GetLane(hn::SumOfLanes(I(), won));
    }
};

// Draws what a triangle has in one vector.
HWY_INLINE void drawVector(std::size_t at, const EdgesAt& edges, const Distances& distances, std::uint32_t record,
                           bool perspective, Mask inPicture, const DrawnTile& out, Sums& sums) {
    float* const to = &out.z[0].of[at];
    const Floats z = distances.z(edges.l1, edges.l2, perspective), stored = hn::Load(F(), to);
    const Mask inside = hn::And(edges.inside, inPicture), won = hn::And(inside, hn::Lt(z, stored));
    sums.add(inside, won);
    // Stored as a whole: what follows may load the same block, and a store through a mask is not passed on to it.
    hn::Store(hn::IfThenElse(won, z, stored), F(), to);
    std::uint32_t* const seen = &out.record[0].of[at];
    hn::Store(hn::IfThenElse(hn::RebindMask(U(), won), hn::Set(U(), record), hn::Load(U(), seen)), U(), seen);
    if (!out.counted) return;
    const auto count = [&](std::int32_t* counts, Mask mask) HWY_ATTR {
        const Ints one = hn::IfThenElseZero(hn::RebindMask(I(), mask), hn::Set(I(), 1));
        hn::Store(hn::Add(hn::Load(I(), counts), one), I(), counts);
    };
    count(&out.counted->arrived[0].of[at], inside), count(&out.counted->won[0].of[at], won);
}

// The lists of tiles jump about in the triangles, which may stand across two lines of the cache.
HWY_INLINE void fetchAhead(const TrianglePiece& piece, std::span<const std::uint32_t> list, std::size_t n) {
    constexpr std::size_t kAhead = 12;
    if (n + kAhead >= list.size() || list[n + kAhead] & TrianglePiece::kOther) return;
    const SmallTriangle& t = piece.small[list[n + kAhead]];
    hwy::Prefetch(&t.a1), hwy::Prefetch(&t.order);
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

void drawOther(const View& view, const RasterTriangle<float>& t, std::uint32_t record, Tile tile, const DrawnTile& out,
               TileCounts& counts) {
    const bool whole = tile.max - tile.min == glm::ivec2(kTileSize);
    const Mask everything = hn::Eq(hn::Zero(F()), hn::Zero(F()));
    Sums sums;
    forEachOfOther(
        t, tile, view.subPixelBits,
        [&](std::size_t at, const EdgesAt& e, const Distances& distances) HWY_ATTR {
            drawVector(at, e, distances, record, view.perspective, whole ? everything : within(tile, at), out, sums);
        },
        [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) {
            const std::size_t at = placeOf(pixel - tile.min);
            const float z = interpolate(t, e, view.perspective).z;
            const bool won = z < out.z[0].of[at];
            ++counts.arrived, counts.won += won;
            if (out.counted) ++out.counted->arrived[0].of[at], out.counted->won[0].of[at] += won;
            if (won) out.z[0].of[at] = z, out.record[0].of[at] = record;
        });
    sums.addTo(counts);
}

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
    const SeenIn in{view, seen.pieces, tile};
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
            const Floats3 b = triangle.weights(in, at);
            hn::BlendedStore(b.x, mask, F(), of[0]);
            hn::BlendedStore(b.y, mask, F(), of[1]);
            hn::BlendedStore(b.z, mask, F(), of[2]);
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
    const bool whole = tile.max - tile.min == glm::ivec2(kTileSize);
    Sums sums;
    TileCounts counts;
    const Mask everything = hn::Eq(hn::Zero(F()), hn::Zero(F()));
    for (std::size_t number = 0; number < all.pieces.size(); ++number) {
        const TrianglePiece& piece = all.pieces[number];
        const auto list = piece.list(index);
        for (std::size_t n = 0; n < list.size(); ++n) {
            fetchAhead(piece, list, n);
            const std::uint32_t i = list[n], record = TrianglePieces::record(number, i);
            if (i & TrianglePiece::kOther) {
                drawOther(view, piece.others[i & TrianglePieces::kIndex], record, tile, drawn, counts);
                continue;
            }
            const SmallTriangle& t = piece.small[i];
            const Distances distances(t.w0, t.w1, t.w2);
            forEachVector(t, tile, [&](std::size_t at, const EdgesAt& edges) HWY_ATTR {
                drawVector(at, edges, distances, record, view.perspective, whole ? everything : within(tile, at), drawn,
                           sums);
            });
        }
    }
    sums.addTo(counts);
    for (std::size_t at = 0; at < kTilePixels; at += hn::Lanes(F()))
        counts.seen += static_cast<long long>(hn::CountTrue(F(), seenIn(&drawn.record[0].of[at])));
    if (counted) {
        copyRows(counted->arrived.data(), tile, out.overdraw);
        copyRows(counted->won.data(), tile, out.depthWrites);
    }
    if (!out.barycentric.empty()) writeWeights(view, seen, index, out.barycentric);
    return counts;
}

void drawShadowTile(const View& face, const TrianglePieces& all, std::size_t index, BlockBuffer2D<float>& depth) {
    const Tile tile = tileOf(all.size, index);
    Block<float>* const blocks = depth.tile(index);
    const auto draw = [&](std::size_t at, const EdgesAt& edges, const Distances& distances) HWY_ATTR {
        float* const to = &blocks[0].of[at];
        const Floats z = distances.z(edges.l1, edges.l2, face.perspective), stored = hn::Load(F(), to);
        hn::Store(hn::IfThenElse(hn::And(edges.inside, hn::Lt(z, stored)), z, stored), F(), to);
    };
    const auto drawSmall = [&](const SmallTriangle& t) HWY_ATTR {
        const Distances distances(t.w0, t.w1, t.w2);
        forEachVector(t, tile, [&](std::size_t at, const EdgesAt& edges) HWY_ATTR { draw(at, edges, distances); });
    };
    const auto drawOne = [&](const TrianglePiece& piece, std::uint32_t i) HWY_ATTR {
        if (!(i & TrianglePiece::kOther)) return drawSmall(piece.small[i]);
        const RasterTriangle<float>& t = piece.others[i & TrianglePieces::kIndex];
        forEachOfOther(t, tile, face.subPixelBits, draw, [&](glm::ivec2 texel, const std::array<std::int64_t, 3>& e) {
            float& stored = blocks[0].of[placeOf(texel - tile.min)];
            stored = std::min(stored, interpolate(t, e, face.perspective).z);
        });
    };
    // The nearest remains, whatever the order. What faces the light comes first: of a solid, it hides the rest.
    std::vector<std::pair<const TrianglePiece*, std::uint32_t>> rest;
    for (const TrianglePiece& piece : all.pieces) {
        const auto list = piece.list(index);
        for (std::size_t n = 0; n < list.size(); ++n) {
            fetchAhead(piece, list, n);
            const std::uint32_t i = list[n];
            const bool first = i & TrianglePiece::kOther ? facesViewer(piece.others[i & TrianglePieces::kIndex])
                                                         : piece.small[i].facesViewer();
            if (first)
                drawOne(piece, i);
            else
                rest.emplace_back(&piece, i);
        }
    }
    if (rest.empty()) return;
    const Farthest farthest(blocks);
    for (const auto& [piece, i] : rest) {
        const bool isHidden = [&, piece = piece, i = i] {
            if (i & TrianglePiece::kOther) {
                const RasterTriangle<float>& t = piece->others[i & TrianglePieces::kIndex];
                return farthest.hides(t.w, t.snapped.pixels(), tile, face.perspective);
            }
            const SmallTriangle& t = piece->small[i];
            const glm::ivec2 low(t.x, t.y);
            return farthest.hides({t.w0, t.w1, t.w2}, {low, low + glm::ivec2(t.width, t.height)}, tile,
                                  face.perspective);
        }();
        if (!isHidden) drawOne(*piece, i);
    }
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
