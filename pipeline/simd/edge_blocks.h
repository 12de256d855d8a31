// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_EDGE_BLOCKS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_EDGE_BLOCKS_H
#undef SHADESCOPE_EDGE_BLOCKS_H
#else
#define SHADESCOPE_EDGE_BLOCKS_H
#endif

#include <algorithm>
#include <bit>

#include "pipeline/simd/blocks.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Three edge functions. Not an array, because GCC keeps arrays of vectors in memory.
struct Edges {
    Ints e0, e1, e2;
};
HWY_INLINE Edges operator+(const Edges& a, const Edges& b) {
    return {hn::Add(a.e0, b.e0), hn::Add(a.e1, b.e1), hn::Add(a.e2, b.e2)};
}
// Negative where one of them is.
HWY_INLINE Ints outsideOf(const Edges& e) { return hn::Or(e.e0, hn::Or(e.e1, e.e2)); }

// Two edge functions, for blocks that are wholly inside; Inside takes the place of outsideOf.
struct InnerEdges {
    Ints e1, e2;
};
struct Inside {};
HWY_INLINE Inside outsideOf(const InnerEdges&) { return {}; }

// The arrangement of 16 blocks that are tested together: 4 × 4, 8 × 2 or 16 × 1, with the column and row of block k.
struct BlockGroup {
    explicit HWY_INLINE BlockGroup(int across) : widthBits(across <= 4 ? 2 : across <= 8 ? 3 : 4) {}
    int widthBits;
    int rows() const { return kBlockPixels >> widthBits; }
    // For the blocks in a vector, from block `first` on.
    HWY_INLINE Ints column(int first) const {
        return hn::And(hn::Iota(I(), first), hn::Set(I(), (1 << widthBits) - 1));
    }
    HWY_INLINE Ints row(int first) const { return hn::ShiftRightSame(hn::Iota(I(), first), widthBits); }
};

