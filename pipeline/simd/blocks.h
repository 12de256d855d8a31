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

// Column and row in a block of each lane, for the vector that starts at pixel `first` of the block.
alignas(64) constexpr std::int32_t kColumns[kBlockPixels]{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr std::int32_t kRows[kBlockPixels]{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
HWY_INLINE Ints columnOf(int first) { return hn::Load(I(), kColumns + first); }
HWY_INLINE Ints rowOf(int first) { return hn::Load(I(), kRows + first); }

constexpr int kLanes = int(hn::MaxLanes(F())), kVectors = kBlockPixels / kLanes;  // of a vector; of a block

// A vector of pixels in a tile. A lane's pixel is the first pixel of the block plus an offset in it.
struct VectorPlace {
    std::uint32_t at;  // index of its first pixel in the tile's blocks
    HWY_INLINE explicit VectorPlace(std::size_t place) : at(std::uint32_t(place)) {}
    HWY_INLINE glm::ivec2 block() const {  // the block's first pixel, in the tile
        constexpr std::uint32_t kAcross = kBlocksAcross, kPixels = kBlockPixels;
        return glm::ivec2(at / kPixels % kAcross, at / kPixels / kAcross) * kBlock;
    }
    HWY_INLINE Ints columnInBlock() const { return columnOf(first()); }
    HWY_INLINE Ints rowInBlock() const { return rowOf(first()); }
    HWY_INLINE Ints column() const { return hn::Add(columnInBlock(), hn::Set(I(), block().x)); }
    HWY_INLINE Ints row() const { return hn::Add(rowInBlock(), hn::Set(I(), block().y)); }

    HWY_INLINE int first() const {  // index of its first pixel in the block
        return kVectors == 1 ? 0 : int(at % std::uint32_t(kBlockPixels));
    }
};

// An affine function over the pixels of a tile, in 32 bits. Sums wrap round, so it is exact wherever the value fits.
struct PixelFunction {
    std::int32_t value, column, row;  // value at the tile's first pixel; step to the next column and to the next row

    std::int32_t atPixel(int x, int y) const {
        using Wraps = std::uint32_t;
        return std::int32_t(Wraps(value) + Wraps(column) * Wraps(x) + Wraps(row) * Wraps(y));
    }
    // Offset from the value at the block's first pixel, in these columns and rows of the block.
    HWY_INLINE Ints inBlock(Ints columns, Ints rows) const {
        return hn::Add(hn::Mul(hn::Set(I(), column), columns), hn::Mul(hn::Set(I(), row), rows));
    }
    HWY_INLINE Ints in(const VectorPlace& place) const {
        const glm::ivec2 block = place.block();
        return hn::Add(inBlock(place.columnInBlock(), place.rowInBlock()), hn::Set(I(), atPixel(block.x, block.y)));
    }
};

// A quantity that is linear in the picture: its value at a pixel, and its steps to the right and down.
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

// A PlaneEquation in the coordinates of a tile.
class PlaneInTile {
public:
    // from: the pixel at which the plane has the value `first`, in the tile.
    HWY_INLINE PlaneInTile(float first, float column, float row, glm::ivec2 from)
        : m_first(first), m_column(column), m_row(row), m_from(from) {}
    PlaneInTile(const PlaneEquation<float>& plane, Tile tile)
        : PlaneInTile(plane.first, plane.column, plane.row, plane.from - tile.min) {}

    // At the first pixels of blocks; column and row: of these pixels in the tile.
    HWY_INLINE Floats atBlocks(Ints column, Ints row) const {
        const Ints right = hn::Sub(column, hn::Set(I(), m_from.x)), down = hn::Sub(row, hn::Set(I(), m_from.y));
        return hn::Add(all(m_first), sum(right, down));
    }
    float atBlock(int column, int row) const {
        return m_first + (m_column * float(column - m_from.x) + m_row * float(row - m_from.y));
    }
    // Offset from the value at the first pixel of the block, in these columns and rows of the block.
    HWY_INLINE Floats within(Ints column, Ints row) const { return sum(column, row); }
    HWY_INLINE Floats at(const VectorPlace& place) const {
        const glm::ivec2 block = place.block();
        return hn::Add(all(atBlock(block.x, block.y)), within(place.columnInBlock(), place.rowInBlock()));
    }

private:
    HWY_INLINE Floats sum(Ints right, Ints down) const {
        return hn::Add(hn::Mul(all(m_column), hn::ConvertTo(F(), right)),
                       hn::Mul(all(m_row), hn::ConvertTo(F(), down)));
    }
    float m_first, m_column, m_row;
    glm::ivec2 m_from;
};

// The edge functions at the pixels of a vector.
struct EdgesAt {
    Ints outside;   // negative if the pixel is outside an edge
    Floats l1, l2;  // the linear weights of vertices 1 and 2
};

// For each row of blocks in a tile: the range of blocks in which a triangle's edge functions leave pixels inside.
class EdgeRows {
public:
    // For each edge function: its value at the tile's first pixel, not negative where covered, and its steps to the
    // next column and row.
    EdgeRows(const double (&value)[3], const double (&column)[3], const double (&row)[3]) {
        for (int i = 0; i < 3; ++i) {
            // Its largest value in the first block, which is at one of the block's corners; and its step to the next
            // block.
            const double most = value[i] + (std::max(column[i], 0.0) + std::max(row[i], 0.0)) * (kBlock - 1);
            const double right = column[i] * kBlock, down = row[i] * kBlock;
            if (right == 0)
                m_level[m_levels++] = {most, down};
            else if (right > 0)
                m_left[m_lefts++] = {-most / right, -down / right};
            else
                m_right[m_rights++] = {-most / right, -down / right};
        }
    }
    // The range within the blocks [min, max) of row y that the edge functions leave. One or two blocks more, so that
    // rounding loses none.
    std::pair<int, int> blocksInRow(int y, int min, int max) const {
        double low = min, high = max;
        for (int i = 0; i < m_lefts; ++i) low = std::max(low, m_left[i].at(y));
        for (int i = 0; i < m_rights; ++i) high = std::min(high, m_right[i].at(y));
        for (int i = 0; i < m_levels; ++i)
            if (m_level[i].at(y) < 0) return {min, min};
        const int first = int(std::min(low, double(max)));
        return {first, std::max(first, std::min(max, int(std::max(high, double(min))) + 2))};
    }

private:
    struct Line {  // over the rows of blocks
        double first, more;
        double at(int y) const { return first + more * y; }
    };
    Line m_left[3], m_right[3], m_level[3];  // first block; last block; largest value
    int m_lefts = 0, m_rights = 0, m_levels = 0;
};

// The linear weight of a vertex from its edge function: `units` whole units plus `below`. Either units have at most 24
// bits or the unit is 1. inverse: 1 over the area.
HWY_INLINE Floats linearWeight(Ints units, float unit, float below, float inverse) {
    // units times unit is exact, so a fused multiply-add gives the same bits.
    return hn::Mul(hn::MulAdd(hn::ConvertTo(F(), units), all(unit), all(below)), all(inverse));
}

// Edge functions of a triangle of up to some thousands of pixels, in a tile. From pixel to pixel an edge function
// changes by multiples of 2^bits steps². The number of these multiples, rounded down, fits into 32 bits. The rest is
// the same at every pixel.
class MiddleEdges {
public:
    // bits: of the grid that vertices are snapped to.
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
            m_edges[i] = {std::int32_t(high), std::int32_t(-dy), std::int32_t(dx)};
            m_below[i] = float(value - (high << bits) + bias);
        }
    }
    bool fits() const { return m_fits; }          // if false, nothing else of it is valid
    bool isNarrow() const { return m_isNarrow; }  // the number of multiples fits into 24 bits
    // Edge function i in a tile, bias included, is unit() · edge(i) + below(i). inverse(): 1 over the area.
    const PixelFunction& edge(int i) const { return m_edges[i]; }
    float below(int i) const { return m_below[i]; }
    float unit() const { return m_unit; }
    float inverse() const { return m_inverse; }
    HWY_INLINE Floats linear(int i, const VectorPlace& place) const { return linear(m_edges[i].in(place), i); }
    // The linear weight l_i. high: the number of multiples in its edge function.
    HWY_INLINE Floats linear(Ints high, int i) const {
        // The edge function is rounded once: it is a sum of two numbers with at most 24 bits each.
        if (HWY_LIKELY(m_isNarrow)) return linearWeight(high, m_unit, m_below[i], m_inverse);
        const int split = 23 - m_bits;
        const Ints part = hn::And(high, hn::Set(I(), (1 << split) - 1));
        const Ints low = hn::Add(hn::ShiftLeftSame(part, m_bits), hn::Set(I(), std::int32_t(m_below[i])));
        const Floats whole = hn::Add(hn::Mul(hn::ConvertTo(F(), hn::ShiftRightSame(high, split)), all(0x1p23F)),
                                     hn::ConvertTo(F(), low));
        return hn::Mul(whole, all(m_inverse));
    }
    Slope slope(int i, glm::ivec2 first) const {
        const PixelFunction& edge = m_edges[i];
        const float unit = m_unit * m_inverse;
        return {float(edge.atPixel(first.x, first.y)) * unit + m_below[i] * m_inverse, float(edge.column) * unit,
                float(edge.row) * unit};
    }

private:
    PixelFunction m_edges[3]{};
    int m_bits = 1;
    float m_unit = 2, m_inverse = 0, m_below[3]{};
    bool m_fits = true, m_isNarrow = true;  // 24 bits are enough
};

