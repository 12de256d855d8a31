#include "pipeline/simd/rasterize.h"

#include <array>
#include <memory>
#include <type_traits>

#include "pipeline/simd/fetch_ahead.h"
#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/rasterize.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/edge_blocks.h"
#include "pipeline/simd/seen.h"
#include "pipeline/simd/triangle_runs.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

constexpr float kFar = SeenBlocks::kNowhere;

// The number of fragments in each pixel of a tile.
struct CountedTile {
    std::array<Block<std::int32_t>, kBlocks> arrived{}, won{};
};

// Stores with SIMD: std::fill becomes memset here, which does not profit from cache lines that are already being
// fetched.
template <class T>
HWY_INLINE void fillTileOf(BlockBuffer2D<T>& buffer, std::size_t index, T value) {
    const hn::CappedTag<T, 16> d;
    const auto all = hn::Set(d, value);
    T* const to = numbersOf(buffer.tile(index));
    for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(d)) hn::Store(all, d, to + i);
}

struct DrawnTile {
    Block<float>* z;
    Block<std::uint32_t>* name;  // null if not requested
    CountedTile* counted;        // null if not requested
};

// Counts in each lane, so that the sum stays in a register.
HWY_INLINE void countWhere(Mask mask, Ints& sum) {
    sum = hn::IfThenElse(hn::RebindMask(I(), mask), hn::Add(sum, hn::Set(I(), 1)), sum);
}
HWY_INLINE std::int32_t total(Ints sum) { return hn::GetLane(hn::SumOfLanes(I(), sum)); }

// The number of fragments so far, counted in each lane.
class Sums {
public:
    HWY_INLINE Sums() : m_arrived(hn::Zero(I())), m_won(hn::Zero(I())) {}
    HWY_INLINE void add(Mask inside, Mask won) { countWhere(inside, m_arrived), countWhere(won, m_won); }
    HWY_INLINE void addTo(TileCounts& counts) const { counts.arrived += total(m_arrived), counts.won += total(m_won); }

private:
    Ints m_arrived, m_won;
};

HWY_INLINE Floats nowhereOutside(Ints outside, Floats z) {
    return hn::BitCast(F(), hn::IfNegativeThenElse(outside, hn::BitCast(I(), all(kFar)), hn::BitCast(I(), z)));
}
HWY_INLINE Floats nowhereOutside(Inside, Floats z) { return z; }
HWY_INLINE Mask isInside(Ints outside) { return asFloats(hn::Gt(outside, hn::Set(I(), -1))); }
HWY_INLINE Mask isInside(Inside) { return hn::FirstN(F(), kLanes); }

// For a triangle that is not small: calls visit(at, outside, w) for the vectors of the tile that it touches. If its
// edge functions do not fit SIMD lanes, it calls visitPixel(pixel, e) for its pixels instead.
template <class Visit, class VisitPixel>
HWY_INLINE void forEachOfOther(const RasterTriangle<float>& t, Tile tile, int bits, Visit visit,
                               VisitPixel visitPixel) {
    if (const MiddleEdges middle(t, tile, bits); middle.fits()) return forEachVector(middle, t, tile, visit);
    if (const LargeEdges large(t, tile); large.exact()) return forEachVector(large, t, tile, visit);
    forEachCovered(t.snapped, tile, visitPixel);
}

// Draws triangles into a tile. kPlain: all pixels of the blocks are in the picture, and fragments are not counted per
// pixel. kNames: the visible triangle of each pixel is stored too.
template <bool kPerspective, bool kPlain, bool kNames>
class TileDrawer {
public:
    TileDrawer(const SetUpInputs& in, Tile tile, const DrawnTile& out, BlocksAhead next)
        : m_bits(in.view.subPixelBits), m_tile(tile), m_out(out), m_next(next) {}