// Calls visit(at, e, w) for the vectors of all blocks in a range that the edge functions leave partly inside. edges:
// those of a triangle, negative outside; their steps to the next pixel sum to 0. at: the vector's first pixel in the
// tile's blocks; e: the edge functions at its pixels; w: the plane's, with kPlane. Blocks with pixels inside are found
// first, one block in each lane, and then visited in one loop. A CPU cannot predict where a row of blocks ends in a
// triangle, and a wrong prediction takes as long as drawing two blocks. N. Greene, "Hierarchical polygon tiling with
// coverage masks", SIGGRAPH 1996. kLarge: blocks that are wholly inside, of which small triangles have few, get a loop
// of their own with InnerEdges.
template <bool kPlane, bool kLarge, class Visit>
HWY_INLINE void forEachVector(const PixelFunction& edge0, const PixelFunction& edge1, const PixelFunction& edge2,
                              const PlaneInTile& plane, const BlockRange& range, Visit visit) {
    const int across = range.maxX - range.minX, down = range.maxY - range.minY;
    if (across <= 0 || down <= 0) return;
    using Wraps = std::uint32_t;
    // The largest and the smallest offset from a block's first pixel; both are at a corner of the block.
    const auto most = [](const PixelFunction& edge) {
        const Wraps right = Wraps(std::max(edge.column, 0)), below = Wraps(std::max(edge.row, 0));
        return hn::Set(I(), std::int32_t((right + below) * Wraps(kBlock - 1)));
    };
    const auto least = [](const PixelFunction& edge) {
        const Wraps right = Wraps(std::min(edge.column, 0)), below = Wraps(std::min(edge.row, 0));
        return hn::Set(I(), std::int32_t((right + below) * Wraps(kBlock - 1)));
    };
    const Edges mosts{most(edge0), most(edge1), most(edge2)}, leasts{least(edge0), least(edge1), least(edge2)};
    const Ints column1 = hn::Set(I(), edge1.column), row1 = hn::Set(I(), edge1.row);
    const Ints column2 = hn::Set(I(), edge2.column), row2 = hn::Set(I(), edge2.row);
    const auto more = [&](Ints column, Ints row) HWY_ATTR {
        const Ints one = hn::Add(hn::Mul(column1, column), hn::Mul(row1, row));
        const Ints two = hn::Add(hn::Mul(column2, column), hn::Mul(row2, row));
        return Edges{hn::Neg(hn::Add(one, two)), one, two};
    };
    const BlockGroup group(across);
    const int rows = group.rows(), left = range.minX * kBlock, top = range.minY * kBlock;
    const std::uint32_t width = 1U << group.widthBits;
    // The columns of the range, as bits in each row of a group.
    const std::uint32_t columns = ((1U << across) - 1) * (rows == 4 ? 0x1111U : rows == 2 ? 0x101U : 1U);
    const std::int32_t first0 = edge0.atPixel(left, top), first1 = edge1.atPixel(left, top),
                       first2 = edge2.atPixel(left, top);
    Edges within[kVectors];  // difference to the block's first pixel, at each pixel of a block
    Floats planeWithin[kVectors];
    for (int v = 0; v < kVectors; ++v) {
        within[v] = more(columnOf(v * kLanes), rowOf(v * kLanes));
        planeWithin[v] = kPlane ? plane.within(columnOf(v * kLanes), rowOf(v * kLanes)) : hn::Zero(F());
    }
    constexpr int kGroups = 4;  // bits of as many groups fit in a word
    HWY_ALIGN std::int32_t e0[kGroups * kBlockPixels], e1[kGroups * kBlockPixels], e2[kGroups * kBlockPixels];
    HWY_ALIGN float w[kGroups * kBlockPixels];
    for (int y = 0; y < down; y += kGroups * rows) {
        std::uint64_t inside = 0, whole = 0;
        for (int v = 0; v < kVectors; ++v) {
            const Ints column = hn::ShiftLeft<2>(group.column(v * kLanes));
            Ints row = hn::Add(hn::ShiftLeft<2>(group.row(v * kLanes)), hn::Set(I(), y * kBlock));
            Edges here = Edges{hn::Set(I(), first0), hn::Set(I(), first1), hn::Set(I(), first2)} + more(column, row);
            const Edges step = more(hn::Zero(I()), hn::Set(I(), rows * kBlock));
            for (int g = 0; g < kGroups && y + g * rows < down; ++g) {
                const int place = g * kBlockPixels + v * kLanes;
                const auto areInside = [&](const Edges& edges) HWY_ATTR {
                    return std::uint64_t(bitsOf(asFloats(hn::Gt(outsideOf(edges), hn::Set(I(), -1))))) << place;
                };
                inside |= areInside(here + mosts);
                if constexpr (kLarge) whole |= areInside(here + leasts);
                hn::Store(here.e0, I(), e0 + place), hn::Store(here.e1, I(), e1 + place);
                hn::Store(here.e2, I(), e2 + place);
                here = here + step;
                if constexpr (kPlane) {
                    hn::Store(plane.atBlocks(hn::Add(column, hn::Set(I(), left)), hn::Add(row, hn::Set(I(), top))), F(),
                              w + place);
                    row = hn::Add(row, hn::Set(I(), rows * kBlock));
                }
            }
        }
        inside &= columns * 0x0001000100010001U;
        if (const int last = (down - y) * int(width); last < 64) inside &= (std::uint64_t(1) << last) - 1;
        const std::size_t corner = std::size_t(range.minY + y) * kBlocksAcross + std::size_t(range.minX);
        const auto visitBlocks = [&](std::uint64_t bits, auto edgesAt) HWY_ATTR {
            for (; bits != 0; bits &= bits - 1) {
                const auto place = std::size_t(std::countr_zero(bits));
                const std::size_t block = corner + (place >> group.widthBits) * kBlocksAcross + (place & (width - 1));
                for (int v = 0; v < kVectors; ++v)
                    visit(block * kBlockPixels + std::size_t(v) * kLanes, edgesAt(place, v),
                          kPlane ? hn::Add(hn::Set(F(), w[place]), planeWithin[v]) : hn::Zero(F()));
            }
        };
        visitBlocks(inside & ~whole, [&](std::size_t place, int v) HWY_ATTR {
            return Edges{hn::Set(I(), e0[place]), hn::Set(I(), e1[place]), hn::Set(I(), e2[place])} + within[v];
        });
        if constexpr (kLarge)
            visitBlocks(inside & whole, [&](std::size_t place, int v) HWY_ATTR {
                return InnerEdges{hn::Add(hn::Set(I(), e1[place]), within[v].e1),
                                  hn::Add(hn::Set(I(), e2[place]), within[v].e2)};
            });
    }
}

// Calls visit(at, e, w) for the vectors of all blocks in a range. For few blocks, drawing nothing in some of them takes
// no longer than finding the others.
template <class Visit>
HWY_INLINE void forEachVectorOfAll(const SmallTriangle& t, Tile tile, const PlaneInTile& plane, const BlockRange& range,
                                   Visit visit) {
    const auto of = [](std::int32_t value) HWY_ATTR { return hn::Set(I(), value); };
    const auto less = [](Ints sum, Ints one, Ints two) HWY_ATTR { return hn::Sub(hn::Sub(sum, one), two); };
    const auto steps = [&](Ints one, Ints two) HWY_ATTR { return Edges{less(hn::Zero(I()), one, two), one, two}; };
    const Ints a1 = of(t.a1), b1 = of(t.b1), c1 = of(t.c1), a2 = of(t.a2), b2 = of(t.b2), c2 = of(t.c2);
    static_assert(kBlock == 4);
    const Edges right = steps(hn::ShiftLeft<2>(a1), hn::ShiftLeft<2>(a2));
    const Edges down = steps(hn::ShiftLeft<2>(b1), hn::ShiftLeft<2>(b2));
    Edges first[kVectors];
    Floats planeWithin[kVectors];
    const Ints left = of(tile.min.x + range.minX * kBlock - t.x), top = of(tile.min.y + range.minY * kBlock - t.y);
    for (int v = 0; v < kVectors; ++v) {
        const Ints column = columnOf(v * kLanes), row = rowOf(v * kLanes);
        const Ints x = hn::Add(left, column), y = hn::Add(top, row);
        const auto start = [&](Ints a, Ints b, Ints c)
                               HWY_ATTR { return hn::Add(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), c); };
        const Ints e1 = start(a1, b1, c1), e2 = start(a2, b2, c2);
        first[v] = {less(of(t.area), e1, e2), e1, e2};
        planeWithin[v] = plane.within(column, row);
    }
    for (int y = range.minY; y < range.maxY; ++y) {
        Edges e[kVectors];
        for (int v = 0; v < kVectors; ++v) e[v] = first[v], first[v] = first[v] + down;
        for (int x = range.minX; x < range.maxX; ++x) {
            const Floats w = hn::Set(F(), plane.atBlock(x * kBlock, y * kBlock));
            for (int v = 0; v < kVectors; ++v) {
                visit(blockAt(x, y) + std::size_t(v) * kLanes, e[v], hn::Add(w, planeWithin[v]));
                e[v] = e[v] + right;
            }
        }
    }
}