// Edge functions of any larger triangle, in double, from the tile's first pixel on.
class LargeEdges {
public:
    LargeEdges(const RasterTriangle<float>& t, Tile tile) : m_inverse(t.inverseArea2) {
        const auto& c = t.snapped.corners;
        const EdgeFunction edges[3]{{c[1], c[2]}, {c[2], c[0]}, {c[0], c[1]}};
        std::int64_t bits = kSubPixels / 2;
        for (const glm::i64vec2& corner : c) bits |= corner.x | corner.y;
        // Vertices are on a grid, and pixels' centres on a grid of half pixels. So edge functions are multiples of the
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
    bool exact() const { return m_exact; }  // double holds all of its values in the tile
    EdgeRows rows() const {
        const double value[3]{m_value[0] - m_bias[0], m_value[1] - m_bias[1], m_value[2] - m_bias[2]};
        return {value, m_column, m_row};
    }
    HWY_INLINE EdgesAt at(const VectorPlace& place) const {
        const Ints column = place.column(), row = place.row();
        const Floats inverse = all(m_inverse);
#if HWY_TARGET == HWY_SCALAR  // whose vectors of one number have no halves
        const auto here = edges(column, row);
        return {hn::BitCast(I(), here.least), hn::Mul(here.e1, inverse), hn::Mul(here.e2, inverse)};
#else
        const hn::Half<I> half;
        const auto low = edges(hn::LowerHalf(half, column), hn::LowerHalf(half, row));
        const auto high = edges(hn::UpperHalf(half, column), hn::UpperHalf(half, row));
        return {hn::BitCast(I(), hn::Combine(F(), high.least, low.least)),
                hn::Mul(hn::Combine(F(), high.e1, low.e1), inverse),
                hn::Mul(hn::Combine(F(), high.e2, low.e2), inverse)};
#endif
    }

    // The linear weight l_i only.
    HWY_INLINE Floats linear(int i, const VectorPlace& place) const {
#if HWY_TARGET == HWY_SCALAR
        return hn::Mul(hn::DemoteTo(H(), edge(i, place.column(), place.row())), all(m_inverse));
#else
        const hn::Half<I> half;
        const auto low = edge(i, hn::LowerHalf(half, place.column()), hn::LowerHalf(half, place.row()));
        const auto high = edge(i, hn::UpperHalf(half, place.column()), hn::UpperHalf(half, place.row()));
        return hn::Mul(hn::Combine(F(), hn::DemoteTo(H(), high), hn::DemoteTo(H(), low)), all(m_inverse));
#endif
    }

private:
#if HWY_TARGET == HWY_SCALAR
    using H = F;
#else
    using H = hn::Half<F>;  // as many floats as a vector has doubles
#endif
    using D = hn::Rebind<double, H>;
    struct Values {
        hn::Vec<H> least, e1, e2;  // least: negative where an edge does not cover, and never -0
    };
    using HalfInts = hn::Vec<hn::RebindToSigned<H>>;
    // Edge function i, in double.
    HWY_INLINE hn::Vec<D> edge(int i, HalfInts columns, HalfInts rows) const {
        const D d;
        const auto x = hn::PromoteTo(d, columns), y = hn::PromoteTo(d, rows);
        return hn::Add(hn::Add(hn::Set(d, m_value[i]), hn::Mul(y, hn::Set(d, m_row[i]))),
                       hn::Mul(x, hn::Set(d, m_column[i])));
    }
    HWY_INLINE Values edges(HalfInts columns, HalfInts rows) const {
        const D d;
        const auto e0 = edge(0, columns, rows), e1 = edge(1, columns, rows), e2 = edge(2, columns, rows);
        const auto least = hn::Min(hn::Sub(e0, hn::Set(d, m_bias[0])),
                                   hn::Min(hn::Sub(e1, hn::Set(d, m_bias[1])), hn::Sub(e2, hn::Set(d, m_bias[2]))));
        return {hn::DemoteTo(H(), least), hn::DemoteTo(H(), e1), hn::DemoteTo(H(), e2)};
    }
    double m_value[3]{}, m_column[3]{}, m_row[3]{}, m_bias[3]{};
    float m_inverse = 0;
    bool m_exact = true;
};

// The formulas of interpolate(), with the operations in its order.
struct Distances {
    Floats w0, toW1, toW2;
    HWY_INLINE Distances(float first, float second, float third)
        : w0(all(first)), toW1(all(second - first)), toW2(all(third - first)) {}
    HWY_INLINE Distances(Floats first, Floats second, Floats third)
        : w0(first), toW1(hn::Sub(second, first)), toW2(hn::Sub(third, first)) {}
    HWY_INLINE Floats w(Floats l1, Floats l2) const {
        return hn::Add(hn::Add(w0, hn::Mul(l1, toW1)), hn::Mul(l2, toW2));
    }
};
template <bool kPerspective>
HWY_INLINE Floats zOf(Floats w) {
    return kPerspective ? hn::Div(all(1), w) : w;
}

// The index of a pixel of a tile in the tile's blocks.
HWY_INLINE std::size_t placeOf(std::uint32_t x, std::uint32_t y) {
    constexpr std::uint32_t kSide = kBlock;
    return blockAt(int(x / kSide), int(y / kSide)) + std::size_t(y % kSide) * kSide + x % kSide;
}
HWY_INLINE std::size_t placeOf(glm::ivec2 pixel) { return placeOf(std::uint32_t(pixel.x), std::uint32_t(pixel.y)); }

// The lanes inside the picture: blocks reach beyond it if its size is no multiple of 4.
HWY_INLINE Mask within(Tile tile, std::size_t at) {
    const VectorPlace place(at);
    return hn::RebindMask(F(), hn::And(hn::Lt(place.column(), hn::Set(I(), tile.max.x - tile.min.x)),
                                       hn::Lt(place.row(), hn::Set(I(), tile.max.y - tile.min.y))));
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
