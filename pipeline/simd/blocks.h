// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_BLOCKS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_BLOCKS_H
#undef SHADESCOPE_BLOCKS_H
#else
#define SHADESCOPE_BLOCKS_H
#endif

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pipeline/simd/lanes.h"
#include "pipeline/simd/set_up.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// A tile as 16 × 16 blocks of 4 × 4 pixels, a block's pixels side by side: the part of a small triangle in a block is
// one vector, or a few. Whatever is known of a block stands together: arrays a power of two apart would share few lines
// of the cache.
constexpr int kBlock = 4, kBlockPixels = kBlock * kBlock, kBlocksAcross = kTileSize / kBlock;
constexpr std::size_t kBlocks = std::size_t(kBlocksAcross) * std::size_t(kBlocksAcross);
constexpr std::size_t kTilePixels = std::size_t(kTileSize) * std::size_t(kTileSize);

HWY_INLINE std::size_t blockAt(int x, int y) { return std::size_t(y * kBlocksAcross + x) * kBlockPixels; }

// Where the pixels of the vector from pixel `first` of a block on stand in it.
HWY_INLINE Ints columnOf(int first) { return hn::And(hn::Iota(I(), std::int32_t(first)), hn::Set(I(), kBlock - 1)); }
HWY_INLINE Ints rowOf(int first) { return hn::ShiftRight<2>(hn::Iota(I(), std::int32_t(first))); }

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

// A small triangle's edge functions at the pixels of one vector of a block, which it walks over blocks.
class SmallEdges {
public:
    // x, y: the first block's first pixel, relative to that of the triangle's box; first: the vector's in its block.
    HWY_INLINE SmallEdges(const SmallTriangle& t, int x, int y, int first)
        : m_above0(above(t, 0)),
          m_above1(above(t, 1)),
          m_above2(above(t, 2)),
          m_area(hn::Set(I(), t.area)),
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
        m_row1 = m_e1 = start(t.a1, t.b1, t.c1), m_row2 = m_e2 = start(t.a2, t.b2, t.c2);
    }
    HWY_INLINE Mask inside() const {
        const Ints e0 = hn::Sub(hn::Sub(m_area, m_e1), m_e2);
        return hn::RebindMask(F(),
                              hn::And(hn::Gt(e0, m_above0), hn::And(hn::Gt(m_e1, m_above1), hn::Gt(m_e2, m_above2))));
    }
    HWY_INLINE EdgesAt at(Mask inside) const {
        return {inside, hn::Mul(hn::ConvertTo(F(), m_e1), m_inverse), hn::Mul(hn::ConvertTo(F(), m_e2), m_inverse)};
    }
    HWY_INLINE void goRight() { m_e1 = hn::Add(m_e1, m_right1), m_e2 = hn::Add(m_e2, m_right2); }
    HWY_INLINE void goDown() { m_e1 = m_row1 = hn::Add(m_row1, m_down1), m_e2 = m_row2 = hn::Add(m_row2, m_down2); }

private:
    // Above -1 where the edge owns its samples, else above 0.
    HWY_INLINE static Ints above(const SmallTriangle& t, int edge) { return hn::Set(I(), -(t.owns >> edge & 1)); }
    Ints m_e1, m_e2, m_row1, m_row2, m_above0, m_above1, m_above2, m_area;
    Floats m_inverse;
    Ints m_right1, m_right2, m_down1, m_down2;
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
    // Of the blocks [min, max) in row y of blocks, those outside of which an edge function leaves no pixel; a few more,
    // for rounding.
    std::pair<int, int> blocksInRow(int y, int min, int max) const {
        double low = min, high = max;
        for (int i = 0; i < 3; ++i) {
            // Where the edge function is largest in the block: at one of its corners.
            const double atFirst = m_value[i] - m_bias[i] + m_row[i] * (kBlock * y + (m_row[i] > 0 ? kBlock - 1 : 0)) +
                                   std::max(m_column[i], 0.0) * (kBlock - 1);
            const double step = m_column[i] * kBlock;
            if (step == 0 && atFirst < 0) return {min, min};
            if (step > 0) low = std::max(low, std::floor(-atFirst / step));
            if (step < 0) high = std::min(high, std::ceil(-atFirst / step) + 1);
        }
        return {int(low), int(std::max(low, high))};
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
    double m_value[3], m_column[3], m_row[3], m_bias[3];
    float m_inverse;
    bool m_exact = true;
};