// Calls visit(at, outside, w) for the vectors of the tile that a small triangle touches. at: the first pixel in the
// blocks; outside: negative where a pixel is outside.
template <class Visit>
HWY_INLINE void forEachVector(const SmallTriangle& t, Tile tile, Visit visit) {
    const glm::ivec2 low(t.x, t.y), high = low + glm::ivec2(t.width, t.height), from = tile.min - low;
    const PlaneInTile plane(t.first, t.column, t.row, (low & ~(kBlock - 1)) - tile.min);
    const auto visitEdges = [&](std::size_t at, const Edges& e, Floats w) HWY_ATTR { visit(at, outsideOf(e), w); };
    constexpr int kFew = 12;
    const BlockRange range(low, high, tile);
    if ((range.maxX - range.minX) * (range.maxY - range.minY) <= kFew)
        return forEachVectorOfAll(t, tile, plane, range, visitEdges);
    using Wraps = std::uint32_t;  // exact wherever an edge function fits: up to three pixels beyond the box
    const auto edgeFrom = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        return PixelFunction{PixelFunction{c, a, b}.atPixel(from.x, from.y), a, b};
    };
    const PixelFunction edge1 = edgeFrom(t.a1, t.b1, t.c1), edge2 = edgeFrom(t.a2, t.b2, t.c2);
    const auto rest = [](std::int32_t sum, std::int32_t one, std::int32_t two) {
        return std::int32_t(Wraps(sum) - Wraps(one) - Wraps(two));
    };
    const PixelFunction edge0{rest(t.area, edge1.value, edge2.value), rest(0, t.a1, t.a2), rest(0, t.b1, t.b2)};
    forEachVector<true, false>(edge0, edge1, edge2, plane, range, visitEdges);
}

// The same for a triangle of up to some thousands of pixels. outside: Inside if no lane is outside.
template <class Visit>
HWY_INLINE void forEachVector(const MiddleEdges& middle, const RasterTriangle<float>& t, Tile tile, Visit visit) {
    const PixelFunction &edge0 = middle.edge(0), &edge1 = middle.edge(1), &edge2 = middle.edge(2);
    const Tile box = t.snapped.pixels();
    const BlockRange range(box.min, box.max, tile);
    const PlaneInTile plane(t.plane, tile);
    if (t.plane.holds)
        return forEachVector<true, true>(edge0, edge1, edge2, plane, range,
                                         [&](std::size_t at, auto e, Floats w)
                                             HWY_ATTR { visit(at, outsideOf(e), w); });
    const Distances distances(t.w[0], t.w[1], t.w[2]);
    forEachVector<false, true>(edge0, edge1, edge2, plane, range, [&](std::size_t at, auto e, Floats) HWY_ATTR {
        visit(at, outsideOf(e), distances.w(middle.linear(e.e1, 1), middle.linear(e.e2, 2)));
    });
}

// The same for any other triangle whose edge functions double holds.
template <class Visit>
HWY_INLINE void forEachVector(const LargeEdges& large, const RasterTriangle<float>& t, Tile tile, Visit visit) {
    const Distances distances(t.w[0], t.w[1], t.w[2]);
    const PlaneInTile plane(t.plane, tile);
    const Tile box = t.snapped.pixels();
    const BlockRange blocks(box.min, box.max, tile);
    const EdgeRows rows = large.rows();
    for (int y = blocks.minY; y < blocks.maxY; ++y) {
        const auto [left, right] = rows.blocksInRow(y, blocks.minX, blocks.maxX);
        for (std::size_t first = 0; first < kBlockPixels; first += kLanes) {
            std::size_t at = blockAt(left, y) + first;
            for (int x = left; x < right; ++x, at += kBlockPixels) {
                const VectorPlace place(at);
                const EdgesAt edges = large.at(place);
                visit(at, edges.outside, t.plane.holds ? plane.at(place) : distances.w(edges.l1, edges.l2));
            }
        }
    }
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