    HWY_NOINLINE TileCounts draw(const TrianglePieces& all, std::size_t index) {
        for (std::size_t number = 0; number < all.pieces.size(); ++number) {
            const TrianglePiece& piece = all.pieces[number];
            FetchedAhead ahead(piece, piece.list(index));
            for (std::span<const TriangleRun> left = piece.list(index); !left.empty();) {
                if (const std::size_t small = smallOnes(left); small > 0) {
                    drawSmall(piece, left.first(small), ahead), left = left.subspan(small);
                    continue;
                }
                const TriangleRun run = left.front();
                left = left.subspan(1);
                if (run.first & TriangleRun::kTiny)
                    drawFragments(piece.fragments, run);
                else
                    forEachOther(piece, run, [&](const RasterTriangle<float>& t, std::uint32_t i) {
                        drawOther(t, TrianglePieces::nameOfOther(number, i));
                    });
            }
        }
        return m_counts;
    }

private:
    HWY_INLINE void drawFragments(const Fragments& fragments, TriangleRun run) {
        if constexpr (kNames)
            forEachFragment(fragments, run, [&](std::size_t at, float z, std::uint32_t id) { drawPixel(at, z, id); });
        else
            forEachFragment(fragments, run, [&](std::size_t at, float z) { drawPixel(at, z, 0); });
    }
    HWY_INLINE void drawPixel(std::size_t at, float z, std::uint32_t name) {
        float& stored = numbersOf(m_out.z)[at];
        const bool won = z < stored;
        stored = won ? z : stored;
        if constexpr (kNames) numbersOf(m_out.name)[at] = won ? name : numbersOf(m_out.name)[at];
        ++m_counts.arrived, m_counts.won += won;
        if (!kPlain && m_out.counted)
            ++numbersOf(m_out.counted->arrived.data())[at], numbersOf(m_out.counted->won.data())[at] += won;
    }
    // Draws runs of small triangles. A function of its own, so that the sums stay in registers.
    HWY_NOINLINE void drawSmall(const TrianglePiece& piece, std::span<const TriangleRun> runs, FetchedAhead& ahead) {
        Sums sums;
        std::uint32_t i = 0;
        while (!runs.empty()) {
            ahead.fetch();
            if constexpr (kNames) m_next.fetch();  // for depth alone the CPU's own prefetching is enough
            const SmallTriangle& t = piece.small[runs.front().first + i];
            if (++i == runs.front().count) i = 0, runs = runs.subspan(1);
            forEachVector(t, m_tile, [&](std::size_t at, Ints outside, Floats w) HWY_ATTR {
                drawVector(at, isInside(outside), w, hn::Set(U(), t.id), sums);
            });
        }
        sums.addTo(m_counts);
    }
    HWY_NOINLINE void drawOther(const RasterTriangle<float>& t, std::uint32_t name) {
        Sums sums;
        const auto names = hn::Set(U(), name);
        forEachOfOther(
            t, m_tile, m_bits,
            [&](std::size_t at, auto outside, Floats w) HWY_ATTR { drawVector(at, isInside(outside), w, names, sums); },
            [&](glm::ivec2 pixel, const std::array<std::int64_t, 3>& e) {
                drawPixel(placeOf(pixel - m_tile.min), interpolate(t, pixel, e, kPerspective).z, name);
            });
        sums.addTo(m_counts);
    }
    // Draws a triangle's fragments in one vector.
    HWY_INLINE void drawVector(std::size_t at, Mask inside, Floats w, hn::Vec<U> name, Sums& sums) {
        float* const to = numbersOf(m_out.z) + at;
        if (!kPlain) inside = hn::And(inside, within(m_tile, at));
        const Floats z = zOf<kPerspective>(w);
        const Floats stored = hn::Load(F(), to);
        const Mask won = hn::And(inside, hn::Lt(z, stored));
        sums.add(inside, won);
        // Stores the whole vector: the next triangle may load the same block, and masked stores are not forwarded to
        // loads.
        hn::Store(hn::IfThenElse(won, z, stored), F(), to);
        if constexpr (kNames) {
            std::uint32_t* const seen = numbersOf(m_out.name) + at;
            hn::Store(hn::IfThenElse(hn::RebindMask(U(), won), name, hn::Load(U(), seen)), U(), seen);
        }
        if (kPlain || !m_out.counted) return;
        const auto count = [&](std::int32_t* counts, Mask mask) HWY_ATTR {
            hn::Store(hn::Sub(hn::Load(I(), counts), hn::VecFromMask(I(), hn::RebindMask(I(), mask))), I(), counts);
        };
        count(numbersOf(m_out.counted->arrived.data()) + at, inside);
        count(numbersOf(m_out.counted->won.data()) + at, won);
    }

    int m_bits;
    Tile m_tile;
    DrawnTile m_out;
    BlocksAhead m_next;
    TileCounts m_counts;
};

// False if the vertices were swapped to make the triangle clockwise. A clipped triangle counts as facing.
bool facesViewer(const RasterTriangle<float>& t) {
    int own[3]{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec3<float>& w = t.weights[corner];
        if (w.x != 1 && w.y != 1 && w.z != 1) return true;
        own[corner] = w.x == 1 ? 0 : w.y == 1 ? 1 : 2;
    }
    return own[1] != (own[0] + 1) % 3;
}