// interpolate's formulas, in its order.
struct Distances {
    Floats w0, toW1, toW2;
    HWY_INLINE Distances(float first, float second, float third)
        : w0(all(first)), toW1(all(second - first)), toW2(all(third - first)) {}
    HWY_INLINE Floats z(const EdgesAt& at, bool perspective) const {
        const Floats w = hn::Add(hn::Add(w0, hn::Mul(at.l1, toW1)), hn::Mul(at.l2, toW2));
        return perspective ? hn::Div(all(1), w) : w;
    }
};

// Rows of the picture from a tile's blocks. first: of the first block; `stride` numbers further stand those of the next.
template <class T>
HWY_INLINE void writeRows(const T* first, std::size_t stride, Tile tile, Buffer2D<T>& out) {
    const int width = tile.max.x - tile.min.x;
    for (int y = 0; y < tile.max.y - tile.min.y; ++y) {
        T* to = &out.pixels[out.offset({tile.min.x, tile.min.y + y})];
        const T* from = first + std::size_t(y / kBlock * kBlocksAcross) * stride + y % kBlock * kBlock;
        int x = 0;
        for (; x + kBlock <= width; x += kBlock, from += stride) std::memcpy(to + x, from, kBlock * sizeof(T));
        std::copy_n(from, width - x, to + x);
    }
}
// The other way round; what lies beyond the picture becomes `beyond`.
template <class T>
HWY_INLINE void readRows(const Buffer2D<T>& from, Tile tile, T beyond, T* first, std::size_t stride) {
    const int width = tile.max.x - tile.min.x, height = tile.max.y - tile.min.y;
    if (width < kTileSize || height < kTileSize)
        for (std::size_t block = 0; block < kBlocks; ++block) std::fill_n(first + block * stride, kBlockPixels, beyond);
    for (int y = 0; y < height; ++y) {
        const T* row = &from.pixels[from.offset({tile.min.x, tile.min.y + y})];
        T* to = first + std::size_t(y / kBlock * kBlocksAcross) * stride + y % kBlock * kBlock;
        int x = 0;
        for (; x + kBlock <= width; x += kBlock, to += stride) std::memcpy(to, row + x, kBlock * sizeof(T));
        std::copy_n(row + x, width - x, to);
    }
}
template <class T>
HWY_INLINE void fillRows(T value, Tile tile, Buffer2D<T>& out) {
    for (int y = tile.min.y; y < tile.max.y; ++y)
        std::fill_n(&out.pixels[out.offset({tile.min.x, y})], tile.max.x - tile.min.x, value);
}

// Calls visit(at, edges) for the vectors of the tile that a triangle covers a part of; at: of its first pixel in the
// blocks.
template <class Visit>
HWY_INLINE void forEachVector(const SmallTriangle& t, Tile tile, Visit visit) {
    const int lowX = t.x, lowY = t.y;
    const BlockRange blocks({lowX, lowY}, {lowX + t.width, lowY + t.height}, tile);
    const int lanes = int(hn::Lanes(F()));
    const int startX = tile.min.x + kBlock * blocks.minX - lowX, startY = tile.min.y + kBlock * blocks.minY - lowY;
    for (int first = 0; first < kBlockPixels; first += lanes) {
        SmallEdges edges(t, startX, startY, first);
        for (int y = blocks.minY; y < blocks.maxY; ++y, edges.goDown())
            for (int x = blocks.minX; x < blocks.maxX; ++x, edges.goRight()) {
                const Mask inside = edges.inside();
                if (!hn::AllFalse(F(), inside)) visit(blockAt(x, y) + std::size_t(first), edges.at(inside));
            }
    }
}
template <class Visit>
HWY_INLINE void forEachVector(const LargeEdges& edges, const RasterTriangle<float>& t, Tile tile, Visit visit) {
    const Tile box = t.snapped.pixels();
    const BlockRange blocks(box.min, box.max, tile);
    const int lanes = int(hn::Lanes(F()));
    for (int y = blocks.minY; y < blocks.maxY; ++y) {
        const auto [left, right] = edges.blocksInRow(y, blocks.minX, blocks.maxX);
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
