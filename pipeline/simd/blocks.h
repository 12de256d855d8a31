// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_BLOCKS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_BLOCKS_H
#undef SHADESCOPE_BLOCKS_H
#else
#define SHADESCOPE_BLOCKS_H
#endif

#include <algorithm>
#include <cmath>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/lanes.h"
#include "pipeline/simd/set_up.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

HWY_INLINE std::size_t blockAt(int x, int y) { return std::size_t(y * kBlocksAcross + x) * kBlockPixels; }

// Where the pixels of the vector from pixel `first` of a block on stand in it.
alignas(64) constexpr std::int32_t kColumns[kBlockPixels]{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr std::int32_t kRows[kBlockPixels]{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
HWY_INLINE Ints columnOf(int first) { return hn::Load(I(), kColumns + first); }
HWY_INLINE Ints rowOf(int first) { return hn::Load(I(), kRows + first); }

// The first pixel of the block that the vector at `at` of a tile is in, and the vector's first pixel in the block.
struct BlockPlace {
    int x, y, first;
    HWY_INLINE explicit BlockPlace(std::size_t at) {
        const int block = int(at) / kBlockPixels;
        x = block % kBlocksAcross * kBlock, y = block / kBlocksAcross * kBlock;
        first = hn::Lanes(F()) == kBlockPixels ? 0 : int(at) % kBlockPixels;
    }
};

// An affine function over the pixels of a tile, in 32 bits: exact wherever its value fits, for sums wrap round.
struct PixelFunction {
    std::int32_t value, column, row;  // at the tile's first pixel; more at the next column, at the next row

    std::int32_t atPixel(int x, int y) const {
        using Wraps = std::uint32_t;
        return std::int32_t(Wraps(value) + Wraps(column) * Wraps(x) + Wraps(row) * Wraps(y));
    }
};
// The same for those who ask for it in many blocks.
struct TileFunction : PixelFunction {
    alignas(64) std::int32_t steps[kBlockPixels];  // what a block's pixels have more than its first

    HWY_INLINE void become(std::int32_t first, std::int32_t right, std::int32_t down) {
        value = first, column = right, row = down;
        const Ints toRight = hn::Set(I(), column), toDown = hn::Set(I(), row);
        for (int i = 0; i < kBlockPixels; i += int(hn::Lanes(F())))
            hn::Store(hn::Add(hn::Mul(toRight, columnOf(i)), hn::Mul(toDown, rowOf(i))), I(), steps + i);
    }
    // x, y: the block's first pixel, relative to the tile's; first: the vector's first pixel in it.
    HWY_INLINE Ints at(int x, int y, int first) const {
        return hn::Add(hn::Set(I(), atPixel(x, y)), hn::Load(I(), steps + first));
    }
};

// A quantity that is linear in the picture: at a pixel, and what a step to the right and one down add.
struct Slope {
    float value, column, row;
};

// The blocks [min, max) of a tile that a box of pixels touches.
struct BlockRange {
    int minX, minY, maxX, maxY;
    BlockRange(glm::ivec2 low, glm::ivec2 high, Tile tile)
        : minX((std::max(low.x, tile.min.x) - tile.min.x) / kBlock),
          minY((std::max(low.y, tile.min.y) - tile.min.y) / kBlock),
          maxX((std::min(high.x, tile.max.x) - tile.min.x + kBlock - 1) / kBlock),
          maxY((std::min(high.y, tile.max.y) - tile.min.y + kBlock - 1) / kBlock) {}
};

// What of the edge functions of corners 1 and 2 has to be known at a pixel: e1 and e2 times inverseArea2 are its linear
// weights.
struct EdgesAt {
    Mask inside;
    Floats l1, l2;
};

// A small triangle's edge functions at the pixels of one vector of a block, which it walks over blocks: less 1 where the
// edge does not own its samples, so that a pixel is inside where none is below 0.
class SmallEdges {
public:
    // x, y: the first block's first pixel, relative to that of the triangle's box; first: the vector's in its block.
    HWY_INLINE SmallEdges(const SmallTriangle& t, int x, int y, int first)
        : m_bias1(hn::Set(I(), bias(t, 1))),
          m_bias2(hn::Set(I(), bias(t, 2))),
          m_sum(hn::Set(I(), t.area - bias(t, 0) - bias(t, 1) - bias(t, 2))),
          m_inverse(all(t.inverseArea2)),
          m_right1(hn::Set(I(), kBlock * t.a1)),
          m_right2(hn::Set(I(), kBlock * t.a2)),
          m_down1(hn::Set(I(), kBlock * t.b1)),
          m_down2(hn::Set(I(), kBlock * t.b2)) {
        const Ints column = columnOf(first), row = rowOf(first);
        const auto start = [&](int a, int b, int c) HWY_ATTR {
            return hn::Add(hn::Set(I(), c + a * x + b * y),
                           hn::Add(hn::Mul(hn::Set(I(), a), column), hn::Mul(hn::Set(I(), b), row)));
        };
        m_row1 = m_e1 = start(t.a1, t.b1, t.c1 - bias(t, 1)), m_row2 = m_e2 = start(t.a2, t.b2, t.c2 - bias(t, 2));
    }
    HWY_INLINE Mask inside() const {
        const Ints e0 = hn::Sub(hn::Sub(m_sum, m_e1), m_e2);
        return asFloats(hn::Gt(hn::Or(e0, hn::Or(m_e1, m_e2)), hn::Set(I(), -1)));
    }
    HWY_INLINE EdgesAt at(Mask inside) const {
        const auto share = [&](Ints e, Ints bias)
                               HWY_ATTR { return hn::Mul(hn::ConvertTo(F(), hn::Add(e, bias)), m_inverse); };
        return {inside, share(m_e1, m_bias1), share(m_e2, m_bias2)};
    }
    HWY_INLINE void goRight() { m_e1 = hn::Add(m_e1, m_right1), m_e2 = hn::Add(m_e2, m_right2); }
    HWY_INLINE void goDown() { m_e1 = m_row1 = hn::Add(m_row1, m_down1), m_e2 = m_row2 = hn::Add(m_row2, m_down2); }

private:
    HWY_INLINE static int bias(const SmallTriangle& t, int edge) { return t.owns >> edge & 1 ? 0 : 1; }
    Ints m_e1, m_e2, m_row1, m_row2, m_bias1, m_bias2, m_sum;
    Floats m_inverse;
    Ints m_right1, m_right2, m_down1, m_down2;
};

// A triangle's edge functions over a tile, for the rows of blocks that it has pixels in.
struct EdgeRows {
    double value[3], column[3], row[3];  // at the tile's first pixel, at least 0 where covered; more at the next pixel
    // Of the blocks [min, max) in row y of blocks, those outside of which an edge function leaves no pixel; a few more,
    // for rounding.
    std::pair<int, int> blocksInRow(int y, int min, int max) const {
        double low = min, high = max;
        for (int i = 0; i < 3; ++i) {
            // Where the edge function is largest in the block: at one of its corners.
            const double atFirst = value[i] + row[i] * (kBlock * y + (row[i] > 0 ? kBlock - 1 : 0)) +
                                   std::max(column[i], 0.0) * (kBlock - 1);
            const double step = column[i] * kBlock;
            if (step == 0 && atFirst < 0) return {min, min};
            if (step > 0) low = std::max(low, std::floor(-atFirst / step));
            if (step < 0) high = std::min(high, std::ceil(-atFirst / step) + 1);
        }
        return {int(low), int(std::max(low, high))};
    }
};

// Those of a triangle of up to some thousands of pixels, in a tile. From pixel to pixel an edge function grows by
// multiples of 2^bits steps²: how many of these it has, rounded down, fits into 32 bits, and what is below is the same
// everywhere.
class MiddleEdges {
public:
    // bits: of the grid that corners stand on.
    HWY_INLINE MiddleEdges(const RasterTriangle<float>& t, Tile tile, int bits)
        : m_bits(bits), m_unit(float(1 << bits)), m_inverse(std::ldexp(t.inverseArea2, 2 * (kSubPixelBits - bits))) {
        const auto& c = t.snapped.corners;
        const int drop = kSubPixelBits - bits;
        const glm::i64vec2 first = (glm::i64vec2(tile.min) << std::int64_t(bits)) + (std::int64_t(1) << (bits - 1));
        for (int i = 0; i < 3; ++i) {
            const EdgeFunction edge(c[std::size_t(i + 1) % 3], c[std::size_t(i + 2) % 3]);
            const std::int64_t dx = edge.dx >> drop, dy = edge.dy >> drop;
            const std::int64_t bias = edge.ownsBoundary() ? 0 : 1;
            const std::int64_t value = dx * (first.y - (edge.p.y >> drop)) - dy * (first.x - (edge.p.x >> drop)) - bias;
            const std::int64_t high = value >> bits;
            const std::int64_t most = std::abs(high) + (std::abs(dx) + std::abs(dy)) * kTileSize;
            m_fits = m_fits && most < (std::int64_t(1) << 31), m_isNarrow = m_isNarrow && most < (1 << 24);
            m_edges[i].become(std::int32_t(high), std::int32_t(-dy), std::int32_t(dx));
            m_below[i] = std::int32_t(value - (high << bits) + bias);
        }
    }
    bool fits() const { return m_fits; }  // else nothing of it holds
    EdgeRows rows() const {
        EdgeRows rows{};
        for (int i = 0; i < 3; ++i)
            rows.value[i] = m_edges[i].value, rows.column[i] = m_edges[i].column, rows.row[i] = m_edges[i].row;
        return rows;
    }
    // x, y: the block's first pixel, relative to the tile's; first: the vector's first pixel in it.
    HWY_INLINE EdgesAt at(int x, int y, int first) const {
        const Ints e0 = m_edges[0].at(x, y, first), e1 = m_edges[1].at(x, y, first), e2 = m_edges[2].at(x, y, first);
        const auto inside = hn::Gt(hn::Or(e0, hn::Or(e1, e2)), hn::Set(I(), -1));
        return {hn::RebindMask(F(), inside), linear(e1, 1), linear(e2, 2)};
    }
    // l1 or l2 alone.
    HWY_INLINE Floats linear(int i, int x, int y, int first) const { return linear(m_edges[i].at(x, y, first), i); }
    Slope slope(int i, glm::ivec2 first) const {
        const TileFunction& edge = m_edges[i];
        const float unit = m_unit * m_inverse;
        return {float(edge.atPixel(first.x, first.y)) * unit + float(m_below[i]) * m_inverse, float(edge.column) * unit,
                float(edge.row) * unit};
    }

private:
    // The edge function is rounded once: it is a sum of two numbers that have at most 24 bits each.
    HWY_INLINE Floats linear(Ints high, int i) const {
        if (HWY_LIKELY(m_isNarrow)) {
            const Floats above = hn::Mul(hn::ConvertTo(F(), high), all(m_unit));
            return hn::Mul(hn::Add(above, all(float(m_below[i]))), all(m_inverse));
        }
        const int split = 23 - m_bits;
        const Ints part = hn::And(high, hn::Set(I(), (1 << split) - 1));
        const Ints low = hn::Add(hn::ShiftLeftSame(part, m_bits), hn::Set(I(), m_below[i]));
        const Floats whole = hn::Add(hn::Mul(hn::ConvertTo(F(), hn::ShiftRightSame(high, split)), all(0x1p23F)),
                                     hn::ConvertTo(F(), low));
        return hn::Mul(whole, all(m_inverse));
    }
    TileFunction m_edges[3];
    int m_bits = 1;
    float m_unit = 2, m_inverse = 0;
    std::int32_t m_below[3]{};
    bool m_fits = true, m_isNarrow = true;  // whether 24 bits are enough
};

// Those of any other triangle, in double, from the tile's first pixel on.
class LargeEdges {
public:
    LargeEdges(const RasterTriangle<float>& t, Tile tile) : m_inverse(t.inverseArea2) {
        const auto& c = t.snapped.corners;
        const EdgeFunction edges[3]{{c[1], c[2]}, {c[2], c[0]}, {c[0], c[1]}};
        std::int64_t bits = kSubPixels / 2;
        for (const glm::i64vec2& corner : c) bits |= corner.x | corner.y;
        // Corners stand on a grid, and pixels' centres on one of half pixels: the edge functions are multiples of the
        // square of the finer step, and double holds 2^53 of these.
        const auto step = double(bits & -bits);
        for (int i = 0; i < 3; ++i) {
            m_value[i] = double(edges[i].atPixel(tile.min));
            m_column[i] = -double(edges[i].dy) * double(kSubPixels),
            m_row[i] = double(edges[i].dx) * double(kSubPixels);
            m_bias[i] = edges[i].ownsBoundary() ? 0 : 1;
            const double most = std::abs(m_value[i]) + (std::abs(m_column[i]) + std::abs(m_row[i])) * kTileSize;
            m_exact = m_exact && most < 0x1p53 * step * step;
        }
    }
    bool exact() const { return m_exact; }  // double holds all of them in the tile
    EdgeRows rows() const {
        EdgeRows rows{};
        for (int i = 0; i < 3; ++i)
            rows.value[i] = m_value[i] - m_bias[i], rows.column[i] = m_column[i], rows.row[i] = m_row[i];
        return rows;
    }
    // x, y: the block's first pixel, relative to the tile's; first: the vector's first pixel in it.
    HWY_INLINE EdgesAt at(int x, int y, int first) const {
        const Ints column = hn::Add(columnOf(first), hn::Set(I(), x));
        const Ints row = hn::Add(rowOf(first), hn::Set(I(), y));
        const Floats inverse = all(m_inverse);
#if HWY_TARGET == HWY_SCALAR  // whose vectors of one number have no halves
        const auto here = edges(column, row);
        return {hn::Ge(here.least, hn::Zero(F())), hn::Mul(here.e1, inverse), hn::Mul(here.e2, inverse)};
#else
        const hn::Half<I> half;
        const auto low = edges(hn::LowerHalf(half, column), hn::LowerHalf(half, row));
        const auto high = edges(hn::UpperHalf(half, column), hn::UpperHalf(half, row));
        return {hn::Ge(hn::Combine(F(), high.least, low.least), hn::Zero(F())),
                hn::Mul(hn::Combine(F(), high.e1, low.e1), inverse),
                hn::Mul(hn::Combine(F(), high.e2, low.e2), inverse)};
#endif
    }

private:
#if HWY_TARGET == HWY_SCALAR
    using H = F;
#else
    using H = hn::Half<F>;  // as many floats as there are doubles in a vector
#endif
    using D = hn::Rebind<double, H>;
    struct Values {
        hn::Vec<H> least, e1, e2;  // least: at least 0 where all three cover
    };
    HWY_INLINE Values edges(hn::Vec<hn::RebindToSigned<H>> columns, hn::Vec<hn::RebindToSigned<H>> rows) const {
        const D d;
        const auto x = hn::PromoteTo(d, columns), y = hn::PromoteTo(d, rows);
        const auto edge = [&](int i) HWY_ATTR {
            return hn::Add(hn::Add(hn::Set(d, m_value[i]), hn::Mul(y, hn::Set(d, m_row[i]))),
                           hn::Mul(x, hn::Set(d, m_column[i])));
        };
        const auto e0 = edge(0), e1 = edge(1), e2 = edge(2);
        const auto least = hn::Min(hn::Sub(e0, hn::Set(d, m_bias[0])),
                                   hn::Min(hn::Sub(e1, hn::Set(d, m_bias[1])), hn::Sub(e2, hn::Set(d, m_bias[2]))));
        return {hn::DemoteTo(H(), least), hn::DemoteTo(H(), e1), hn::DemoteTo(H(), e2)};
    }
    double m_value[3]{}, m_column[3]{}, m_row[3]{}, m_bias[3]{};
    float m_inverse = 0;
    bool m_exact = true;
};

// interpolate's formulas, in its order.
struct Distances {
    Floats w0, toW1, toW2;
    HWY_INLINE Distances(float first, float second, float third)
        : w0(all(first)), toW1(all(second - first)), toW2(all(third - first)) {}
    HWY_INLINE Floats z(Floats l1, Floats l2, bool perspective) const {
        const Floats w = hn::Add(hn::Add(w0, hn::Mul(l1, toW1)), hn::Mul(l2, toW2));
        return perspective ? hn::Div(all(1), w) : w;
    }
};

// Calls visit(at, edges) for the vectors of the tile that a triangle covers a part of; at: of its first pixel in the
// blocks. A small one also for the others of its box: to draw nothing costs less than a guess that fails.
template <class Visit>
HWY_INLINE void forEachVector(const SmallTriangle& t, Tile tile, Visit visit) {
    const int lowX = t.x, lowY = t.y;
    const BlockRange blocks({lowX, lowY}, {lowX + t.width, lowY + t.height}, tile);
    const int lanes = int(hn::Lanes(F()));
    const int startX = tile.min.x + kBlock * blocks.minX - lowX, startY = tile.min.y + kBlock * blocks.minY - lowY;
    for (int first = 0; first < kBlockPixels; first += lanes) {
        SmallEdges edges(t, startX, startY, first);
        for (int y = blocks.minY; y < blocks.maxY; ++y, edges.goDown())
            for (int x = blocks.minX; x < blocks.maxX; ++x, edges.goRight())
                visit(blockAt(x, y) + std::size_t(first), edges.at(edges.inside()));
    }
}
template <class Edges, class Visit>
HWY_INLINE void forEachVector(const Edges& edges, const RasterTriangle<float>& t, Tile tile, Visit visit) {
    const Tile box = t.snapped.pixels();
    const BlockRange blocks(box.min, box.max, tile);
    const int lanes = int(hn::Lanes(F()));
    const EdgeRows rows = edges.rows();
    for (int y = blocks.minY; y < blocks.maxY; ++y) {
        const auto [left, right] = rows.blocksInRow(y, blocks.minX, blocks.maxX);
        for (int x = left; x < right; ++x)
            for (int first = 0; first < kBlockPixels; first += lanes) {
                const EdgesAt at = edges.at(kBlock * x, kBlock * y, first);
                if (!hn::AllFalse(F(), at.inside)) visit(blockAt(x, y) + std::size_t(first), at);
            }
    }
}

// Where a pixel of a tile stands in its blocks.
HWY_INLINE std::size_t placeOf(glm::ivec2 pixel) {
    return blockAt(pixel.x / kBlock, pixel.y / kBlock) + std::size_t(pixel.y % kBlock * kBlock + pixel.x % kBlock);
}

// And which pixel of it stands there.
HWY_INLINE glm::ivec2 pixelOf(std::size_t at) {
    const int block = int(at) / kBlockPixels, place = int(at) % kBlockPixels;
    return {block % kBlocksAcross * kBlock + place % kBlock, block / kBlocksAcross * kBlock + place / kBlock};
}

// Blocks reach beyond a picture whose size 4 does not divide: those of their pixels count for nothing.
HWY_INLINE Mask within(Tile tile, std::size_t at) {
    const int block = int(at) / kBlockPixels, first = int(at) % kBlockPixels;
    const Ints x = hn::Add(columnOf(first), hn::Set(I(), block % kBlocksAcross * kBlock));
    const Ints y = hn::Add(rowOf(first), hn::Set(I(), block / kBlocksAcross * kBlock));
    return hn::RebindMask(F(), hn::And(hn::Lt(x, hn::Set(I(), tile.max.x - tile.min.x)),
                                       hn::Lt(y, hn::Set(I(), tile.max.y - tile.min.y))));
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