// The farthest stored depth in each square of a tile.
class Farthest {
public:
    explicit Farthest(const Block<float>* blocks) {
        for (int y = 0; y < kAcross; ++y)
            for (int x = 0; x < kAcross; ++x) {
                Floats most = all(-kFar);
                for (int row = 0; row < kSide / kBlock; ++row) {
                    const float* from = numbersOf(blocks) + blockAt(x * kSide / kBlock, y * kSide / kBlock + row);
                    for (std::size_t i = 0; i < std::size_t(kSide) * kBlock; i += hn::Lanes(F()))
                        most = hn::Max(most, hn::Load(F(), from + i));
                }
                m_of[y][x] = hn::GetLane(hn::MaxOfLanes(F(), most));
            }
    }
    // True if no pixel of a triangle can be nearer than the stored depth. w of its vertices is from `low` to `high`;
    // box: its pixels.
    bool hides(float low, float high, Tile box, Tile tile, bool perspective) const {
        // w errs by less than 2^-19 of the largest |w|. The plane's w errs by 3 + 8 kSteepest halves of a last place.
        // The w from weights takes two products and three sums of at most twice that size, and weights with four
        // roundings. The reciprocal doubles the error.
        static_assert(kSteepest <= 1);
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

// Writes the barycentric weights of a tile as rows of pixels.
void writeWeights(const SetUpInputs& inputs, const SeenBlocks& seen, std::size_t index, Buffer2D<Vec3<float>>& out) {
    const Tile tile = tileOf(seen.pieces.size, index);
    const SeenIn in{inputs.view, inputs.topology, *inputs.vertices, seen.pieces, tile, numbersOf(seen.z.tile(index))};
    SeenTriangle triangle;
    std::unique_ptr<SeenTriangle::Other> other;
    std::uint32_t name = kNoTriangle;
    for (std::size_t at = 0; at < kTilePixels; at += hn::Lanes(F())) {
        HWY_ALIGN float of[3][16]{};
        const std::uint32_t* const names = numbersOf(seen.name.tile(index)) + at;
        for (Mask left = seenIn(in.z + at); !hn::AllFalse(F(), left);) {
            const std::uint32_t next = names[hn::FindKnownFirstTrue(F(), left)];
            if (next != name) name = next, triangle.become(in, name, other);
            const Mask mask = hn::And(left, seesIn(names, name));
            left = hn::AndNot(mask, left);
            const Shares b = triangle.weights(in, VectorPlace(at), in.zAt(VectorPlace(at)));
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

TileCounts drawTile(const SetUpInputs& in, std::size_t index, SeenBlocks& seen, ZBufferOutput<float>& out) {
    const TrianglePieces& all = seen.pieces;
    const Tile tile = tileOf(all.size, index);
    if (!all.touches(index)) return {};
    const bool hasNames = !seen.name.blocks.empty();
    fillTileOf(seen.z, index, kFar);
    // Not std::optional: GCC zeroes its storage even when it is empty, which takes as long as clearing all the depths.
    const auto counted = out.overdraw.empty() ? nullptr : std::make_unique<CountedTile>();
    const DrawnTile drawn{seen.z.tile(index), hasNames ? seen.name.tile(index) : nullptr, counted.get()};
    const BlocksAhead next = BlocksAhead::from(index + 1, seen.z, hasNames ? &seen.name : nullptr);
    const glm::ivec2 size = tile.max - tile.min;
    const bool isPlain = !counted && size.x % kBlock == 0 && size.y % kBlock == 0;
    const auto draw = [&](auto perspective, auto names) {
        constexpr bool kPerspective = decltype(perspective)::value, kNames = decltype(names)::value;
        return isPlain ? TileDrawer<kPerspective, true, kNames>(in, tile, drawn, next).draw(all, index)
                       : TileDrawer<kPerspective, false, kNames>(in, tile, drawn, next).draw(all, index);
    };
    const auto drawSeen = [&](auto perspective) {
        return hasNames ? draw(perspective, std::true_type()) : draw(perspective, std::false_type());
    };
    TileCounts counts = in.view.perspective ? drawSeen(std::true_type()) : drawSeen(std::false_type());
    Ints shown = hn::Zero(I());
    for (std::size_t at = 0; at < kTilePixels; at += hn::Lanes(F())) countWhere(seenIn(numbersOf(drawn.z) + at), shown);
    counts.seen = total(shown);
    if (counted) {
        copyRows(counted->arrived.data(), tile, out.overdraw);
        copyRows(counted->won.data(), tile, out.depthWrites);
    }
    if (!out.barycentric.empty()) writeWeights(in, seen, index, out.barycentric);
    return counts;
}

// Draws triangles into a tile of a shadow buffer. The nearest depth remains in any order. Triangles that face the light
// are drawn first, because in a solid they hide the others. Fragments of tiny triangles are drawn at once: testing them
// would take as long.
template <bool kPerspective>
class ShadowDrawer {
public:
    ShadowDrawer(const SetUpInputs& in, Tile tile, Block<float>* blocks, BlocksAhead next)
        : m_bits(in.view.subPixelBits), m_tile(tile), m_blocks(blocks), m_next(next) {}

    HWY_NOINLINE void draw(const TrianglePieces& all, std::size_t index) {
        std::vector<const SmallTriangle*> rest;
        std::vector<const RasterTriangle<float>*> otherRest;
        for (const TrianglePiece& piece : all.pieces) {
            FetchedAhead ahead(piece, piece.list(index));
            for (const TriangleRun run : piece.list(index)) {
                if (run.first & TriangleRun::kTiny)
                    forEachFragment(piece.fragments, run, [&](std::size_t at, float z) { drawTexel(at, z); });
                else if (run.first & TriangleRun::kOther)
                    forEachOther(piece, run, [&](const RasterTriangle<float>& t, std::uint32_t) {
                        facesViewer(t) ? drawOther(t) : otherRest.push_back(&t);
                    });
                else
                    forEachSmall(piece, run, ahead, [&](const SmallTriangle& t) HWY_ATTR {
                        m_next.fetch();
                        t.facesViewer ? drawSmall(t) : rest.push_back(&t);
                    });
            }
        }
        if (rest.empty() && otherRest.empty()) return;
        const Farthest farthest(m_blocks);
        const auto isHidden = [&](float low, float high, Tile box) {
            return farthest.hides(low, high, box, m_tile, kPerspective);
        };
        for (const RasterTriangle<float>* t : otherRest) {
            const auto [low, high] = std::ranges::minmax(t->w);
            if (!isHidden(low, high, t->snapped.pixels())) drawOther(*t);
        }
        for (const SmallTriangle* t : rest) {
            const glm::ivec2 low(t->x, t->y);
            if (!isHidden(t->leastW, t->mostW, {low, low + glm::ivec2(t->width, t->height)})) drawSmall(*t);
        }
    }

private:
    HWY_INLINE void drawSmall(const SmallTriangle& t) {
        forEachVector(t, m_tile, [&](std::size_t at, Ints outside, Floats w) HWY_ATTR { drawVector(at, outside, w); });
    }
    HWY_INLINE void drawTexel(std::size_t at, float z) {
        float& stored = numbersOf(m_blocks)[at];
        stored = std::min(stored, z);
    }
    HWY_NOINLINE void drawOther(const RasterTriangle<float>& t) {
        forEachOfOther(
            t, m_tile, m_bits, [&](std::size_t at, auto outside, Floats w) HWY_ATTR { drawVector(at, outside, w); },
            [&](glm::ivec2 texel, const std::array<std::int64_t, 3>& e) {
                drawTexel(placeOf(texel - m_tile.min), interpolate(t, texel, e, kPerspective).z);
            });
    }
    HWY_INLINE void drawVector(std::size_t at, auto outside, Floats w) {
        float* const to = numbersOf(m_blocks) + at;
        const Floats z = nowhereOutside(outside, zOf<kPerspective>(w));
        hn::Store(hn::Min(z, hn::Load(F(), to)), F(), to);
    }

    int m_bits;
    Tile m_tile;
    Block<float>* m_blocks;
    BlocksAhead m_next;
};

void drawShadowTile(const SetUpInputs& in, const TrianglePieces& all, std::size_t index, bool isFirst,
                    BlockBuffer2D<float>& depth) {
    const Tile tile = tileOf(all.size, index);
    if (isFirst)
        fillTileOf(depth, index, kFar);
    else if (!all.touches(index))
        return;
    const BlocksAhead next = BlocksAhead::from(index + 1, depth, nullptr);
    if (in.view.perspective)
        ShadowDrawer<true>(in, tile, depth.tile(index), next).draw(all, index);
    else
        ShadowDrawer<false>(in, tile, depth.tile(index), next).draw(all, index);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(drawTile);
HWY_EXPORT(drawShadowTile);

TileCounts zBufferInVectors(const SetUpInputs& in, std::size_t tile, SeenBlocks& seen, ZBufferOutput<float>& out) {
    return HWY_DYNAMIC_DISPATCH(drawTile)(in, tile, seen, out);
}

void shadowBufferInVectors(const SetUpInputs& in, const TrianglePieces& pieces, std::size_t tile, bool isFirst,
                           BlockBuffer2D<float>& depth) {
    HWY_DYNAMIC_DISPATCH(drawShadowTile)(in, pieces, tile, isFirst, depth);
}

}  // namespace pipeline
#endif
