#include "pipeline/simd/rasterize.h"

#include <hwy/cache_control.h>

#include <algorithm>
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

// A block while it is drawn.
struct DepthBlock {
    alignas(64) float z[kBlockPixels];
};
struct SeenBlock {
    alignas(64) float z[kBlockPixels];
    std::uint32_t triangle[kBlockPixels];
};
struct CountBlock {
    alignas(64) std::int32_t arrived[kBlockPixels]{}, won[kBlockPixels]{};
};
struct WeightBlock {
    alignas(64) float of[3][kBlockPixels]{};
};
using CountBlocks = std::array<CountBlock, kBlocks>;

struct DrawnTile {
    std::array<SeenBlock, kBlocks> blocks;
    CountBlocks* counted = nullptr;  // null where nobody asks
    DrawnTile() {
        for (SeenBlock& block : blocks) {
            std::fill_n(block.z, kBlockPixels, kFar);
            std::fill_n(block.triangle, kBlockPixels, kNoTriangle);
        }
    }
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
    HWY_INLINE TileCounts total() const {
        return {hn::GetLane(hn::SumOfLanes(I(), arrived)), hn::GetLane(hn::SumOfLanes(I(), won))};
    }
};

// Draws what a triangle has in one vector.
HWY_INLINE void drawVector(std::size_t at, const EdgesAt& edges, const Distances& distances, std::uint32_t id,
                           bool perspective, Mask inPicture, DrawnTile& out, Sums& sums) {
    SeenBlock& block = out.blocks[at / kBlockPixels];
    const std::size_t in = at % kBlockPixels;
    const Floats z = distances.z(edges, perspective), stored = hn::Load(F(), &block.z[in]);
    const Mask inside = hn::And(edges.inside, inPicture), won = hn::And(inside, hn::Lt(z, stored));
    sums.add(inside, won);
    // Stored as a whole: what follows may load the same block, and a store through a mask is not passed on to it.
    hn::Store(hn::IfThenElse(won, z, stored), F(), &block.z[in]);
    const auto before = hn::Load(U(), &block.triangle[in]);
    hn::Store(hn::IfThenElse(hn::RebindMask(U(), won), hn::Set(U(), id), before), U(), &block.triangle[in]);
    if (!out.counted) return;
    const auto count = [&](std::int32_t* counts, Mask mask) HWY_ATTR {
        const Ints one = hn::IfThenElseZero(hn::RebindMask(I(), mask), hn::Set(I(), 1));
        hn::Store(hn::Add(hn::Load(I(), counts), one), I(), counts);
    };
    CountBlock& counted = (*out.counted)[at / kBlockPixels];
    count(&counted.arrived[in], inside), count(&counted.won[in], won);
}

// The lists of tiles jump about in the triangles.
HWY_INLINE void fetchAhead(const TrianglePiece& piece, std::span<const std::uint32_t> list, std::size_t n) {
    constexpr std::size_t kAhead = 8;
    if (n + kAhead < list.size() && !(list[n + kAhead] & TrianglePiece::kOther))
        hwy::Prefetch(&piece.small[list[n + kAhead]]);
}

TileCounts drawOther(const RasterTriangle<float>& t, Tile tile, bool perspective, bool whole, DrawnTile& out) {
    const LargeEdges edges(t, tile);
    if (edges.exact()) {
        const Distances distances(t.w[0], t.w[1], t.w[2]);
        const Mask everything = hn::Eq(hn::Zero(F()), hn::Zero(F()));
        Sums sums;
        forEachVector(edges, t, tile, [&](std::size_t at, const EdgesAt& e) HWY_ATTR {
            drawVector(at, e, distances, t.id, perspective, whole ? everything : within(tile, at), out, sums);
        });
        return sums.total();
    }
    TileCounts counts;
    forEachCovered(t.snapped, tile, [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) {
        const std::size_t at = placeOf(pixel - tile.min), in = at % kBlockPixels;
        SeenBlock& block = out.blocks[at / kBlockPixels];
        const float z = interpolate(t, e, perspective).z;
        const bool won = z < block.z[in];
        ++counts.arrived, counts.won += won;
        if (out.counted) {
            CountBlock& counted = (*out.counted)[at / kBlockPixels];
            ++counted.arrived[in], counted.won[in] += won;
        }
        if (won) block.z[in] = z, block.triangle[in] = t.id;
    });
    return counts;
}

}  // namespace

TileCounts drawTile(const View& view, const TrianglePieces& all, std::size_t index, ZBufferOutput<float>& out) {
    const Tile tile = tileOf(all.size, index);
    if (!all.touches(index)) {
        fillRows(kFar, tile, out.zView), fillRows(kNoTriangle, tile, out.triangle);
        return {};
    }
    DrawnTile drawn;
    std::optional<CountBlocks> counted;
    if (!out.overdraw.empty()) drawn.counted = &counted.emplace();
    const bool whole = tile.max - tile.min == glm::ivec2(kTileSize);
    Sums sums;
    TileCounts counts;
    const Mask everything = hn::Eq(hn::Zero(F()), hn::Zero(F()));
    for (const TrianglePiece& piece : all.pieces) {
        const auto list = piece.list(index);
        for (std::size_t n = 0; n < list.size(); ++n) {
            fetchAhead(piece, list, n);
            const std::uint32_t i = list[n];
            if (i & TrianglePiece::kOther) {
                const TileCounts more =
                    drawOther(piece.others[i & ~TrianglePiece::kOther], tile, view.perspective, whole, drawn);
                counts.arrived += more.arrived, counts.won += more.won;
                continue;
            }
            const SmallTriangle& t = piece.small[i];
            const Distances distances(t.w0, t.w1, t.w2);
            forEachVector(t, tile, [&](std::size_t at, const EdgesAt& edges) HWY_ATTR {
                drawVector(at, edges, distances, t.id, view.perspective, whole ? everything : within(tile, at), drawn,
                           sums);
            });
        }
    }
    constexpr std::size_t kStride = sizeof(SeenBlock) / sizeof(float), kCountStride = sizeof(CountBlock) / sizeof(int);
    writeRows(drawn.blocks[0].z, kStride, tile, out.zView);
    writeRows(drawn.blocks[0].triangle, kStride, tile, out.triangle);
    if (drawn.counted) {
        writeRows((*counted)[0].arrived, kCountStride, tile, out.overdraw);
        writeRows((*counted)[0].won, kCountStride, tile, out.depthWrites);
    }
    if (!out.barycentric.empty()) {
        std::array<WeightBlock, kBlocks> weights;
        forEachSeen(
            view, all, index, drawn.blocks[0].triangle, kStride, [](std::uint32_t) {},
            [&](std::size_t at, Mask mask, const Floats3& b) HWY_ATTR {
                float(&of)[3][kBlockPixels] = weights[at / kBlockPixels].of;
                hn::BlendedStore(b.x, mask, F(), &of[0][at % kBlockPixels]);
                hn::BlendedStore(b.y, mask, F(), &of[1][at % kBlockPixels]);
                hn::BlendedStore(b.z, mask, F(), &of[2][at % kBlockPixels]);
            });
        for (int y = 0; y < tile.max.y - tile.min.y; ++y) {
            Vec3<float>* to = &out.barycentric.at({tile.min.x, tile.min.y + y});
            for (int x = 0; x < tile.max.x - tile.min.x; ++x) {
                const std::size_t at = placeOf({x, y}), in = at % kBlockPixels;
                const float(&of)[3][kBlockPixels] = weights[at / kBlockPixels].of;
                to[x] = {of[0][in], of[1][in], of[2][in]};
            }
        }
    }
    const TileCounts small = sums.total();
    return {counts.arrived + small.arrived, counts.won + small.won};
}

void drawShadowTile(const View& face, const TrianglePieces& all, std::size_t index, Buffer2D<float>& depth) {
    const Tile tile = tileOf(all.size, index);
    if (!all.touches(index)) return fillRows(kFar, tile, depth);
    std::array<DepthBlock, kBlocks> blocks;
    std::fill_n(blocks[0].z, kTilePixels, kFar);
    for (const TrianglePiece& piece : all.pieces) {
        const auto list = piece.list(index);
        for (std::size_t n = 0; n < list.size(); ++n) {
            fetchAhead(piece, list, n);
            const std::uint32_t i = list[n];
            const auto draw = [&](const Distances& distances) HWY_ATTR {
                return [&, distances](std::size_t at, const EdgesAt& edges) HWY_ATTR {
                    float* to = &blocks[at / kBlockPixels].z[at % kBlockPixels];
                    const Floats z = distances.z(edges, face.perspective), stored = hn::Load(F(), to);
                    hn::Store(hn::IfThenElse(hn::And(edges.inside, hn::Lt(z, stored)), z, stored), F(), to);
                };
            };
            if (!(i & TrianglePiece::kOther)) {
                const SmallTriangle& t = piece.small[i];
                forEachVector(t, tile, draw(Distances(t.w0, t.w1, t.w2)));
                continue;
            }
            const RasterTriangle<float>& t = piece.others[i & ~TrianglePiece::kOther];
            const LargeEdges edges(t, tile);
            if (edges.exact()) {
                forEachVector(edges, t, tile, draw(Distances(t.w[0], t.w[1], t.w[2])));
                continue;
            }
            forEachCovered(t.snapped, tile, [&](glm::ivec2 texel, const std::array<std::int64_t, 3>& e) {
                const std::size_t at = placeOf(texel - tile.min);
                float& stored = blocks[at / kBlockPixels].z[at % kBlockPixels];
                stored = std::min(stored, interpolate(t, e, face.perspective).z);
            });
        }
    }
    writeRows(blocks[0].z, kBlockPixels, tile, depth);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(drawTile);
HWY_EXPORT(drawShadowTile);

TileCounts zBufferInVectors(const View& view, const TrianglePieces& pieces, std::size_t tile,
                            ZBufferOutput<float>& out) {
    return HWY_DYNAMIC_DISPATCH(drawTile)(view, pieces, tile, out);
}

void shadowBufferInVectors(const View& face, const TrianglePieces& pieces, std::size_t tile, Buffer2D<float>& depth) {
    HWY_DYNAMIC_DISPATCH(drawShadowTile)(face, pieces, tile, depth);
}

}  // namespace pipeline
#endif
